// Sums over points of the emitter for a filter on the screen (vtkSoftShadowScreenFilter): r: the share
// of those in front of the receiver's plane, g: of those that it sees, b: how much further than its
// blockers it is, what the light's size is multiplied by to get the width of the penumbra, and a: the
// share of those behind the plane that nothing else hides.
// Needs vtkShadowDepthMap and vtkShadowSamples. With SOFT_SHADOW_GATHER defined, and textureGather at
// hand, four texels are read at a time.

uniform vec2 depthToLinears[SOFT_SHADOW_SAMPLES_PER_DRAW]; // positional: 1 / z = a + b d, else z
uniform int mapDirectional;

// Positional: z_q / z_o - 1. Directional: z_q - z_o.
float reachOf(int i, float receiverDepth, float depth)
{
  float difference = depthToLinears[i].y * (receiverDepth - depth);
  float reach = mapDirectional == 1
    ? difference
    : -difference / (depthToLinears[i].x + depthToLinears[i].y * receiverDepth);
  return max(reach, 0.0);
}

// The four texels around the receiver, weighted so that an edge between texels is a ramp a texel
// wide. Adds the blocked share and the blockers' reaches.
vec2 blockedTexels(MapPoint point, int i, float layer)
{
  vec2 place = point.std.xy * depthMapSize - 0.5;
  vec2 corner = floor(place) + 1.0;
  vec2 part = place + 1.0 - corner;
  vec4 weights = vec4((1.0 - part.x) * part.y, part.x * part.y, part.x * (1.0 - part.y),
    (1.0 - part.x) * (1.0 - part.y));
#ifdef SOFT_SHADOW_GATHER
  vec4 depths = mapDepthsAround(corner, layer);
#else
  vec2 side = vec2(0.5, -0.5) / depthMapSize;
  vec2 st = corner / depthMapSize;
  vec4 depths = vec4(mapDepth(st + side.yx, layer), mapDepth(st + side.xx, layer),
    mapDepth(st + side.xy, layer), mapDepth(st + side.yy, layer));
#endif
  // isBlocker at the four centres, for planes that face the light.
  vec2 slope = 0.5 / depthMapSize * point.gradient;
  vec4 planes = planeDepth(point, corner / depthMapSize) - point.bias +
    vec4(slope.y - slope.x, slope.y + slope.x, slope.x - slope.y, -slope.x - slope.y);
  weights *= vec4(lessThan(depths, min(planes, vec4(point.std.z))));
  vec4 reaches = vec4(0.0);
  vec4 sideX = vec4(-0.5, 0.5, 0.5, -0.5);
  for (int k = 0; k < 4; ++k)
  {
    vec2 texel = corner + vec2(sideX[k], k < 2 ? 0.5 : -0.5);
    if (weights[k] > 0.0 && meetsPlane(point, point.std.xy, texel, depths[k], layer))
    {
      weights[k] = 0.0;
    }
    reaches[k] = weights[k] > 0.0 ? reachOf(i, point.std.z, depths[k]) : 0.0;
  }
  return vec2(dot(weights, vec4(1.0)), dot(weights, reaches));
}

// Where filterSize is above 1, edges are a texel wide, not sharp.
vec4 pointSums(MapFrame frame)
{
  vec4 sums = vec4(0.0);
  for (int i = 0; i < sampleCount; ++i)
  {
    MapPoint point = toSampleMap(frame, i);
    float layer = firstLayer + float(i);
    // A plane that the camera sees from behind is its own blocker.
    if (!point.facesCenter)
    {
      sums.a += isBlocked(point, point.std.xy, layer) ? 0.0 : sampleWeights[i];
      continue;
    }
    vec2 blocked;
    if (filterSize > 1)
    {
      blocked = blockedTexels(point, i, layer);
    }
    else
    {
      float depth = mapDepth(point.std.xy, layer);
      blocked.x = blocksAt(point, point.std.xy, depth, layer) ? 1.0 : 0.0;
      blocked.y = blocked.x > 0.0 ? reachOf(i, point.std.z, depth) : 0.0;
    }
    if (blocked.x < 1.0 && isInCrease(point, vec2(0.0), creaseReach + 0.5 * float(filterSize - 1), layer))
    {
      blocked = vec2(1.0, blocked.y / max(blocked.x, 1e-6));
    }
    sums.rgb += sampleWeights[i] * vec3(1.0, 1.0 - blocked.x, blocked.y);
  }
  return sums;
}
