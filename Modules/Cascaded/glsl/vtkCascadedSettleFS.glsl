//VTK::System::Dec
//VTK::Output::Dec

// Joins what a level added to what was known, and tells whether the visibility has settled: on the
// first level if all points agree, then if the level changed it by no more than the tolerance.

uniform sampler2DArray state;
uniform sampler2DArray added;
uniform int level;
uniform float keep; // what the earlier points' weights are multiplied by
uniform float weight; // of all points: what is fully lit
uniform float tolerance;

void main()
{
  ivec3 pixel = ivec3(gl_FragCoord.xy, 0);
  vec2 known = level > 0 ? texelFetch(state, pixel, 0).rg : vec2(0.0);
  if (known.g == 0.0)
  {
    float before = known.r;
    known.r = keep * before + texelFetch(added, pixel, 0).r;
    // Rounding in the sums must not keep a pixel from settling.
    float allowed = weight * (tolerance + 1e-4);
    bool settled = level == 0 ? min(known.r, weight - known.r) <= 1e-4 * weight
                              : abs(known.r - before) <= allowed;
    known.g = settled ? 1.0 : 0.0;
  }
  gl_FragData[0] = vec4(known, 0.0, 0.0);
}
