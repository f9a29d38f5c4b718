//VTK::System::Dec
//VTK::Output::Dec

// The one division at the end. Pixels that a step before proved lit, or those that tiles filtered.

uniform sampler2DArray kernelShapes; // (variance, state)
uniform sampler2DArray predictions;  // (s, t, texel sizes)
uniform sampler2DArray sums;         // (V A, A, area under tiles)
uniform float windowArea; // weighted area of a kernel of half extents 1
uniform float weight;
uniform int part; // VIRTUAL_PART_...: which pixels are drawn
uniform int debugView;

// Powers of two below 1 as shades: 1 is white, 2^-16 black.
float shadeOf(float value)
{
  return clamp(1.0 + log2(max(value, 1e-30)) / 16.0, 0.0, 1.0);
}

// What tiles do not cover of a kernel lies beyond the map's border, where nothing blocks.
float areaBeyondMap(vec3 variance, vec2 st, float covered)
{
  vec2 reach = sqrt(2.0 * variance.xz);
  if (all(greaterThan(st - reach, vec2(0.0))) && all(lessThan(st + reach, vec2(1.0))))
  {
    return 0.0;
  }
  float determinant = max(variance.x * variance.z - variance.y * variance.y, 0.0);
  float area = windowArea * sqrt(determinant);
  return max(area - covered, 0.0);
}

void main()
{
  ivec3 pixel = ivec3(ivec2(gl_FragCoord.xy), 0);
  vec4 shape = texelFetch(kernelShapes, pixel, 0);
  bool lit = shape.w < VIRTUAL_PENUMBRA;
  if ((part == VIRTUAL_PART_LIT && !lit) || (part == VIRTUAL_PART_PENUMBRA && lit))
  {
    discard;
  }
  float inFront = shape.w - (lit ? VIRTUAL_LIT : VIRTUAL_PENUMBRA);
  float visibility = inFront;
  if (!lit)
  {
    vec3 total = texelFetch(sums, pixel, 0).xyz;
    vec4 prediction = texelFetch(predictions, pixel, 0);
    if (total.y > 0.0)
    {
      float missing = areaBeyondMap(shape.xyz, prediction.xy, total.z);
      visibility = min((total.x + missing) / (total.y + missing), inFront);
    }
    if (debugView == VIRTUAL_DEBUG_RESOLUTION)
    {
      visibility = shadeOf(min(prediction.z, prediction.w));
    }
    else if (debugView == VIRTUAL_DEBUG_KERNEL)
    {
      visibility = shadeOf(sqrt(max(shape.x, shape.z)));
    }
  }
  gl_FragData[0] = vec4(weight * visibility);
}
