//VTK::System::Dec
//VTK::Output::Dec

// Visibility by marching rays through one depth map: from the nearest depth that any texel of the
// kernel has to the receiver, towards points of the light. In map coordinates the ray to the point
// at window coordinates e is a straight line, st(d) = st_q + e kernelScale (d_q - d).

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowDepthMap
//SoftShadows::Include vtkShadowProof

uniform mat4 viewToMap;
uniform vec2 kernelScale;
uniform float mapLayer;
uniform float weight;
uniform vec4 rays[MARCHED_MAXIMUM_RAYS]; // window coordinates, weight, jitter of the steps in [0, 1)
uniform int rayCount;
uniform int firstRays; // if these agree, the rest is not walked
uniform int stepCount;
uniform float thickness; // of a blocker, in steps

// 1 if a texel blocks the ray to e. The steps are even in the square root of the light's width, so
// that they are fine where contacts are. A step only finds a surface nearby; whether the ray meets it is
// asked where the ray is as deep as the surface, or penumbrae come out too narrow.
float marchRay(MapPoint point, vec2 e, float jitter, float reach)
{
  float range = sqrt(reach);
  float previous = 0.0;
  // The first step lies before the nearest depth, so that every surface lies between two steps.
  for (int i = 0; i <= stepCount; ++i)
  {
    float root = range * (float(stepCount + 1 - i) - jitter) / float(stepCount);
    float next = max(root - range / float(stepCount), 0.0);
    float distance = root * root; // to the receiver, in d
    float gap = thickness * max(previous - distance, distance - next * next);
    previous = distance;
    vec2 st = point.std.xy + e * kernelScale * distance;
    float depth = mapDepth(st, mapLayer);
    if (abs(point.std.z - distance - depth) <= gap)
    {
      vec2 meeting = point.std.xy + e * kernelScale * max(point.std.z - depth, 0.0);
      float there = mapDepth(meeting, mapLayer);
      if (abs(there - depth) <= gap && isBlocker(point, meeting, there))
      {
        return 1.0;
      }
    }
  }
  return 0.0;
}

void main()
{
  Receiver receiver;
  loadReceiver(ivec2(gl_FragCoord.xy), receiver);
  MapPoint point = toMap(viewToMap, receiver.positionVs, receiver.normalVs);
  // Nothing lies in front of the nearest depth within the kernel.
  vec2 widest = kernelScale * max(point.std.z, 0.0);
  DepthRange depths = searchPyramid(point, widest, mapLayer);
  float reach = max(point.std.z - depths.nearest, 0.0);
  float blocked = 0.0;
  float total = 0.0;
  for (int i = 0; i < rayCount; ++i)
  {
    if (i == firstRays && (blocked == 0.0 || blocked == total))
    {
      break;
    }
    blocked += rays[i].z *
      (facesPoint(point, kernelScale, rays[i].xy) ? marchRay(point, rays[i].xy, rays[i].w, reach) : 1.0);
    total += rays[i].z;
  }
  gl_FragData[0] = vec4(weight * (1.0 - blocked / total));
}
