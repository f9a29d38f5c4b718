//VTK::System::Dec
//VTK::Output::Dec

// Per tile of pixels, the mean square of the difference between two visibilities. Few pixels with a
// value count as a quarter of the tile, so that a single one decides nothing.

uniform sampler2DArray base; // negative: no value
uniform sampler2DArray held;
uniform sampler2DArray sum;
uniform float layer;
uniform float share; // of the sum

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
      if (texelFetch(base, pixel, 0).r > -0.5)
      {
        float change = share * texelFetch(sum, pixel, 0).r - texelFetch(held, pixel, 0).r;
        squares += change * change;
        count += 1.0;
      }
    }
  }
  float least = float(SOFT_SHADOW_TILE * SOFT_SHADOW_TILE) / 4.0;
  gl_FragData[0] = vec4(squares / max(count, least));
}
