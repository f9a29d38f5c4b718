//VTK::System::Dec
//VTK::Output::Dec

// The weighted mean of hard shadows, one per depth map seen from a point of the light.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowDepthMap

uniform mat4 viewToMaps[SAMPLED_BATCH];
uniform float sampleWeights[SAMPLED_BATCH];
uniform int sampleCount;
uniform float firstLayer;
uniform float litWeight; // of the points that see everything
uniform int filterSize;  // edge of the percentage-closer filter in texels; 1: a single tap

float hardVisibility(MapPoint point, float layer)
{
  if (filterSize == 1)
  {
    return isBlocked(point, point.std.xy, layer) ? 0.0 : 1.0;
  }
  float lit = 0.0;
  float first = 0.5 - 0.5 * float(filterSize);
  for (int y = 0; y < filterSize; ++y)
  {
    for (int x = 0; x < filterSize; ++x)
    {
      vec2 st = point.std.xy + (vec2(x, y) + first) / depthMapSize;
      lit += isBlocked(point, st, layer) ? 0.0 : 1.0;
    }
  }
  return lit / float(filterSize * filterSize);
}

void main()
{
  Receiver receiver;
  loadReceiver(ivec2(gl_FragCoord.xy), receiver);
  float visibility = litWeight;
  for (int i = 0; i < sampleCount; ++i)
  {
    MapPoint point = toMap(viewToMaps[i], receiver.positionVs, receiver.normalVs);
    visibility += sampleWeights[i] * hardVisibility(point, firstLayer + float(i));
  }
  gl_FragData[0] = vec4(visibility);
}
