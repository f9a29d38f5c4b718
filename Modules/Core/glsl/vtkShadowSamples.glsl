// Hard shadows from points of the light: a depth map each, in the layers from firstLayer on.
// Needs vtkShadowDepthMap.

uniform mat4 viewToMaps[SOFT_SHADOW_SAMPLES_PER_DRAW];
uniform float sampleWeights[SOFT_SHADOW_SAMPLES_PER_DRAW];
uniform int sampleCount;
uniform float firstLayer;
uniform int filterSize; // edge of the percentage-closer filter in texels; 1: a single tap

// The share of the box of filterSize x filterSize texels around the receiver that does not block
// it. Texels that the box's border cuts count by the part inside, so it is continuous.
float hardVisibility(MapPoint point, float layer)
{
  if (filterSize == 1)
  {
    return isBlocked(point, point.std.xy, layer) ? 0.0 : 1.0;
  }
  vec2 low = point.std.xy * depthMapSize - 0.5 * float(filterSize);
  vec2 texel = floor(low);
  vec2 cut = low - texel;
  float lit = 0.0;
  for (int y = 0; y <= filterSize; ++y)
  {
    float row = 0.0;
    for (int x = 0; x <= filterSize; ++x)
    {
      vec2 st = (texel + vec2(x, y) + 0.5) / depthMapSize;
      float inside = x == 0 ? 1.0 - cut.x : (x == filterSize ? cut.x : 1.0);
      row += isBlocked(point, st, layer) ? 0.0 : inside;
    }
    lit += row * (y == 0 ? 1.0 - cut.y : (y == filterSize ? cut.y : 1.0));
  }
  return lit / float(filterSize * filterSize);
}

// The weighted sum over the points of this draw.
float sampledVisibility(Receiver receiver)
{
  float visibility = 0.0;
  for (int i = 0; i < sampleCount; ++i)
  {
    MapPoint point = toMap(viewToMaps[i], receiver.positionVs, receiver.normalVs);
    // A plane that the camera sees from behind is its own blocker, within the bias of the map.
    if (point.facesCenter)
    {
      visibility += sampleWeights[i] * hardVisibility(point, firstLayer + float(i));
    }
  }
  return visibility;
}
