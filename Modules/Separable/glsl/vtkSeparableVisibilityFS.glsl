//VTK::System::Dec
//VTK::Output::Dec

// Step 3: the filter's column of rows.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowDepthMap
//SoftShadows::Include vtkShadowCrease
//SoftShadows::Include vtkShadowKernel
//SoftShadows::Include vtkShadowBlocker
//Separable::Rows
//Separable::Reuse

uniform mat4 viewToMap;
uniform sampler2DArray filterRows; // xyz: blocked weights up to the nodes and the end, w: gap
uniform vec3 rowWeights;           // all weights of a row, likewise
uniform float beta;
uniform float widthTolerance;      // largest relative difference of the rows' widths
uniform float weight;
uniform int debugView;
uniform sampler2DArray searchShares; // read by the debug view alone

// A pixel nearer than this may stand for both of those that a row lies between.
const float leastShare = 0.3;

bool canReuse(MapPoint point, Receiver receiver, vec2 pixel, vec4 other, vec2 expected,
  float gap)
{
  if (other.w == 0.0)
  {
    return false;
  }
  if (reusePublished == 1)
  {
    // Distance along the camera's depth to the receiver's plane.
    vec3 positionVs = receiverAt(pixel).xyz;
    float away = abs(dot(positionVs - receiver.positionVs, receiver.normalVs));
    return away < reusePublishedLimits.y * abs(receiver.normalVs.z);
  }
  return offPlane(point, other.xyz) < beta * gap && isNear(other.xyz, expected, kernelScale * gap);
}

// How much of each part of a row lies in the chord.
vec3 partsOfChord(float chord)
{
  vec3 start = vec3(0.0, filterNodes);
  return clamp((chord - start) / (vec3(filterNodes, 1.0) - start), 0.0, 1.0);
}

// Weights of the blocked and of all taps, all rows read from the map.
vec2 readKernel(MapPoint point, vec2 halfWidth, int rows, int taps)
{
  vec2 total = vec2(0.0);
  for (int j = 0; j < rows; ++j)
  {
    addFilterRow(point, tapCoordinate(j, rows), halfWidth, taps, total);
  }
  return total;
}

// A row that another pixel has taken: the weight of its blocked taps; negative if it does not fit.
float blockedInRow(vec2 pixel, float gap, vec3 parts, bool blocked)
{
  vec4 row = textureLod(filterRows, vec3(pixel, 0.0), 0.0);
  if (row.w == SEPARABLE_PROVED)
  {
    // A pixel that was proved has no row: all its taps are like the middle one.
    return blocked ? dot(parts, rowWeights) : 0.0;
  }
  if (row.w == SEPARABLE_NO_ROW)
  {
    return -1.0;
  }
  // A pixel without blockers has a row of none, whatever its width.
  bool fits = row.w == SEPARABLE_LIT_ROW || reusePublished == 1 ||
    abs(row.w - gap) <= widthTolerance * gap;
  return fits ? dot(parts, row.xyz) : -1.0;
}

// The row at an offset, between the two pixels beside its place on the screen: the weight of its
// blocked taps; negative if neither pixel has a row that fits.
float reuseRow(MapPoint point, Receiver receiver, float gap, vec2 place, vec2 axis, vec2 offset, vec3 parts)
{
  vec2 across = 1.0 - axis;
  vec2 texel = place * screenSize - 0.5;
  vec2 lower = floor(texel + 0.5 * axis); // the nearest along the axis, the lower one across it
  float share = dot(texel - lower, across);
  vec2 total = vec2(0.0);
  for (int k = 0; k < 2; ++k)
  {
    vec2 pixel = (lower + 0.5 + float(k) * across) / screenSize;
    vec4 other = receiverPointAt(pixel);
    if (canReuse(point, receiver, pixel, other, point.std.xy + offset, gap))
    {
      float blocked = blockedInRow(pixel, gap, parts, other.w < 0.0);
      float weightOfPixel = blocked < 0.0 ? 0.0 : (k == 0 ? 1.0 - share : share);
      total += weightOfPixel * vec2(blocked, 1.0);
    }
  }
  return total.y < leastShare ? -1.0 : total.x / total.y;
}

// Weights of the blocked and of all taps, and the share of reused rows.
vec3 gatherKernel(MapPoint point, Receiver receiver, float gap, ColumnWalk walk, ColumnRows rows)
{
  vec2 halfWidth = kernelScale * gap;
  int taps = tapsThatMatter(filterWidth, dot(halfWidth, rowAxis));
  vec3 total = vec3(0.0);
  for (int i = -rows.reach; i <= rows.reach; ++i)
  {
    vec2 cell = cellOfRow(rows, i);
    vec2 offset = float(i) * rows.stride * columnAxis * halfWidth;
    vec2 place = screenAt(walk, dot(offset, columnAxis));
    vec3 parts = partsOfChord(chordAt(cell.x));
    float whole = dot(parts, rowWeights);
    float blocked = reuseRow(point, receiver, gap, place, rows.axis, offset, parts);
    if (blocked >= 0.0)
    {
      total.z += 1.0;
    }
    else
    {
      vec2 row = vec2(0.0);
      addFilterRow(point, cell.x, halfWidth, taps, row);
      blocked = row.y > 0.0 ? whole * row.x / row.y : 0.0;
    }
    total.xy += lineWeight(cell.x, columnAxis) * cell.y * vec2(blocked, whole);
  }
  return vec3(total.xy, total.z / float(2 * rows.reach + 1));
}

// Visibility, and the share of reused rows.
vec2 filterVisibility(MapPoint point, Receiver receiver, float gap)
{
  vec2 halfWidth = kernelScale * gap;
  vec3 total = vec3(0.0);
  if (beta == 0.0)
  {
    total.xy = readKernel(point, halfWidth, filterWidth, filterWidth);
  }
  else
  {
    ColumnWalk walk = startWalk(point);
    float halfColumn = dot(halfWidth, columnAxis);
    ColumnRows rows = planRows(walk, halfColumn, filterWidth);
    if (rows.reach < 0)
    {
      total.xy = readKernel(point, halfWidth, tapsThatMatter(filterWidth, halfColumn),
        tapsThatMatter(filterWidth, dot(halfWidth, rowAxis)));
    }
    else
    {
      total = gatherKernel(point, receiver, gap, walk, rows);
    }
  }
  return vec2(1.0 - total.x / total.y, total.z);
}

void main()
{
  Receiver receiver;
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  loadReceiver(pixel, receiver);
  MapPoint point = toMap(viewToMap, receiver);
  vec4 row = texelFetch(filterRows, ivec3(pixel, 0), 0);
  vec2 result = vec2(1.0, -1.0); // lit, and no rows
  if (row.w == SEPARABLE_NO_ROW)
  {
    vec2 total = readKernel(point, kernelScale * row.x, filterWidth, filterWidth);
    result = vec2(1.0 - total.x / total.y, 0.0);
  }
  else if (row.w != SEPARABLE_LIT_ROW)
  {
    result = filterVisibility(point, receiver, row.w);
  }
  if (result.x > 0.0 && isInCrease(point, kernelScale, creaseReach, mapLayer))
  {
    result.x = 0.0;
  }
  if (debugView == SEPARABLE_DEBUG_SEARCH)
  {
    result.x = texelFetch(searchShares, ivec3(pixel, 0), 0).r;
  }
  else if (debugView == SEPARABLE_DEBUG_FILTER)
  {
    result.x = abs(result.y); // 1 where no row was needed
  }
  // Rounding below 0 would say that there is no value.
  gl_FragData[0] = vec4(weight * max(result.x, 0.0));
  gl_FragData[1] = vec4(result.y);
}
