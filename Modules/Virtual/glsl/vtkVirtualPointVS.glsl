//VTK::System::Dec

// Step 4: one point per pixel of the screen, made from nothing but its number in the row and the row's,
// falls into the cell of the grid that the pixel lies in on the map. Of the pixels of a block that lie in
// one cell the first draws the least of their wishes, and the others nothing.

uniform sampler2DArray kernelShapes; // (variance, state)
uniform sampler2DArray predictions;  // (s, t, texel sizes)
uniform int gridSize;
uniform int blockSize; // edge of a block; 1: every pixel draws

flat out vec4 wish; // texel sizes, and minus the half extents of the kernel in (s, t)

// Where a pixel lies; (-1, -1) if it asks for nothing or lies beside the screen, as of the last blocks.
ivec2 cellOf(ivec2 pixel)
{
  if (any(greaterThanEqual(pixel, textureSize(kernelShapes, 0).xy)))
  {
    return ivec2(-1);
  }
  if (texelFetch(kernelShapes, ivec3(pixel, 0), 0).w < VIRTUAL_PENUMBRA)
  {
    return ivec2(-1);
  }
  // Receivers beside the map may still be reached by what is on it.
  vec2 st = texelFetch(predictions, ivec3(pixel, 0), 0).xy;
  return ivec2(clamp(floor(st * float(gridSize)), vec2(0.0), vec2(gridSize - 1)));
}

vec4 wishOf(ivec2 pixel)
{
  // A leaning kernel reaches at most the root of 2 farther than its variance says.
  vec2 reach = sqrt(2.0 * texelFetch(kernelShapes, ivec3(pixel, 0), 0).xz);
  return vec4(texelFetch(predictions, ivec3(pixel, 0), 0).zw, -reach);
}

// The place of pixel i of a block, row by row.
ivec2 placeOf(int i)
{
  return ivec2(i % blockSize, i / blockSize);
}

void main()
{
  gl_PointSize = 1.0;
  wish = vec4(0.0);
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // nowhere
  ivec2 pixel = ivec2(gl_VertexID, gl_InstanceID);
  ivec2 cell = cellOf(pixel);
  ivec2 block = pixel / blockSize * blockSize;
  ivec2 inBlock = pixel - block;
  int number = inBlock.y * blockSize + inBlock.x;
  bool isFirst = cell.x >= 0;
  // The nearest first: most lie in the same cell.
  for (int i = number - 1; i >= 0 && isFirst; --i)
  {
    isFirst = cellOf(block + placeOf(i)) != cell;
  }
  if (!isFirst)
  {
    return;
  }
  wish = wishOf(pixel);
  for (int i = number + 1; i < blockSize * blockSize; ++i)
  {
    ivec2 other = block + placeOf(i);
    if (cellOf(other) == cell)
    {
      wish = min(wish, wishOf(other));
    }
  }
  gl_Position = vec4(2.0 * (vec2(cell) + 0.5) / float(gridSize) - 1.0, 0.0, 1.0);
}
