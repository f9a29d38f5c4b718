// Proofs from the pyramid of depths: every tap of a kernel is blocked, or none is.

// (minimum, maximum) of d; texels of level k span 2^(k+1) map texels. All levels lie in one image, the
// finest at the left and the others in a column beside it: drivers may fetch the four pixels of a quad
// from one level of a texture, and then no pixel may have a level of its own.
uniform sampler2DArray depthPyramid;

struct DepthRange
{
  bool anyBlocker;  // some texel may block
  bool allBlockers; // every texel blocks
  float nearest;    // the least depth met
};

// Texels along an edge of the finest level, a power of two, and the number of the coarsest level.
int pyramidSize()
{
  return textureSize(depthPyramid, 0).y;
}

int coarsestLevel()
{
  return int(log2(float(pyramidSize())) + 0.5);
}

// Where a level lies in the image.
ivec2 levelCorner(int level)
{
  int size = pyramidSize();
  return level == 0 ? ivec2(0) : ivec2(size, size - ((2 * size) >> level));
}

// Compares the receiver's plane with all map texels in the rectangle center +- halfWidth.
DepthRange searchPyramid(MapPoint point, vec2 halfWidth, float layer)
{
  // Half a texel more on each side: a tap asks the four texels around it.
  float texel = 0.5 / depthMapSize;
  vec2 low = point.std.xy - halfWidth - texel;
  vec2 high = point.std.xy + halfWidth + texel;
  DepthRange range = DepthRange(false, all(greaterThan(low, vec2(0.0))) && all(lessThan(high, vec2(1.0))), emptyDepth);
  // The finest level on which the rectangle touches at most 4 texels along each axis.
  vec2 extent = (high - low) * depthMapSize;
  int level = int(max(ceil(log2(max(max(extent.x, extent.y), 1.0) / 3.0)) - 1.0, 0.0));
  level = min(level, coarsestLevel());
  if (any(lessThan(high, vec2(0.0))) || any(greaterThan(low, vec2(1.0))))
  {
    return range;
  }
  ivec2 corner = levelCorner(level);
  int lastTexel = (pyramidSize() >> level) - 1;
  float span = float(2 << level) / depthMapSize; // edge of a pyramid texel in (s, t)
  ivec2 first = clamp(ivec2(floor(low / span)), ivec2(0), ivec2(lastTexel));
  ivec2 last = clamp(ivec2(floor(high / span)), ivec2(0), ivec2(lastTexel));
  for (int y = first.y; y <= last.y; ++y)
  {
    for (int x = first.x; x <= last.x; ++x)
    {
      vec2 depths = texelFetch(depthPyramid, ivec3(corner + ivec2(x, y), int(layer)), 0).rg;
      // The plane over the part of the texel that the rectangle covers.
      vec2 from = max(vec2(x, y) * span, low) - texel;
      vec2 to = min(vec2(x + 1, y + 1) * span, high) + texel;
      float middle = planeDepth(point, 0.5 * (from + to)) - point.bias;
      float reach = dot(abs(point.gradient), 0.5 * (to - from));
      float nearest = min(point.std.z, emptyDepth);
      range.anyBlocker = range.anyBlocker || depths.x < min(middle + reach, nearest);
      range.allBlockers = range.allBlockers && depths.y < min(middle - reach, nearest);
      range.nearest = min(range.nearest, depths.x);
    }
  }
  return range;
}

// How far in front of the receiver, in depth, the nearest texel within the light's image lies: nothing
// that blocks is farther away.
float blockerReach(MapPoint point, vec2 kernelScale, float layer)
{
  // Nothing lies in front of the near plane.
  float nearest = searchPyramid(point, kernelScale * max(point.std.z - nearestDepth, 0.0), layer).nearest;
  return max(point.std.z - nearest, 0.0);
}

// 1: lit, 0: blocked, -1: neither is proved.
//
// A blocker at depth d_o matters within kernelScale (d_q - d_o) of the receiver; none lies in front
// of the near plane, nor, after the first look, in front of the nearest depth that was met.
float proveVisibility(MapPoint point, vec2 kernelScale, float layer)
{
  // What lies behind the receiver's plane is blocked by the surface itself: all of the light, some of
  // it, or none. The search below is for planes that face the centre.
  bool oneSide = dot(abs(point.gradient), kernelScale) < 1.0;
  if (!point.facesCenter)
  {
    return oneSide ? 0.0 : -1.0;
  }
  float lit = oneSide ? 1.0 : -1.0;
  vec2 widest = kernelScale * max(point.std.z - nearestDepth, 0.0);
  DepthRange range = searchPyramid(point, widest, layer);
  if (!range.anyBlocker)
  {
    return lit;
  }
  if (range.allBlockers)
  {
    return 0.0;
  }
  vec2 width = kernelScale * max(point.std.z - range.nearest, 0.0);
  DepthRange inner = searchPyramid(point, width, layer);
  if (!inner.anyBlocker)
  {
    return lit;
  }
  // A kernel much smaller than the search could slip between the search's taps.
  return inner.allBlockers && all(greaterThanEqual(width, widest / 7.0)) ? 0.0 : -1.0;
}
