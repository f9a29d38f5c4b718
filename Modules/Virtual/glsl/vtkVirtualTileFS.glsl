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
uniform int kernelGaussian;
uniform vec4 emitterWindow; // middle and half size of this emitter in the whole light's window
uniform int antialiasing;
uniform int debugView;
uniform float debugShade; // of this tile, in (0, 1)
uniform float coarseness; // texels of so many times the predicted size serve a kernel; 0: all are used

// A kernel of more texels along an edge takes several as one: software rasterisers end a shader's
// loops after 65535 rounds.
const float mostTexels = 160.0;
// Never fewer along an edge than this, if the tile has them.
const float leastTexels = 16.0;

// How many texels along each axis count as one: a block as coarse as a texel was predicted to be.
vec2 strideOf(vec2 wantedTexels, Kernel kernel)
{
  vec2 extent = vec2(kernel.along, kernel.across + abs(kernel.lean));
  extent = kernel.transposed ? extent.yx : extent;
  vec2 wanted = floor(min(coarseness * wantedTexels, 2.0 * extent / leastTexels));
  return max(max(wanted, ceil(2.0 * extent / mostTexels)), vec2(1.0));
}

// The texel that stands for a block, in (s, t): another place in each row and column (multiples of
// the golden ratio), so that a straight edge along the map is met where it is on average.
vec2 sampleOf(vec2 block, vec2 stride)
{
  vec2 texel = block * stride + floor(fract(0.618034 * block.yx) * stride);
  return (min(texel, depthMapSize - 1.0) + 0.5) / depthMapSize;
}

// Sums of overlaps: of the texels that are lit, that count, and all. Lengths are strides.
//
// horizon: how the light's points, over its window, come up over the receiver's plane; zero if all of
// the light is on the side that its centre is on. What is behind the plane, the plane blocks.
vec3 filterTile(
  MapPoint point, Kernel kernel, vec2 stride, bool disk, vec2 margin, vec2 horizon)
{
  vec2 size = depthMapSize / stride;
  vec2 center = point.std.xy * size;
  if (kernel.transposed)
  {
    size = size.yx;
    center = center.yx;
    horizon = horizon.yx;
  }
  horizon /= vec2(kernel.along, length(vec2(kernel.across, kernel.lean)));
  vec3 sums = vec3(0.0);
  vec2 last = ceil(size) - 1.0;
  float lastStrip = min(floor(center.x + kernel.along), last.x);
  for (float i = max(floor(center.x - kernel.along), 0.0); i <= lastStrip; i += 1.0)
  {
    Strip strip = stripOf(kernel, disk, center, i);
    float from = max(i, center.x - kernel.along);
    float to = min(i + 1.0, center.x + kernel.along);
    // The map's border may cut the last blocks.
    strip.width *= clamp((size.x - from) / max(to - from, 1e-6), 0.0, 1.0);
    strip.high = min(strip.high, size.y);
    float risen = 1.0 + horizon.x * (0.5 * (from + to) - center.x);
    float high = min(floor(strip.high), last.y);
    vec3 stripSums = vec3(0.0);
    for (float j = max(floor(strip.low), 0.0); j <= high; j += 1.0)
    {
      vec2 st = sampleOf(kernel.transposed ? vec2(j, i) : vec2(i, j), stride);
      float depth = mapDepth(st, mapLayer);
      vec3 weights = vec3(1.0);
      float plane = planeDepth(point, st);
      bool inFront = point.facesCenter ? depth < plane - point.bias : depth > plane + point.bias;
      float height = 0.5 * (max(j, strip.low) + min(j + 1.0, strip.high)) - center.y;
      if ((risen + horizon.y * height > 0.0) != point.facesCenter)
      {
        weights.x = 0.0;
      }
      else if (inFront && depth < point.std.z)
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
  MapPoint point = toMap(viewToMap, receiver);
  bool disk = emitterDisk == 1;
  vec4 prediction = texelFetch(predictions, pixel, 0);
  vec2 texels = depthMapSize / tileWindow.zw;
  bool gaussian = kernelGaussian == 1;
  vec2 stride =
    strideOf(prediction.zw * texels, kernelOf(shape.xyz, texels, gaussian, emitterWindow));
  Kernel kernel = kernelOf(shape.xyz, texels / stride, gaussian, emitterWindow);
  // Tiles have texels of their own size; areas must add up in one unit.
  vec2 margin =
    antialiasing == 1 ? reachOf(footprintOf(receiver, point)) : vec2(0.0);
  vec2 horizon = fract(shape.w) == 0.0 && point.facesCenter
    ? vec2(0.0)
    : point.gradient * kernelScale;
  vec2 block = texel * stride;
  vec3 sums = filterTile(point, kernel, stride, disk, margin, horizon) * (block.x * block.y);
  if (debugView == VIRTUAL_DEBUG_TILES)
  {
    sums.x = sums.y * debugShade;
  }
  gl_FragData[0] = vec4(sums, 0.0);
}
