// Proofs from the pyramid of depths: every tap of a kernel is blocked, or none is.

uniform sampler2DArray depthPyramid; // (minimum, maximum) of d; texels of level k span 2^(k+1) map texels

struct DepthRange
{
  bool anyBlocker;  // some texel may block
  bool allBlockers; // every texel blocks
  float nearest;    // the least depth met
};

// The largest of the values in this pixel's quad.
//
// llvmpipe fetches the four pixels of a quad from one level, the first one's. Any level proves the
// same, so it does not matter where derivatives are too coarse for this to be exact.
int sameInQuad(int value)
{
  float largest = float(value);
  vec2 side = 1.0 - 2.0 * mod(floor(gl_FragCoord.xy), 2.0);
  largest = max(largest, largest + side.x * dFdx(largest));
  largest = max(largest, largest + side.y * dFdy(largest));
  return int(largest + 0.5);
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
  vec2 size = vec2(textureSize(depthPyramid, 0).xy);
  int most = int(log2(size.x));
  level = min(sameInQuad(min(level, most)), most);
  if (any(lessThan(high, vec2(0.0))) || any(greaterThan(low, vec2(1.0))))
  {
    return range;
  }
  ivec2 levelSize = max(ivec2(size) >> level, ivec2(1));
  float span = float(2 << level) / depthMapSize; // edge of a pyramid texel in (s, t)
  ivec2 first = clamp(ivec2(floor(low / span)), ivec2(0), levelSize - 1);
  ivec2 last = clamp(ivec2(floor(high / span)), ivec2(0), levelSize - 1);
  for (int y = first.y; y <= last.y; ++y)
  {
    for (int x = first.x; x <= last.x; ++x)
    {
      vec2 depths = texelFetch(depthPyramid, ivec3(x, y, int(layer)), level).rg;
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
