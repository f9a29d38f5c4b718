//VTK::System::Dec
//VTK::Output::Dec

// Per tile of pixels, the mean square of the difference between two visibilities, or the mean product of
// the differences of both halves of their points: what is by chance in one half is not in the other, so
// that in the mean the square of what is common is left. How well that is known is chance too, so half
// of the chance counts. Few pixels with a value count as a quarter of
// the tile, so that a single one decides nothing. Pixels at silhouettes
// are left out: which of two surfaces they show hangs on a hair, and no mean over a light tells.

//SoftShadows::Include vtkShadowReceiver

uniform sampler2DArray base; // negative: no value
uniform sampler2DArray held;
uniform sampler2DArray sum;
uniform sampler2DArray halfMean; // means of the first halves of sum and held
uniform sampler2DArray heldHalfMean;
uniform float layer;
uniform float share; // of the sum
uniform bool commonOnly; // the product of the halves' changes

// 1 / depth, which is an affine function of the pixel on any plane; 0 where there is no surface.
float inverseDepth(ivec2 pixel)
{
  vec4 position = texelFetch(receiverPosition, pixel, 0);
  return markOf(position) == 0.0 ? 0.0 : -1.0 / position.z;
}

// Whether 1 / depth breaks along the line through the pixel and its neighbours to both sides.
bool breaks(ivec2 pixel, ivec2 direction, ivec2 size)
{
  ivec2 low = min(pixel - direction, pixel + direction);
  ivec2 high = max(pixel - direction, pixel + direction);
  if (any(lessThan(low, ivec2(0))) || any(greaterThanEqual(high, size)))
  {
    return false;
  }
  float before = inverseDepth(pixel - direction);
  float after = inverseDepth(pixel + direction);
  float here = inverseDepth(pixel);
  return before == 0.0 || after == 0.0 || abs(0.5 * (before + after) / here - 1.0) > 0.01;
}

bool isSilhouette(ivec2 pixel, ivec2 size)
{
  return breaks(pixel, ivec2(1, 0), size) || breaks(pixel, ivec2(0, 1), size) ||
    breaks(pixel, ivec2(1, 1), size) || breaks(pixel, ivec2(1, -1), size);
}

void main()
{
  ivec2 size = textureSize(base, 0).xy;
  ivec2 low = ivec2(gl_FragCoord.xy) * SOFT_SHADOW_TILE;
  ivec2 high = min(low + SOFT_SHADOW_TILE, size);
  float squares = 0.0;
  float count = 0.0;
  for (int y = low.y; y < high.y; ++y)
  {
    for (int x = low.x; x < high.x; ++x)
    {
      ivec3 pixel = ivec3(x, y, int(layer));
      if (texelFetch(base, pixel, 0).r > -0.5 && !isSilhouette(pixel.xy, size))
      {
        float change = share * texelFetch(sum, pixel, 0).r - texelFetch(held, pixel, 0).r;
        float first =
          commonOnly ? texelFetch(halfMean, pixel, 0).r - texelFetch(heldHalfMean, pixel, 0).r : change;
        squares += 0.5 * (change * change + first * (2.0 * change - first));
        count += 1.0;
      }
    }
  }
  float least = float(SOFT_SHADOW_TILE * SOFT_SHADOW_TILE) / 4.0;
  gl_FragData[0] = vec4(squares / max(count, least));
}
