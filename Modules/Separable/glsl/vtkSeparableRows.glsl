// Rows of taps: a kernel over the image of the emitter is a column of rows. A tap (x, y) of the
// window [-1, 1]^2 lies at x rowAxis + y columnAxis; the axes are the map's s and t, in either order.
//
// A row is kept in parts of |x|, so that a disk's chord, and not the square's whole row, can be taken
// from it later. The parts end at these shares of the half width; the last one ends at 1.
const float searchNode = 0.7;
const vec2 filterNodes = vec2(0.5, 0.8);
// A tap on a node belongs to the part beyond it, however it was rounded.
const float nodeSlack = 1e-4;

//SoftShadows::Include vtkShadowProof
//SoftShadows::Include vtkShadowFootprint

uniform vec2 rowAxis;
uniform vec2 columnAxis;
uniform float mapLayer;
uniform int searchWidth; // taps along an edge
uniform int filterWidth;

// The kernel's half width per unit of depth difference, along an axis.
float scaleAlong(vec2 axis)
{
  return dot(kernelScale, axis);
}

// Weight of a tap along one axis alone; the product over both axes is tapWeight inside the emitter.
float lineWeight(float tap, vec2 axis)
{
  float window = dot(emitterWindow.xy + emitterWindow.zw * tap, axis);
  return kernelGaussian == 1 ? exp(-2.0 * window * window) : 1.0;
}

// Half the length of the emitter's row at y, in shares of the half width.
float chordAt(float y)
{
  return emitterDisk == 1 ? sqrt(max(1.0 - y * y, 0.0)) : 1.0;
}

// Of a pixel whose row meets nothing; 0 would say that there is no receiver.
const float leastReach = 1e-12;

// How far in front of the receiver blockers are searched, in depth.
float searchReach(MapPoint point)
{
  return footprint == 1 ? blockerReach(point, kernelScale, mapLayer) : max(point.std.z - nearestDepth, 0.0);
}

// How many taps of a row say all that the map holds: no more than taps, four per texel.
int tapsThatMatter(int taps, float halfWidth)
{
  return min(taps, int(ceil(8.0 * halfWidth * depthMapSize)) + 1);
}

// Adds one row of the search, read from the map: sum of the blockers' linear depths, and their
// number, both weighted.
void addSearchRow(MapPoint point, float y, vec2 halfWidth, int taps, inout vec2 blockers)
{
  for (int i = 0; i < taps; ++i)
  {
    vec2 tap = tapCoordinate(i, taps) * rowAxis + y * columnAxis;
    vec2 st = point.std.xy + tap * halfWidth;
    float depth = mapDepth(st, mapLayer);
    if (isBlocker(point, st, depth) && reaches(point, tap * halfWidth, depth))
    {
      blockers += tapWeight(tap) * vec2(linearDepth(depth), 1.0);
    }
  }
}

// Adds one row of the filter, read from the map: the weights of the blocked taps, and of all taps.
void addFilterRow(MapPoint point, float y, vec2 halfWidth, int taps, inout vec2 weights)
{
  bool centerLit = !isBlocked(point, point.std.xy, mapLayer);
  for (int i = 0; i < taps; ++i)
  {
    vec2 tap = tapCoordinate(i, taps) * rowAxis + y * columnAxis;
    float tapShare = tapWeight(tap);
    bool blocked = !facesPoint(point, kernelScale, tap) ||
      blocksFilter(point, tap * halfWidth, centerLit, mapLayer);
    weights += tapShare * vec2(blocked, 1.0);
  }
}
