// Which points an emitter serves: in front of it, inside the light's cone, inside its cube face.

uniform mat4 viewToApex;      // view coordinates to the emitter's axes at the light's centre
uniform int lightDirectional;
uniform int lightOneSided;    // a rectangle or a disk shines to its front only
uniform float lightConeCosine; // -2 without a cone
uniform int lightFaceAxis;    // -1, or which axis of the cube this face of an omni light looks along

bool lightReaches(vec3 positionVs)
{
  if (lightDirectional == 1)
  {
    return true;
  }
  vec3 p = (viewToApex * vec4(positionVs, 1.0)).xyz;
  if (lightFaceAxis >= 0)
  {
    // Ties go to the lower axis: x of face k lies along axis k + 2, y along axis k + 1 (modulo 3).
    bool insideX = lightFaceAxis == 0 ? p.z >= abs(p.x) : p.z > abs(p.x);
    bool insideY = lightFaceAxis == 2 ? p.z > abs(p.y) : p.z >= abs(p.y);
    return insideX && insideY;
  }
  if (lightOneSided == 1 && p.z <= 0.0)
  {
    return false;
  }
  return lightConeCosine < -1.0 || p.z >= lightConeCosine * length(p);
}
