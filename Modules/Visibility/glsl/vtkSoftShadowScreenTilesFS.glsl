//VTK::System::Dec
//VTK::Output::Dec

// The least and the greatest share of the light in front of receivers that they see, in a tile of the
// screen; (2, -2) where there is none.

uniform sampler2DArray source;
uniform sampler2DArray known; // where the source has no value
uniform int tileSize;

void main()
{
  ivec2 low = ivec2(gl_FragCoord.xy) * tileSize;
  ivec2 high = min(low + tileSize, textureSize(source, 0).xy);
  vec2 range = vec2(2.0, -2.0);
  for (int y = low.y; y < high.y; ++y)
  {
    for (int x = low.x; x < high.x; ++x)
    {
      vec3 sums = texelFetch(source, ivec3(x, y, 0), 0).rgb;
      if (sums.r > 0.0)
      {
        float visibility = sums.g / sums.r;
        range = vec2(min(range.x, visibility), max(range.y, visibility));
      }
      else if (sums.r < -0.5)
      {
        float visibility = texelFetch(known, ivec3(x, y, 0), 0).r;
        range = visibility < -0.5 ? range : vec2(min(range.x, visibility), max(range.y, visibility));
      }
    }
  }
  gl_FragData[0] = vec4(range, 0.0, 0.0);
}
