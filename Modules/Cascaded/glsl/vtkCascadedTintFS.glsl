//VTK::System::Dec
//VTK::Output::Dec

// A colour per cascade, by which the picture is multiplied: red, green, blue, yellow, near to far.

//SoftShadows::Include vtkShadowReceiver

uniform vec2 fadeIns[4];
uniform vec2 fadeOuts[4];
uniform int cascadeCount;
uniform vec2 origin; // of the viewport in the window

void main()
{
  Receiver receiver;
  if (!loadReceiver(ivec2(gl_FragCoord.xy - origin), receiver))
  {
    discard;
  }
  vec3 tints[4] = vec3[4](
    vec3(1.0, 0.55, 0.55), vec3(0.55, 1.0, 0.55), vec3(0.6, 0.65, 1.0), vec3(1.0, 1.0, 0.5));
  float depth = -receiver.positionVs.z;
  vec3 tint = vec3(0.0);
  for (int i = 0; i < cascadeCount; ++i)
  {
    float share = smoothstep(fadeIns[i].x, fadeIns[i].y, depth) *
      (1.0 - smoothstep(fadeOuts[i].x, fadeOuts[i].y, depth));
    tint += share * tints[i];
  }
  gl_FragData[0] = vec4(tint, 1.0);
}
