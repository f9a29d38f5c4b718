//VTK::System::Dec

// Step 4: one point per pixel of the screen, made from nothing but its number in the row and the row's,
// falls into the cell of the grid that the pixel lies in on the map.

uniform sampler2DArray kernelShapes; // (variance, state)
uniform sampler2DArray predictions;  // (s, t, texel sizes)
uniform float gridSize;

flat out vec4 wish; // texel sizes, and minus the half extents of the kernel in (s, t)

void main()
{
  gl_PointSize = 1.0;
  ivec3 pixel = ivec3(gl_VertexID, gl_InstanceID, 0);
  vec4 shape = texelFetch(kernelShapes, pixel, 0);
  vec4 prediction = texelFetch(predictions, pixel, 0);
  if (shape.w < VIRTUAL_PENUMBRA)
  {
    wish = vec4(0.0);
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // nowhere
    return;
  }
  // A leaning kernel reaches at most the root of 2 farther than its variance says.
  wish = vec4(prediction.zw, -sqrt(2.0 * shape.xz));
  // Receivers beside the map may still be reached by what is on it.
  vec2 cell = clamp(floor(prediction.xy * gridSize), vec2(0.0), vec2(gridSize - 1.0));
  gl_Position = vec4(2.0 * (cell + 0.5) / gridSize - 1.0, 0.0, 1.0);
}
