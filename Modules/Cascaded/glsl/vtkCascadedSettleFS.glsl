//VTK::System::Dec
//VTK::Output::Dec

// Joins what a level added to what was known, and tells whether the visibility has settled. On the coarse
// levels, whose points are too few to tell a penumbra's error by a change, all points must agree, and
// the neighbours' with them; later it and its neighbours must not have changed by more than the tolerance.

uniform sampler2DArray state; // (visibility, 1 if it has settled) after the level before
uniform sampler2DArray added; // (what the level added, more than 0 where it was drawn)
uniform int level;
uniform int firstLevel;  // the first on which a pixel can settle
uniform int changeLevel; // the first on which it settles by its change
uniform int reach;   // how far the neighbours are, in pixels
uniform float keep;  // what the earlier points' weights are multiplied by
uniform float weight; // of all points: what is fully lit
uniform float tolerance;

// By how much the level changed a pixel, or how far its points are from agreeing on value.
float change(ivec3 pixel, float value)
{
  vec2 now = texelFetch(added, pixel, 0).rg;
  if (now.g == 0.0)
  {
    return 0.0;
  }
  float before = level > 0 ? texelFetch(state, pixel, 0).r : 0.0;
  float after = keep * before + now.r;
  return abs(after - (level < changeLevel ? value : before));
}

// The largest change around a pixel.
float changeAround(ivec3 pixel, float value)
{
  ivec3 last = textureSize(added, 0) - 1;
  float largest = change(pixel, value);
  for (int y = -1; y <= 1; ++y)
  {
    for (int x = -1; x <= 1; ++x)
    {
      largest = max(largest, change(clamp(pixel + reach * ivec3(x, y, 0), ivec3(0), last), value));
    }
  }
  return largest;
}

void main()
{
  ivec3 pixel = ivec3(gl_FragCoord.xy, 0);
  vec2 known = level > 0 ? texelFetch(state, pixel, 0).rg : vec2(0.0);
  if (known.g == 0.0)
  {
    known.r = keep * known.r + texelFetch(added, pixel, 0).r;
    // Lit or hidden, whichever is nearer.
    float agreed = known.r < 0.5 * weight ? 0.0 : weight;
    // Rounding in the sums must not keep a pixel from settling.
    float allowed = weight * ((level < changeLevel ? 0.0 : tolerance) + 1e-4);
    known.g = level >= firstLevel && changeAround(pixel, agreed) <= allowed ? 1.0 : 0.0;
  }
  gl_FragData[0] = vec4(known, 0.0, 0.0);
}
