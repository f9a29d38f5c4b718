// Between map depths and linear distances along the light's axis.

uniform vec2 depthToLinear;  // positional: 1 / z = a + b d; directional: z = a + b d
uniform int mapDirectional;

float linearDepth(float depth)
{
  float value = depthToLinear.x + depthToLinear.y * depth;
  return mapDirectional == 1 ? value : 1.0 / value;
}

// The map depth of a linear distance, not before the near plane. Needs vtkShadowDepthMap.
float mapDepthOfLinear(float z)
{
  float value = mapDirectional == 1 ? z : 1.0 / z;
  return max((value - depthToLinear.x) / depthToLinear.y, nearestDepth);
}
