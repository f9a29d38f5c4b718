//VTK::System::Dec
//VTK::Output::Dec

// Kernels look beyond the cell that their pixel lies in: every cell takes over the wishes of those
// that reach into it, along one axis at a time.

uniform sampler2DArray wishes; // (texel sizes, minus half extents)
uniform int axis;
uniform int gridSize;

void main()
{
  ivec2 cell = ivec2(gl_FragCoord.xy);
  vec4 least = vec4(VIRTUAL_UNUSED, VIRTUAL_UNUSED, 0.0, 0.0);
  for (int i = 0; i < gridSize; ++i)
  {
    ivec2 from = axis == 0 ? ivec2(i, cell.y) : ivec2(cell.x, i);
    vec4 wish = texelFetch(wishes, ivec3(from, 0), 0);
    float between = float(abs(i - cell[axis]) - 1); // cells
    if (between < -wish[2 + axis] * float(gridSize))
    {
      least = min(least, wish);
    }
  }
  gl_FragData[0] = least;
}
