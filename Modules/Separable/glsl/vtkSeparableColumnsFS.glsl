//VTK::System::Dec
//VTK::Output::Dec

// Step 2: the blocker search's column of rows, hence the penumbra, and the middle row of the filter.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowDepthMap
//SoftShadows::Include vtkShadowKernel
//SoftShadows::Include vtkShadowBlocker
//Separable::Rows
//Separable::Reuse

uniform mat4 viewToMap;
uniform sampler2DArray searchRows;
uniform float alpha;
uniform float rowTotal; // weight of all taps of a filter's row

// Rows whose mean is the middle row of the filter: four leave 0.02 dB to ten.
const int mostMiddleRows = 4;
// A row's own search may reach farther or less far by this share.
const float reachTolerance = 0.5;

bool canReuse(MapPoint point, float reach, vec4 other, vec2 expected)
{
  if (other.w == 0.0)
  {
    return false;
  }
  if (reusePublished == 1)
  {
    return abs(linearDepth(other.z) - linearDepth(point.std.z)) < reusePublishedLimits.x;
  }
  // A row that was searched from another plane is as wrong as its distance is large.
  float otherReach = abs(other.w);
  return offPlane(point, other.xyz) < alpha * (point.std.z - nearestDepth) &&
    isNear(other.xyz, expected, kernelScale * reach) &&
    (otherReach <= leastReach || abs(otherReach - reach) <= reachTolerance * reach);
}

// Sum and number of the blockers, all rows read from the map.
vec2 readBlockers(MapPoint point, vec2 halfWidth, int rows, int taps)
{
  vec2 total = vec2(0.0);
  for (int j = 0; j < rows; ++j)
  {
    addSearchRow(point, tapCoordinate(j, rows), halfWidth, taps, total);
  }
  return total;
}

// Sum and number of the blockers in the chord of a row that another pixel has taken, whose search
// reaches so many times as far as this one's.
vec2 blockersInRow(MapPoint point, vec3 pixel, float chord, vec2 offset, float farther)
{
  vec4 row = textureLod(searchRows, pixel, 0.0);
  vec2 whole = row.xy + row.zw;
  // Across the row its blockers are asked together whether the light reaches them.
  if (whole.y <= 0.0 || !reaches(point, offset, mapDepthOfLinear(whole.x / whole.y)))
  {
    return vec2(0.0);
  }
  float end = min(chord / farther, 1.0);
  vec2 inChord = row.xy * min(end / searchNode, 1.0) +
    row.zw * max((end - searchNode) / (1.0 - searchNode), 0.0);
  return inChord * farther; // whose taps are so much farther apart
}

// Sum and number of the blockers, and the share of reused rows.
vec3 gatherBlockers(MapPoint point, float reach, ColumnWalk walk, ColumnRows rows, int taps)
{
  vec2 halfWidth = kernelScale * reach;
  vec2 total = vec2(0.0);
  float reused = 0.0;
  for (int i = -rows.reach; i <= rows.reach; ++i)
  {
    float y = float(i) * rows.stride;
    vec2 cell = cellOfRow(rows, i);
    float share = lineWeight(cell.x, columnAxis) * cell.y;
    vec2 offset = y * columnAxis * halfWidth;
    vec3 pixel = vec3(screenAt(walk, dot(offset, columnAxis)), 0.0);
    vec4 other = receiverPointAt(pixel.xy);
    if (canReuse(point, reach, other, point.std.xy + offset))
    {
      total += share * blockersInRow(point, pixel, chordAt(cell.x), offset, abs(other.w) / reach);
      reused += 1.0;
    }
    else
    {
      vec2 row = vec2(0.0);
      addSearchRow(point, cell.x, halfWidth, taps, row);
      // The weight along the column is in the row already, and it has fewer taps than a reused one.
      total += row * cell.y * float(searchWidth) / float(taps);
    }
  }
  return vec3(total, reused / float(2 * rows.reach + 1));
}

// Taps of a row, or rows, that are read for want of one to reuse. A mean depth needs a third of the taps
// of a kernel, if these are not too few to meet a narrow blocker: one for every two texels of the map.
int tapsOfSearch(float halfWidth)
{
  const int least = 12;
  int taps = tapsThatMatter(searchWidth, halfWidth);
  int enough = max(max((searchWidth + 2) / 3, least), int(halfWidth * depthMapSize) + 1);
  return reusePublished == 1 ? taps : min(taps, enough);
}

// Mean map depth of the blockers, infinitelyFar if there are none, and the share of reused rows.
vec2 searchBlockers(MapPoint point, float reach)
{
  vec2 halfWidth = kernelScale * reach;
  vec3 total = vec3(0.0);
  if (alpha == 0.0)
  {
    total.xy = readBlockers(point, halfWidth, searchWidth, searchWidth);
  }
  else
  {
    ColumnWalk walk = startWalk(point);
    float halfColumn = dot(halfWidth, columnAxis);
    ColumnRows rows = planRows(walk, halfColumn, searchWidth);
    int taps = tapsOfSearch(dot(halfWidth, rowAxis));
    if (rows.reach < 0)
    {
      total.xy = readBlockers(point, halfWidth, tapsOfSearch(halfColumn), taps);
    }
    else
    {
      total = gatherBlockers(point, reach, walk, rows, taps);
    }
  }
  return vec2(total.y > 0.0 ? mapDepthOfLinear(total.x / total.y) : infinitelyFar, total.z);
}

// Adds the weights of the blocked taps in a row beside the middle one, up to the first node, the
// second, and the end; and in w, of all taps.
void addMiddleRow(MapPoint point, float halfWidth, float beside, int taps, inout vec4 row)
{
  bool centerLit = !isBlocked(point, point.std.xy, mapLayer);
  for (int i = 0; i < taps; ++i)
  {
    float x = tapCoordinate(i, taps);
    float tapShare = lineWeight(x, rowAxis);
    row.w += tapShare;
    vec2 offset = x * halfWidth * rowAxis + beside * columnAxis;
    if (blocksFilter(point, offset, centerLit, mapLayer))
    {
      row.xyz += abs(x) < filterNodes.x - nodeSlack
        ? vec3(tapShare, 0.0, 0.0)
        : (abs(x) < filterNodes.y - nodeSlack ? vec3(0.0, tapShare, 0.0) : vec3(0.0, 0.0, tapShare));
    }
  }
}

// The middle row of the filter: the mean of several rows across the part of a column that it will
// stand for, so that a column has about as many rows as taps, however few pixels it crosses.
vec3 filterMiddleRow(MapPoint point, vec2 halfWidth)
{
  float halfColumn = dot(halfWidth, columnAxis);
  float halfRow = dot(halfWidth, rowAxis);
  ColumnRows rows = planRows(startWalk(point), halfColumn, filterWidth);
  int count = clamp(filterWidth / (2 * rows.reach + 1), 1, mostMiddleRows);
  float cell = rows.reach < 0 ? 0.0 : rows.stride * halfColumn;
  // The parts of a disk's rows need all taps; else several rows share the work.
  int taps = emitterDisk == 1 ? filterWidth : tapsThatMatter(filterWidth, 0.25 * halfRow);
  vec4 sum = vec4(0.0);
  for (int j = 0; j < count; ++j)
  {
    addMiddleRow(point, halfRow, 0.5 * tapCoordinate(j, count) * cell, taps, sum);
  }
  return sum.xyz * (rowTotal / sum.w);
}

void main()
{
  Receiver receiver;
  loadReceiver(ivec2(gl_FragCoord.xy), receiver);
  MapPoint point = toMap(viewToMap, receiver);
  vec2 search = searchBlockers(point, searchReach(point));
  // w: the depth between receiver and blockers, which is the filter's width.
  bool isLit = search.x == infinitelyFar;
  float gap = isLit ? 0.0 : max(point.std.z - search.x, 0.0);
  vec4 row = vec4(0.0, 0.0, 0.0, isLit ? SEPARABLE_LIT_ROW : gap);
  if (!(point.facesCenter && dot(abs(point.gradient), kernelScale) < 1.0))
  {
    // The receiver's own surface hides some of the light, a part that is no product of rows.
    row = vec4(gap, 0.0, 0.0, SEPARABLE_NO_ROW);
  }
  else if (!isLit)
  {
    row.xyz = filterMiddleRow(point, gap * kernelScale);
  }
  gl_FragData[0] = row;
  gl_FragData[1] = vec4(search.y);
}
