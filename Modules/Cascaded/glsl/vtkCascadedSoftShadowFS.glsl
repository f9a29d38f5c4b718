//VTK::System::Dec
#ifdef GL_ARB_texture_gather
#extension GL_ARB_texture_gather : enable
#ifndef SOFT_SHADOW_NO_GATHER
#define SOFT_SHADOW_GATHER
#endif
#endif
//VTK::Output::Dec

// A cascade's part of the visibility, weighted by how much of the receiver's depth is the cascade's.
//
// Every point of the light stands for a cell around it. A blocker's edge, as its map shows it, is
// blurred as the cell itself would blur it: over a box that is the image of the cell at the depth of
// the blockers. Cells side by side are the light, so the mean over all has no steps.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowDepthMap

uniform vec2 fadeIn;     // depths over which the cascade's weight rises
uniform vec2 fadeOut;    // and falls
uniform float litWeight; // of the points that see everything

// The points' maps are affine images of one of them, the base: a row for each of s, t and d.
uniform mat4 viewToBase;
uniform vec4 baseToMaps[3 * SOFT_SHADOW_SAMPLES_PER_DRAW];
// x: the point's weight; yz: on which side of the light's middle it lies, along both axes.
uniform vec4 points[SOFT_SHADOW_SAMPLES_PER_DRAW];
uniform int sampleCount;
uniform float totalWeight; // of these points
uniform float firstLayer;
uniform int filterSize;  // of the widest box, in texels
uniform vec2 cellScale;  // half a cell's image in the base, per unit of depth between blocker and receiver
uniform int fixedFilter; // 1: the box is always filterSize wide
uniform int wideFilter;  // 1: it may be wider, with as many taps

// A point's map: where the receiver lies in it, and half a cell's image per unit of depth.
struct Sample
{
  MapPoint point;
  vec2 cell;
  float layer;
};

Sample toSample(MapFrame base, int i)
{
  vec4 rows[3] = vec4[3](baseToMaps[3 * i], baseToMaps[3 * i + 1], baseToMaps[3 * i + 2]);
  Sample result;
  result.point = toPoint(moveFrame(base, rows[0], rows[1], rows[2]));
  result.cell = cellScale * abs(vec2(rows[0].x, rows[1].y) / rows[2].z);
  result.layer = firstLayer + float(i);
  return result;
}

// The depths of the four texels around a corner of texels: upper left, upper right, lower right,
// lower left, as textureGather returns them. Empty ones are infinitely far.
vec4 depthsAround(vec2 corner, float layer)
{
  vec2 st = corner / depthMapSize;
#ifdef SOFT_SHADOW_GATHER
  vec4 depths = textureGather(depthMaps, vec3(st, layer));
#else
  vec2 half2 = vec2(0.5, -0.5) / depthMapSize;
  vec4 depths = vec4(textureLod(depthMaps, vec3(st + half2.yx, layer), 0.0).r,
    textureLod(depthMaps, vec3(st + half2.xx, layer), 0.0).r,
    textureLod(depthMaps, vec3(st + half2.xy, layer), 0.0).r,
    textureLod(depthMaps, vec3(st + half2.yy, layer), 0.0).r);
#endif
  return mix(vec4(infinitelyFar), depths, lessThan(depths, vec4(emptyDepth)));
}

// Which of four texels block part of the cell: nearer to the light than the receiver's plane, and
// no farther aside than the cell's image at their depth. Facets and
// steps near the receiver hide none of the cell, however far the box reaches over them.
vec4 blockersAround(Sample at, vec2 corner, vec4 depths)
{
  MapPoint point = at.point;
  float texel = 1.0 / depthMapSize;
  vec2 reach = 0.5 * texel * point.gradient;
  vec4 planes = planeDepth(point, corner * texel) - point.bias +
    vec4(reach.y - reach.x, reach.y + reach.x, reach.x - reach.y, -reach.x - reach.y);
  vec4 nearer = vec4(lessThan(depths, min(planes, vec4(point.std.z))));
  vec2 aside = corner - point.std.xy * depthMapSize;
  vec4 asideS = abs(aside.x + vec4(-0.5, 0.5, 0.5, -0.5)) - 0.5;
  vec4 asideT = abs(aside.y + vec4(0.5, 0.5, -0.5, -0.5)) - 0.5;
  vec4 heights = depthMapSize * (point.std.z - depths);
  // The narrowest box is a texel wide.
  vec4 inCell = vec4(lessThan(asideS, max(at.cell.x * heights, 0.5))) *
    vec4(lessThan(asideT, max(at.cell.y * heights, 0.5)));
  return fixedFilter == 1 ? nearer : nearer * inCell;
}

// How much of the texels lies between low and high, along one axis.
vec2 overlap(float texel, float low, float high)
{
  return clamp(min(vec2(texel + 1.0, texel + 2.0), high) - max(vec2(texel, texel + 1.0), low), 0.0, 1.0);
}

// Whether a map's texel blocks the receiver's ray to the light through st.
bool isHidden(MapPoint point, vec2 st, float layer, out float depth)
{
  depth = mapDepth(st, layer);
  return isBlocker(point, st, depth);
}

// Half the widest image of the cell, in texels: no blocker lies in front of the near plane.
vec2 reachOf(Sample at)
{
  vec2 image = depthMapSize * at.cell * max(at.point.std.z, 0.0);
  image = wideFilter == 1 ? image : min(image, 0.5 * float(filterSize));
  return fixedFilter == 1 ? vec2(0.5 * float(filterSize)) : max(image, 0.5);
}

// Where tap i of filterSize lies along both axes of a box of that width around the receiver.
vec2 tapPlace(vec2 center, vec2 width, int x, int y)
{
  return center + width * ((vec2(x, y) + 0.5) / float(filterSize) - 0.5);
}

// (weight, weight x distance to the receiver's depth) of blockers at these distances. A texel hides a
// part of the cell that grows with the inverse square of the distance, up to all of it.
vec2 weigh(Sample at, vec4 heights, vec4 blocking)
{
  vec2 image = depthMapSize * at.cell;
  vec4 areas = max(image.x * heights, 0.5) * max(image.y * heights, 0.5);
  vec4 weights = blocking / areas;
  return vec2(dot(weights, vec4(1.0)), dot(weights, heights));
}

// The blockers that taps over the box find, weighed.
vec2 searchBlockers(Sample at, vec2 center, vec2 reach)
{
  vec2 found = vec2(0.0);
  if (any(greaterThan(2.0 * reach, vec2(filterSize))))
  {
    for (int y = 0; y < filterSize; ++y)
    {
      for (int x = 0; x < filterSize; ++x)
      {
        vec2 place = tapPlace(center, 2.0 * reach, x, y);
        float depth;
        bool hidden = isHidden(at.point, place / depthMapSize, at.layer, depth);
        float height = at.point.std.z - depth;
        hidden = hidden && all(lessThan(abs(place - center) - 0.5, max(depthMapSize * at.cell * height, 0.5)));
        found += weigh(at, vec4(max(height, 0.0)), vec4(hidden, 0.0, 0.0, 0.0));
      }
    }
    // What the taps are too far apart for.
    float depth;
    bool hidden = isHidden(at.point, at.point.std.xy, at.layer, depth);
    found += weigh(at, vec4(max(at.point.std.z - depth, 0.0)), vec4(hidden, 0.0, 0.0, 0.0));
    return found;
  }
  vec2 texel = floor(center - reach);
  vec2 end = ceil(center + reach);
  for (float y = texel.y; y < end.y; y += 2.0)
  {
    for (float x = texel.x; x < end.x; x += 2.0)
    {
      vec2 corner = vec2(x, y) + 1.0;
      vec4 depths = depthsAround(corner, at.layer);
      vec4 blocking = blockersAround(at, corner, depths);
      vec4 heights = at.point.std.z - min(depths, vec4(at.point.std.z));
      found += weigh(at, heights, blocking);
    }
  }
  return found;
}

// Whether what a box shows at a place is a part of the cell in front of the receiver's plane.
float faces(Sample at, vec2 center, vec2 width, vec2 place)
{
  vec2 inCell = clamp(2.0 * (place - center) / width, -1.0, 1.0);
  return fixedFilter == 1 || facesPoint(at.point, at.cell, inCell) ? 1.0 : 0.0;
}

// The share of a box that blocks, as far as the receiver's plane faces its part of the cell: of all its texels by the part inside, or, if they are more than
// filterSize along an edge, as many taps between four texels each.
float blockedShare(Sample at, vec2 center, vec2 width)
{
  float blocked = 0.0;
  float sum = 0.0;
  if (any(greaterThan(width, vec2(filterSize))))
  {
    for (int y = 0; y < filterSize; ++y)
    {
      for (int x = 0; x < filterSize; ++x)
      {
        vec2 place = tapPlace(center, width, x, y) - 0.5;
        vec2 corner = floor(place) + 1.0;
        vec2 part = place + 1.0 - corner;
        vec4 blocking = blockersAround(at, corner, depthsAround(corner, at.layer));
        vec2 columns = vec2(1.0 - part.x, part.x);
        float weight = faces(at, center, width, place + 0.5);
        sum += weight;
        blocked += weight * dot(blocking, vec4(columns * part.y, columns.yx * (1.0 - part.y)));
      }
    }
    return sum > 0.0 ? min(blocked / sum, 1.0) : 0.0;
  }
  vec2 low = center - 0.5 * width;
  vec2 high = center + 0.5 * width;
  vec2 texel = floor(low);
  for (float y = texel.y; y < high.y; y += 2.0)
  {
    vec2 rows = overlap(y, low.y, high.y);
    for (float x = texel.x; x < high.x; x += 2.0)
    {
      vec2 columns = overlap(x, low.x, high.x);
      vec2 corner = vec2(x, y) + 1.0;
      vec4 blocking = blockersAround(at, corner, depthsAround(corner, at.layer));
      float weight = faces(at, center, width, corner);
      sum += weight * (columns.x + columns.y) * (rows.x + rows.y);
      blocked += weight * dot(blocking, vec4(columns * rows.y, columns.yx * rows.x));
    }
  }
  // Not above 1, whatever the rounding: a visibility below 0 would say that there is none.
  return sum > 0.0 ? min(blocked / sum, 1.0) : 0.0;
}

// The share of a point's cell that is seen.
float cellVisibility(Sample at)
{
  if (filterSize == 1)
  {
    float depth;
    return isHidden(at.point, at.point.std.xy, at.layer, depth) ? 0.0 : 1.0;
  }
  vec2 center = at.point.std.xy * depthMapSize;
  if (fixedFilter == 1)
  {
    return 1.0 - blockedShare(at, center, vec2(filterSize));
  }
  vec2 found = searchBlockers(at, center, reachOf(at));
  if (found.x == 0.0)
  {
    return 1.0;
  }
  vec2 width = 2.0 * depthMapSize * at.cell * found.y / found.x;
  width = wideFilter == 1 ? width : min(width, float(filterSize));
  return 1.0 - blockedShare(at, center, max(width, 1.0));
}

// Of the cell's size, per distance of the plane's horizon from it.
const float grazing = 1.0 / 16.0;

// 1: lit, 0: umbra, -1: neither is certain. Looks at the points themselves, and at the outer corners of
// their cells: behind the blockers that hide the points, or as far aside as the box reaches.
float classify(MapFrame base)
{
  bool anyLit = false;
  bool anyHidden = false;
  for (int i = 0; i < sampleCount; ++i)
  {
    Sample at = toSample(base, i);
    if (!at.point.facesCenter)
    {
      anyHidden = true;
      continue;
    }
    // Where the light nearly grazes the plane, a texel's slope hides more than a tap can tell.
    if (dot(abs(at.point.gradient), at.cell) > grazing)
    {
      return -1.0;
    }
    float depth;
    bool hidden = isHidden(at.point, at.point.std.xy, at.layer, depth);
    vec2 side = points[i].yz;
    vec2 reach = hidden ? at.cell * (at.point.std.z - depth) : reachOf(at) / depthMapSize;
    bool outerHidden = isHidden(at.point, at.point.std.xy + side * reach, at.layer, depth);
    anyLit = anyLit || !hidden || !outerHidden;
    anyHidden = anyHidden || hidden || outerHidden;
    if (anyLit && anyHidden)
    {
      return -1.0;
    }
  }
  return anyLit ? 1.0 : 0.0;
}

float cellsVisibility(MapFrame base)
{
  if (fixedFilter == 0 && sampleCount > 3)
  {
    float known = classify(base);
    if (known >= 0.0)
    {
      return known * totalWeight;
    }
  }
  float visibility = 0.0;
  for (int i = 0; i < sampleCount; ++i)
  {
    Sample at = toSample(base, i);
    // A plane that the camera sees from behind is its own blocker, within the bias of the map.
    if (at.point.facesCenter)
    {
      visibility += points[i].x * cellVisibility(at);
    }
  }
  return visibility;
}

void main()
{
  Receiver receiver;
  loadReceiver(ivec2(gl_FragCoord.xy), receiver);
  float depth = -receiver.positionVs.z;
  float share = smoothstep(fadeIn.x, fadeIn.y, depth) * (1.0 - smoothstep(fadeOut.x, fadeOut.y, depth));
  float visibility = 0.0;
  if (share > 0.0)
  {
    visibility = litWeight;
    if (sampleCount > 0)
    {
      visibility += cellsVisibility(toFrame(viewToBase, receiver.positionVs, receiver.normalVs));
    }
    visibility *= share;
  }
  gl_FragData[0] = vec4(visibility);
}
