//VTK::System::Dec

// Two triangles for each block of pixels, made from nothing but their numbers in the row and the row's:
// nowhere if no kernel of the block reaches into the tile.

uniform sampler2DArray blockBounds; // least (s, t), and minus the greatest
uniform vec2 blockExtent;           // of a block, in clip coordinates
uniform vec4 tileWindow;            // low corner and extent of the tile in (s, t) of the whole map
uniform float depthMapSize;

void main()
{
  int corner = gl_VertexID % 6;
  corner = corner < 3 ? corner : corner - 2; // 0 1 2, 1 2 3
  ivec2 place = ivec2(gl_VertexID / 6, gl_InstanceID);
  vec4 bounds = texelFetch(blockBounds, ivec3(place, 0), 0);
  // The filter's own margin, and rounding.
  vec2 margin = 0.01 * tileWindow.zw / depthMapSize + 4e-6;
  vec2 low = bounds.xy - tileWindow.xy;
  vec2 high = -bounds.zw - tileWindow.xy;
  if (any(greaterThan(low, tileWindow.zw + margin)) || any(lessThan(high, -margin)))
  {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // nowhere
    return;
  }
  vec2 at = vec2(place) + vec2(float(corner & 1), float(corner >> 1));
  gl_Position = vec4(blockExtent * at - 1.0, 0.0, 1.0);
}
