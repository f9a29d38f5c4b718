//VTK::System::Dec
//VTK::Output::Dec

// Step 3 of predicted virtual soft shadow maps (Shen et al. 2011): the kernel shape buffer. Finds
// the mean depth of what blocks the pixel, the kernel that follows from it, and the texel size that
// the kernel asks for.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowLight
//SoftShadows::Include vtkShadowDepthMap
#define SOFT_SHADOW_LEAST_DEPTHS // the search map is conservative
//SoftShadows::Include vtkShadowCrease
//SoftShadows::Include vtkShadowProof
//SoftShadows::Include vtkShadowBlocker
//VirtualSoftShadow::Kernel

uniform vec2 kernelScale;
uniform float mapLayer;
uniform int searchWidth;     // blocks along an edge of the search
uniform int emitterDisk;
uniform int kernelGaussian;
uniform vec4 emitterWindow;  // middle and half size of this emitter in the whole light's window
uniform int usePyramid;      // to prove pixels lit and to narrow the search
uniform int antialiasing;
uniform vec4 texelPolynomial;
uniform float quality;
uniform float largestKernel; // pixels

//VirtualSoftShadow::Footprint

// No surface asks for finer texels than one that the light meets at this cosine.
const float leastFacing = 0.25;

// Octaves of distances from the receiver that are searched for blockers.
const int mostShells = 12;

// Blocks of 2^level texels, of which at most searchWidth span the light's image.
int levelOf(vec2 reach)
{
  float blocks = 2.0 * max(reach.x, reach.y) / float(searchWidth);
  // The pyramid's first level is the blocks of two texels.
  return min(int(max(ceil(log2(max(blocks, 1e-6))), 0.0)), coarsestLevel() + 1);
}

// Length of [low, high] within [from, to].
vec2 overlap(vec2 low, vec2 high, vec2 from, vec2 to)
{
  return max(min(high, to) - max(low, from), vec2(0.0));
}

// Sums over blockers: linear depths, and the shares of the light that they hide, which are the weights.
// near: those that the plane's own least depth within a texel or block might be taken for. possible: where
// only blocks' least depths were met, which may be anywhere within the block: found, but seen by no sample.
struct Blockers
{
  vec2 seen;
  vec2 near;
  vec2 possible;
};

// The receiver's image of the light at a depth so far in front of it, as a half extent in texels.
vec2 imageAt(float delta, vec2 pixelReach)
{
  return max((kernelScale * max(delta, 0.0) + pixelReach) * depthMapSize, vec2(0.5));
}

// What a blocker that fills a block hides of the light.
float shareOfBlock(vec2 center, vec2 image, vec2 block, float stride)
{
  vec2 part = overlap(center - image, center + image, block, block + stride);
  return part.x * part.y / (4.0 * image.x * image.y);
}

// The least depth of a block may hide a blocker that no sample sees. It is one for sure if it is in front
// of the plane everywhere in the block; else it may be the plane's own.
void addPossible(MapPoint point, vec2 block, int level, vec2 pixelReach, inout Blockers blockers)
{
  float stride = float(1 << level);
  ivec2 texel = levelCorner(level - 1) + (ivec2(block) >> level);
  float depth = texelFetch(depthPyramid, ivec3(texel, int(mapLayer)), 0).r;
  float plane = planeDepth(point, (block + 0.5 * stride) / depthMapSize);
  float reach = dot(abs(point.gradient), vec2(0.5 * stride / depthMapSize)) + point.bias;
  if (depth < point.std.z && (depth < plane + reach || !point.facesCenter))
  {
    bool inFront = point.facesCenter ? depth < plane - reach : depth > plane + reach;
    vec2 image = imageAt(point.std.z - depth, pixelReach);
    float share = shareOfBlock(point.std.xy * depthMapSize, image, block, stride);
    vec2 sums = share * vec2(linearDepth(depth), 1.0);
    blockers.possible += inFront ? sums : vec2(0.0);
    blockers.near += inFront ? vec2(0.0) : sums;
  }
}

// Adds the blockers that stand between nearest and farthest in front of the receiver (depth
// differences). Blocks of 2^level texels stand for one another.
void addShell(MapPoint point, float nearest, float farthest, bool isFirst, vec2 pixelReach,
  inout Blockers blockers)
{
  vec2 center = point.std.xy * depthMapSize;
  vec2 reach = imageAt(farthest, pixelReach);
  int level = levelOf(reach);
  float stride = float(1 << level);
  vec2 last = min(center + reach, depthMapSize - 1.0);
  vec2 first = floor(max(center - reach, vec2(0.0)) / stride) * stride;
  // The map keeps the least depth within a texel: a plane's own may lie so far in front of it.
  float own = dot(abs(point.gradient), vec2(0.5 / depthMapSize));
  for (float y = first.y; y <= last.y; y += stride)
  {
    for (float x = first.x; x <= last.x; x += stride)
    {
      vec2 block = vec2(x, y);
      vec2 st = (min(block + floor(0.5 * stride), depthMapSize - 1.0) + 0.5) / depthMapSize;
      float depth = mapDepth(st, mapLayer);
      float delta = point.std.z - depth;
      if (delta > nearest && delta <= farthest && isBlocker(point, st, depth))
      {
        float share = shareOfBlock(center, imageAt(delta, pixelReach), block, stride);
        vec2 sums = share * vec2(linearDepth(depth), 1.0);
        bool isOwn = !isBlocker(point, st, depth + own);
        blockers.seen += isOwn ? vec2(0.0) : sums;
        blockers.near += isOwn ? sums : vec2(0.0);
      }
      if (isFirst && level > 0)
      {
        addPossible(point, block, level, pixelReach, blockers);
      }
    }
  }
}

// The map depth of the blockers' mean linear depth; infinitelyFar if nothing blocks.
//
// The nearer a blocker stands to the receiver, the smaller is the light's image at its depth: each
// octave of distances is searched with as many samples, the last one texel by texel.
float meanBlocker(MapPoint point, float farthest, vec2 pixelReach)
{
  Blockers blockers = Blockers(vec2(0.0), vec2(0.0), vec2(0.0));
  float outer = farthest;
  for (int shell = 0; shell < mostShells; ++shell)
  {
    bool isLast = shell == mostShells - 1 || levelOf(imageAt(outer, pixelReach)) == 0 ||
      imageAt(0.5 * outer, pixelReach) == imageAt(outer, pixelReach);
    addShell(point, isLast ? -infinitelyFar : 0.5 * outer, outer, shell == 0, pixelReach, blockers);
    if (isLast)
    {
      break;
    }
    outer *= 0.5;
  }
  vec2 sums = blockers.seen.y > 0.0 ? blockers.seen : blockers.possible;
  if (sums.y == 0.0)
  {
    sums = blockers.near;
  }
  return sums.y > 0.0 ? mapDepthOfLinear(sums.x / sums.y) : infinitelyFar;
}

// False if nothing can block; else by how much of depth, at most, blockers stand in front.
bool mayBlockFrom(MapPoint point, vec2 pixelReach, out float farthest)
{
  DepthRange range = searchPyramid(point, kernelScale * max(point.std.z - nearestDepth, 0.0) + pixelReach, mapLayer);
  // Nothing lies in front of the nearest depth, so nothing outside its kernel can matter.
  farthest = max(point.std.z - range.nearest, 0.0);
  DepthRange inner = searchPyramid(point, kernelScale * farthest + pixelReach, mapLayer);
  if (usePyramid == 0)
  {
    farthest = max(point.std.z - nearestDepth, 0.0);
    return true;
  }
  farthest = max(point.std.z - inner.nearest, 0.0);
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
  if (kernelGaussian == 1)
  {
    // Along the way to the horizon, in the whole light's window, as if the normal distribution's cut
    // had no corners: exact along the axes.
    vec2 g = point.gradient * kernelScale / emitterWindow.zw;
    float steep = max(length(g), 1e-6);
    vec2 way = -g / steep;
    float middle = dot(way, emitterWindow.xy);
    float extent = emitterDisk == 1 ? emitterWindow.z : dot(abs(way), emitterWindow.zw);
    float low = gaussianIntegral(middle - extent);
    facing = (gaussianIntegral(middle + min(1.0 / steep, extent)) - low) /
      (gaussianIntegral(middle + extent) - low);
  }
  else if (emitterDisk == 1)
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
  if (!loadReceiver(ivec2(gl_FragCoord.xy), receiver) || !lightReaches(receiver.positionVs))
  {
    return;
  }
  MapPoint point = toMap(viewToMap, receiver);
  Footprint footprint = footprintOf(receiver, point);
  vec2 pixelReach = antialiasing == 1 ? reachOf(footprint) : vec2(0.0);
  float farthest;
  bool mayBlock = mayBlockFrom(point, pixelReach, farthest);
  float inFront = shareInFront(point);
  if (inFront > 0.0 && isInCrease(point, kernelScale, creaseReach, mapLayer))
  {
    inFront = 0.0;
  }
  mayBlock = mayBlock && inFront > 0.0;
  float blocker = mayBlock ? meanBlocker(point, farthest, pixelReach) : infinitelyFar;
  if (blocker == infinitelyFar)
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
