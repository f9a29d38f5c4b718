//VTK::System::Dec
//VTK::Output::Dec

// Where on the map the kernels of a block of pixels lie.

uniform sampler2DArray kernelShapes; // (variance, state)
uniform sampler2DArray predictions;  // (s, t, texel sizes)

void main()
{
  ivec2 size = textureSize(kernelShapes, 0).xy;
  ivec2 first = VIRTUAL_BLOCK * ivec2(gl_FragCoord.xy);
  ivec2 end = min(first + VIRTUAL_BLOCK, size);
  vec4 bounds = vec4(VIRTUAL_NOWHERE);
  for (int y = first.y; y < end.y; ++y)
  {
    for (int x = first.x; x < end.x; ++x)
    {
      vec4 shape = texelFetch(kernelShapes, ivec3(x, y, 0), 0);
      if (shape.w >= VIRTUAL_PENUMBRA)
      {
        vec2 st = texelFetch(predictions, ivec3(x, y, 0), 0).xy;
        // A leaning kernel reaches at most the root of 2 farther than its variance says.
        vec2 reach = sqrt(2.0 * shape.xz);
        bounds = min(bounds, vec4(st - reach, -st - reach));
      }
    }
  }
  gl_FragData[0] = bounds;
}
