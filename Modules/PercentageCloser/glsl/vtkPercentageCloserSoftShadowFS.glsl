//VTK::System::Dec
//VTK::Output::Dec

// Percentage-closer soft shadows (Fernando 2005): blocker search, penumbra estimate, variable filter.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowDepthMap
//SoftShadows::Include vtkShadowFootprint
//SoftShadows::Include vtkShadowCrease
//SoftShadows::Include vtkShadowKernel
//SoftShadows::Include vtkShadowBlocker
//SoftShadows::Include vtkShadowProof

uniform mat4 viewToMap;
uniform float mapLayer;
uniform int searchWidth; // taps along an edge
uniform int filterWidth;
uniform float weight;

// The mean linear depth of the taps that block, as a map depth; infinitelyFar if none does.
float searchBlockers(MapPoint point, vec2 halfWidth)
{
  float sum = 0.0;
  float total = 0.0;
  for (int y = 0; y < searchWidth; ++y)
  {
    for (int x = 0; x < searchWidth; ++x)
    {
      vec2 tap = vec2(tapCoordinate(x, searchWidth), tapCoordinate(y, searchWidth));
      vec2 st = point.std.xy + tap * halfWidth;
      float depth = mapDepth(st, mapLayer);
      if (isBlocker(point, st, depth) && reaches(point, tap * halfWidth, depth))
      {
        float tapShare = tapWeight(tap);
        sum += tapShare * linearDepth(depth);
        total += tapShare;
      }
    }
  }
  return total > 0.0 ? mapDepthOfLinear(sum / total) : infinitelyFar;
}

float filterVisibility(MapPoint point, vec2 halfWidth)
{
  bool centerLit = !isBlocked(point, point.std.xy, mapLayer);
  float lit = 0.0;
  float total = 0.0;
  for (int y = 0; y < filterWidth; ++y)
  {
    for (int x = 0; x < filterWidth; ++x)
    {
      vec2 tap = vec2(tapCoordinate(x, filterWidth), tapCoordinate(y, filterWidth));
      float tapShare = tapWeight(tap);
      bool blocked = !facesPoint(point, kernelScale, tap) ||
        blocksFilter(point, tap * halfWidth, centerLit, mapLayer);
      lit += blocked ? 0.0 : tapShare;
      total += tapShare;
    }
  }
  return lit / total;
}

void main()
{
  Receiver receiver;
  loadReceiver(ivec2(gl_FragCoord.xy), receiver);
  MapPoint point = toMap(viewToMap, receiver);
  // The paper's search is as wide as the light on the near plane. With the footprint nothing
  // counts that lies outside the light's image at the nearest depth, and taps there are of no use.
  float reachable =
    footprint == 1 ? blockerReach(point, kernelScale, mapLayer) : max(point.std.z - nearestDepth, 0.0);
  float blocker = searchBlockers(point, kernelScale * reachable);
  bool facesAll = point.facesCenter && dot(abs(point.gradient), kernelScale) < 1.0;
  float visibility = 1.0;
  bool isBehind = blocker < infinitelyFar;
  if (isBehind || !facesAll)
  {
    float reach = isBehind ? max(point.std.z - blocker, 0.0) : 0.0;
    visibility = filterVisibility(point, kernelScale * reach);
  }
  if (visibility > 0.0 && isInCrease(point, kernelScale, creaseReach, mapLayer))
  {
    visibility = 0.0;
  }
  gl_FragData[0] = vec4(weight * visibility);
}
