// What of a depth map rays from the receiver to the light can meet. Needs vtkShadowDepthMap.

uniform vec2 kernelScale;
uniform int footprint; // 1: leave out what no ray from the receiver to the light meets

// Of a filter's tap: the light's image there may be smaller by this than the filter. Half of it would
// leave out the far ends of aslant blockers.
const float filterSlack = 1.5;

// Whether a blocker of that depth, so far from the receiver in the map, lies in the light's image there.
bool reaches(MapPoint point, vec2 offset, float depth)
{
  vec2 image = kernelScale * (point.std.z - depth) + 1.0 / depthMapSize;
  return footprint == 0 || all(lessThanEqual(abs(offset), image));
}

// Whether a tap of a filter blocks. Where the light's centre sees the receiver, it sees what is nearby
// and steep as well: the other side of a concave edge, most of which no ray to the light meets.
bool blocksFilter(MapPoint point, vec2 offset, bool centerLit, float layer)
{
  vec2 st = point.std.xy + offset;
  float depth = mapDepth(st, layer);
  vec2 image = filterSlack * kernelScale * (point.std.z - depth);
  bool isBeside = centerLit && footprint == 1 && any(greaterThan(abs(offset), image));
  return !isBeside && blocksAt(point, st, depth, layer);
}
