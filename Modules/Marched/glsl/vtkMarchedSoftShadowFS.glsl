//VTK::System::Dec
//VTK::Output::Dec

// Visibility by marching rays through one depth map: from the nearest depth that any texel of the
// kernel has to the receiver, towards points of the light. In map coordinates the ray to the point
// at window coordinates e is a straight line, st(d) = st_q + e kernelScale (d_q - d).

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowDepthMap
//SoftShadows::Include vtkShadowCrease
//SoftShadows::Include vtkShadowProof

uniform mat4 viewToMap;
uniform vec2 kernelScale;
uniform float mapLayer;
uniform float weight; // of the emitter, if there is no pattern
uniform sampler2D rays; // a row per pixel of the pattern: window coordinates, weight, jitter of the steps in [0, 1)
uniform int pattern;    // edge of the pattern in pixels
uniform int rayCount;
uniform int firstRays; // if these agree, the rest is not walked
uniform int stepCount;
uniform float thickness; // of a blocker, in steps

// How much further than gap a surface may fall between the two looks and still be the same. Steep
// sides of solid bodies do; with less, rays slip out through them and round bodies leak.
const float continuity = 4.0;

// Distance of a step to the receiver, in d. The steps are even in the square root of the light's width, so
// that they are fine where contacts are; the first lies at the nearest depth, so that every surface
// lies between two steps.
float stepDistance(float range, float i)
{
  float root = range * clamp((float(stepCount) + 1.0 - i) / float(stepCount), 0.0, 1.0);
  return root * root;
}

// 1 if a texel blocks the ray to e. A step only finds a surface nearby; whether the ray meets it is
// asked where the ray is as deep as the surface, or penumbrae come out too narrow.
float marchRay(MapPoint point, vec2 e, float jitter, float reach)
{
  float range = sqrt(reach);
  float previous = 0.0;
  float distance = stepDistance(range, jitter);
  for (int i = 0; i <= stepCount;)
  {
    float depth;
    float gap;
    float rise = 0.0;
    bool isNear = false;
    // A loop of its own: few steps find something, and what is asked then costs as much as a step.
    for (; i <= stepCount && !isNear; ++i)
    {
      float next = stepDistance(range, float(i + 1) + jitter);
      gap = thickness * max(previous - distance, distance - next);
      depth = mapDepth(point.std.xy + e * kernelScale * distance, mapLayer);
      rise = point.std.z - depth;
      isNear = rise <= reach && abs(rise - distance) <= gap;
      previous = distance;
      distance = next;
    }
    if (isNear)
    {
      vec2 meeting = point.std.xy + e * kernelScale * max(rise, 0.0);
      float there = mapDepth(meeting, mapLayer);
      if (abs(there - depth) <= continuity * gap && blocksAt(point, meeting, there, mapLayer))
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
  MapPoint point = toMap(viewToMap, receiver);
  // Nothing lies in front of the nearest depth within the kernel; nor, on a second look, in front of the
  // nearest one where the light's image is as wide as it is there.
  DepthRange depths = searchPyramid(point, kernelScale * max(point.std.z - nearestDepth, 0.0), mapLayer);
  float reach = max(point.std.z - depths.nearest, 0.0);
  if (depths.anyBlocker)
  {
    depths = searchPyramid(point, kernelScale * reach, mapLayer);
    reach = max(point.std.z - depths.nearest, 0.0);
  }
  if (isInCrease(point, kernelScale, creaseReach, mapLayer))
  {
    gl_FragData[0] = pattern > 1 ? vec4(0.0, 1.0, 0.0, 0.0) : vec4(0.0);
    return;
  }
  bool allFaces = point.facesCenter && dot(abs(point.gradient), kernelScale) < 1.0;
  if (allFaces && !depths.anyBlocker)
  {
    // Lit, whether or not it was proved before: the filter must not tell the difference.
    gl_FragData[0] = pattern > 1 ? vec4(-1.0) : vec4(weight);
    return;
  }
  ivec2 phase = ivec2(gl_FragCoord.xy) % pattern;
  int row = phase.x + pattern * phase.y;
  float total = 0.0;
  float facing = 0.0;
  float seen = 0.0;
  for (int i = 0; i < rayCount; ++i)
  {
    if (i == firstRays && (seen == 0.0 || seen == total))
    {
      break;
    }
    vec4 ray = texelFetch(rays, ivec2(i, row), 0);
    total += ray.z;
    if (allFaces || facesPoint(point, kernelScale, ray.xy))
    {
      facing += ray.z;
      seen += ray.z * (1.0 - marchRay(point, ray.xy, ray.w, reach));
    }
  }
  gl_FragData[0] = pattern > 1
    ? vec4(facing > 0.0 ? seen / facing : 0.0, facing / total, 0.0, 0.0)
    : vec4(weight * seen / total);
}
