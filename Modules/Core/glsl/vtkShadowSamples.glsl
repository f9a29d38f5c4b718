// Hard shadows from points of the light: a depth map each, in the layers from firstLayer on.
// Needs vtkShadowDepthMap and vtkShadowCrease. With SOFT_SHADOW_GATHER defined, and textureGather at
// hand, four texels are read at a time.

// The points' maps are affine images of one of them, the base: a row for each of s, t and d.
uniform mat4 viewToBase;
uniform vec4 baseToMaps[3 * SOFT_SHADOW_SAMPLES_PER_DRAW];
uniform float sampleWeights[SOFT_SHADOW_SAMPLES_PER_DRAW];
uniform int sampleCount;
uniform float firstLayer;
uniform int filterSize; // edge of the percentage-closer filter in texels; 1: a single tap

// The receiver in the map of point i.
MapPoint toSampleMap(MapFrame base, int i)
{
  return toPoint(
    moveFrame(base, baseToMaps[3 * i], baseToMaps[3 * i + 1], baseToMaps[3 * i + 2]));
}

// How much of texel i of the box lies inside it, along one axis; cut is what its border cuts off the
// first one.
float insideShare(int i, float cut)
{
  return i == 0 ? 1.0 - cut : (i < filterSize ? 1.0 : (i == filterSize ? cut : 0.0));
}

#ifdef SOFT_SHADOW_GATHER
// The four texels around a corner of texels, as textureGather returns them.
vec4 litTexels(MapPoint point, vec2 corner, float layer)
{
  vec4 depths = mapDepthsAround(corner, layer);
  // isBlocker at the four centres, for planes that face the light.
  float middle = planeDepth(point, corner / depthMapSize) - point.bias;
  vec2 reach = 0.5 / depthMapSize * point.gradient;
  vec4 planes = middle + vec4(reach.y - reach.x, reach.y + reach.x, reach.x - reach.y, -reach.x - reach.y);
  vec4 receiver = min(planes, vec4(point.std.z));
  return vec4(greaterThanEqual(depths, receiver));
}
#endif

// The share of the box of filterSize x filterSize texels around the receiver that does not block
// it. Texels that the box's border cuts count by the part inside, so it is continuous.
float boxVisibility(MapPoint point, float layer)
{
  if (filterSize == 1)
  {
    return isBlocked(point, point.std.xy, layer) ? 0.0 : 1.0;
  }
  vec2 low = point.std.xy * depthMapSize - 0.5 * float(filterSize);
  vec2 texel = floor(low);
  vec2 cut = low - texel;
  float lit = 0.0;
#ifdef SOFT_SHADOW_GATHER
  for (int y = 0; y <= filterSize; y += 2)
  {
    vec2 rows = vec2(insideShare(y, cut.y), insideShare(y + 1, cut.y));
    for (int x = 0; x <= filterSize; x += 2)
    {
      vec2 columns = vec2(insideShare(x, cut.x), insideShare(x + 1, cut.x));
      vec4 texels = litTexels(point, texel + vec2(x, y) + 1.0, layer);
      lit += dot(texels, vec4(columns * rows.y, columns.yx * rows.x));
    }
  }
#else
  for (int y = 0; y <= filterSize; ++y)
  {
    float row = 0.0;
    for (int x = 0; x <= filterSize; ++x)
    {
      vec2 st = (texel + vec2(x, y) + 0.5) / depthMapSize;
      row += isBlocker(point, st, mapDepth(st, layer)) ? 0.0 : insideShare(x, cut.x);
    }
    lit += row * insideShare(y, cut.y);
  }
#endif
  return lit / float(filterSize * filterSize);
}

float hardVisibility(MapPoint point, float layer)
{
  float visibility = boxVisibility(point, layer);
  float reach = creaseReach + 0.5 * float(filterSize - 1);
  return visibility > 0.0 && isInCrease(point, vec2(0.0), reach, layer) ? 0.0 : visibility;
}

// The weighted sum over the points of this draw.
float sampledVisibility(Receiver receiver)
{
  MapFrame base = toFrame(viewToBase, receiver);
  float visibility = 0.0;
  for (int i = 0; i < sampleCount; ++i)
  {
    MapPoint point = toSampleMap(base, i);
    // A plane that the camera sees from behind is its own blocker, within the bias of the map.
    if (point.facesCenter)
    {
      visibility += sampleWeights[i] * hardVisibility(point, firstLayer + float(i));
    }
  }
  return visibility;
}
