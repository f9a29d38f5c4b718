//VTK::System::Dec
//VTK::Output::Dec

// Step 3 of predicted virtual soft shadow maps (Shen et al. 2011): the kernel shape buffer. Finds
// the mean depth of what blocks the pixel, the kernel that follows from it, and the texel size that
// the kernel asks for.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowLight
//SoftShadows::Include vtkShadowDepthMap
//SoftShadows::Include vtkShadowProof
//SoftShadows::Include vtkShadowBlocker
//VirtualSoftShadow::Kernel

uniform vec2 kernelScale;
uniform float mapLayer;
uniform int searchWidth;     // blocks along an edge of the search
uniform int emitterDisk;
uniform int usePyramid;      // to prove pixels lit and to narrow the search
uniform int antialiasing;
uniform vec4 texelPolynomial;
uniform float quality;
uniform float largestKernel; // pixels

//VirtualSoftShadow::Footprint

// No surface asks for finer texels than one that the light meets at this cosine.
const float leastFacing = 0.25;

// Length of [low, high] within [from, to].
vec2 overlap(vec2 low, vec2 high, vec2 from, vec2 to)
{
  return max(min(high, to) - max(low, from), vec2(0.0));
}

// Sum of linear depths and of weights over the blockers in a rectangle of texels. Blocks of stride
// texels stand for one another; their overlap with the rectangle is their weight.
vec2 sumBlockers(MapPoint point, vec2 low, vec2 high, ivec2 stride, vec2 margin)
{
  ivec2 last = min(ivec2(floor(high)), ivec2(depthMapSize) - 1);
  ivec2 first = max(ivec2(floor(low)), ivec2(0)) / stride * stride;
  vec2 sums = vec2(0.0);
  for (int y = first.y; y <= last.y; y += stride.y)
  {
    for (int x = first.x; x <= last.x; x += stride.x)
    {
      vec2 block = vec2(x, y);
      vec2 st = (min(block + vec2(stride / 2), depthMapSize - 1.0) + 0.5) / depthMapSize;
      float depth = mapDepth(st, mapLayer);
      if (isBlocker(point, st, depth))
      {
        vec2 part = overlap(low, high, block, block + vec2(stride));
        float share = shareOfBlocker(point, kernelScale, depth, st, margin);
        sums += part.x * part.y * share * vec2(linearDepth(depth), 1.0);
      }
    }
  }
  return sums;
}

// The map depth of the blockers' mean linear depth; negative if nothing blocks.
float meanBlocker(MapPoint point, vec2 halfWidth, vec2 pixelReach)
{
  vec2 reach = max(halfWidth * depthMapSize, vec2(0.05)); // texels; a point still has a weight
  vec2 center = point.std.xy * depthMapSize;
  vec2 low = center - reach;
  vec2 high = center + reach;
  ivec2 stride = max(ivec2(ceil(2.0 * reach / float(searchWidth))), ivec2(1));
  vec2 sums = sumBlockers(point, low, high, stride, pixelReach);
  if (sums.y <= 0.0 && (stride.x > 1 || stride.y > 1))
  {
    // Something thin may stand between the blocks' samples.
    sums = sumBlockers(point, low, high, ivec2(1), pixelReach);
  }
  return sums.y > 0.0 ? mapDepthOfLinear(sums.x / sums.y) : -1.0;
}

// False if nothing can block; else the half width within which it can.
//
// Every pixel of a quad comes here: the pyramid is looked up on one level for the four of them.
bool searchWidthOf(MapPoint point, vec2 pixelReach, out vec2 halfWidth)
{
  vec2 widest = kernelScale * max(point.std.z, 0.0) + pixelReach;
  DepthRange range = searchPyramid(point, widest, mapLayer);
  // Nothing lies in front of the nearest depth, so nothing outside its kernel can matter.
  halfWidth = kernelScale * max(point.std.z - range.nearest, 0.0) + pixelReach;
  DepthRange inner = searchPyramid(point, halfWidth, mapLayer);
  if (usePyramid == 0)
  {
    halfWidth = widest;
    return true;
  }
  return range.anyBlocker && inner.anyBlocker;
}

// Texels that a kernel of so many pixels needs.
float texelsOf(float pixels)
{
  float x = log2(clamp(pixels, 1.0, largestKernel));
  return max(dot(texelPolynomial, vec4(1.0, x, x * x, x * x * x)), 1.0);
}

// How far half a pixel, turned face-on to the light, reaches on the map.
vec2 facingFootprint(Receiver receiver, MapPoint point)
{
  float w = (viewToMap * vec4(receiver.positionVs, 1.0)).w;
  mat3 linear = mat3(viewToMap);
  vec3 row = vec3(viewToMap[0].w, viewToMap[1].w, viewToMap[2].w);
  vec3 alongS = (vec3(linear[0].x, linear[1].x, linear[2].x) - point.std.x * row) / w;
  vec3 alongT = (vec3(linear[0].y, linear[1].y, linear[2].y) - point.std.y * row) / w;
  float depth = cameraParallel == 1 ? 1.0 : abs(receiver.positionVs.z);
  return min(halfPixel.x, halfPixel.y) * depth * vec2(length(alongS), length(alongT));
}

// Equations 4 and 5.
vec2 predictTexelSize(vec3 variance, Footprint footprint)
{
  float along = sqrt(variance.x);
  float lean = along > 0.0 ? variance.y / along : 0.0;
  float across = sqrt(max(variance.z - lean * lean, 0.0));
  vec2 u = footprint.u;
  vec2 v = footprint.v;
  float determinant = max(abs(u.x * v.y - u.y * v.x), 1e-30);
  vec2 pixels = vec2(along * length(vec2(v.y, u.y)), across * length(vec2(v.x, u.x))) / determinant;
  return 2.0 * vec2(along, across) / (quality * vec2(texelsOf(pixels.x), texelsOf(pixels.y)));
}

// x > 0 ? x^2 : 0
float rampSquared(float x)
{
  return x > 0.0 ? x * x : 0.0;
}

// The share of the light in front of the receiver's plane; what is behind, the plane itself blocks.
// In the light's window [-1, 1]^2 the plane's horizon is the line 1 + a . e = 0.
float shareInFront(MapPoint point)
{
  vec2 a = abs(point.gradient * kernelScale);
  float facing = 1.0;
  if (emitterDisk == 1)
  {
    float edge = 1.0 / max(length(a), 1e-6);
    facing = edge < 1.0 ? 0.5 + chordIntegral(edge) / 1.57079633 : 1.0;
  }
  else if (a.x + a.y > 1.0)
  {
    a = max(a, 1e-3 * max(a.x, a.y));
    facing = (rampSquared(1.0 + a.x + a.y) - rampSquared(1.0 + a.x - a.y) -
               rampSquared(1.0 - a.x + a.y) + rampSquared(1.0 - a.x - a.y)) /
      (8.0 * a.x * a.y);
  }
  return clamp(point.facesCenter ? facing : 1.0 - facing, 0.0, 1.0);
}

void main()
{
  gl_FragData[0] = vec4(0.0, 0.0, 0.0, VIRTUAL_UNSERVED);
  gl_FragData[1] = vec4(0.0);
  Receiver receiver;
  bool served = loadReceiver(ivec2(gl_FragCoord.xy), receiver) && lightReaches(receiver.positionVs);
  MapPoint point = toMap(viewToMap, receiver.positionVs, receiver.normalVs);
  if (!served)
  {
    point = MapPoint(vec3(0.5, 0.5, 0.0), vec2(0.0), 0.0, true);
  }
  Footprint footprint = footprintOf(receiver, point);
  vec2 pixelReach = served && antialiasing == 1 ? reachOf(footprint) : vec2(0.0);
  vec2 halfWidth;
  bool mayBlock = searchWidthOf(point, pixelReach, halfWidth);
  if (!served)
  {
    return;
  }
  float inFront = shareInFront(point);
  mayBlock = mayBlock && inFront > 0.0;
  float blocker = mayBlock ? meanBlocker(point, halfWidth, pixelReach) : -1.0;
  if (blocker < 0.0)
  {
    gl_FragData[0].w = VIRTUAL_LIT + inFront;
    return;
  }
  vec3 footprintVariance = varianceOf(footprint.u, footprint.v);
  vec2 light = kernelScale * max(point.std.z - blocker, 0.0);
  bool disk = emitterDisk == 1;
  vec3 full = convolve(light, disk, footprintVariance);
  gl_FragData[0] =
    vec4(antialiasing == 1 ? full : convolve(light, disk, vec3(0.0)), VIRTUAL_PENUMBRA + inFront);
  // A surface that the light grazes has a narrow footprint on the map, and little light to lose.
  vec2 finest = 2.0 * leastFacing / quality * facingFootprint(receiver, point);
  gl_FragData[1] = vec4(point.std.xy, max(predictTexelSize(full, footprint), finest));
}
