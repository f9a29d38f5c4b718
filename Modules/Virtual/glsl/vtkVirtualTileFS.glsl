//VTK::System::Dec
//VTK::Output::Dec

// Step 8: what one tile shows of each pixel's kernel. Every texel is a square of constant depth and
// counts by its overlap with the kernel.
//
// Beyond the paper: a texel that blocks, but only what the light does not shine from, counts neither
// as lit nor as blocked.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowDepthMap
//VirtualSoftShadow::Kernel
//VirtualSoftShadow::Footprint

uniform vec2 kernelScale;
uniform float mapLayer;
uniform sampler2DArray kernelShapes; // (variance, state)
uniform sampler2DArray predictions;  // (s, t, texel sizes) on the whole map
uniform vec4 tileWindow;  // low corner and extent of the tile in (s, t) of the whole map
uniform int emitterDisk;
uniform int antialiasing;
uniform int debugView;
uniform float debugShade; // of this tile, in (0, 1)

// Sums of overlaps: of the texels that are lit, that count, and all.
vec3 filterTile(MapPoint point, Kernel kernel, bool disk, vec2 margin)
{
  vec2 center = point.std.xy * depthMapSize;
  center = kernel.transposed ? center.yx : center;
  float lastTexel = depthMapSize - 1.0;
  float texel = 1.0 / depthMapSize;
  // The receiver's plane, per texel across and along the strips; a texel is compared at its centre.
  vec2 slope = point.gradient * texel;
  slope = kernel.transposed ? slope.yx : slope;
  float plane = point.std.z - point.bias + dot(slope, vec2(0.5) - center);
  vec3 sums = vec3(0.0);
  float lastStrip = min(floor(center.x + kernel.along), lastTexel);
  for (float i = max(floor(center.x - kernel.along), 0.0); i <= lastStrip; i += 1.0)
  {
    Strip strip = stripOf(kernel, disk, center, i);
    float high = min(floor(strip.high), lastTexel);
    vec3 stripSums = vec3(0.0);
    for (float j = max(floor(strip.low), 0.0); j <= high; j += 1.0)
    {
      vec2 st = (vec2(i, j) + 0.5) * texel;
      st = kernel.transposed ? st.yx : st;
      float depth = mapDepth(st, mapLayer);
      vec3 weights = vec3(1.0);
      if (depth < plane + dot(slope, vec2(i, j)))
      {
        // Not quite nothing: where nothing else is seen, what stands near decides.
        float share = max(shareOfBlocker(point, kernelScale, depth, st, margin), 1e-4);
        weights = vec3(0.0, share, 1.0);
      }
      stripSums += texelOverlap(strip, j) * weights;
    }
    sums += strip.width * stripSums;
  }
  return sums;
}

void main()
{
  ivec3 pixel = ivec3(ivec2(gl_FragCoord.xy), 0);
  vec4 shape = texelFetch(kernelShapes, pixel, 0);
  if (shape.w < VIRTUAL_PENUMBRA)
  {
    discard;
  }
  vec2 st = texelFetch(predictions, pixel, 0).xy - tileWindow.xy;
  vec2 texel = tileWindow.zw / depthMapSize;
  vec2 reach = sqrt(2.0 * shape.xz) + 2.0 * leastHalfExtent * texel + 2e-6;
  if (any(lessThan(st + reach, vec2(0.0))) || any(greaterThan(st - reach, tileWindow.zw)))
  {
    discard;
  }
  Receiver receiver;
  loadReceiver(pixel.xy, receiver);
  MapPoint point = toMap(viewToMap, receiver.positionVs, receiver.normalVs);
  bool disk = emitterDisk == 1;
  Kernel kernel = kernelOf(shape.xyz, depthMapSize / tileWindow.zw);
  // Tiles have texels of their own size; areas must add up in one unit.
  vec2 margin =
    antialiasing == 1 ? reachOf(footprintOf(receiver, point)) : vec2(0.0);
  vec3 sums = filterTile(point, kernel, disk, margin) * (texel.x * texel.y);
  if (debugView == VIRTUAL_DEBUG_TILES)
  {
    sums.x = sums.y * debugShade;
  }
  gl_FragData[0] = vec4(sums, 0.0);
}
