// From a point of the map to the pixel that sees it, and whether that pixel's row can stand for the
// row that is needed there.

uniform sampler2DArray receiverPoints; // (s, t, d, reach of the search; < 0: blocked, 0: none to reuse)
uniform mat4 mapToScreen;              // homogeneous map coordinates to texture coordinates of the screen
uniform int reusePublished;            // 1: the paper's own criterion
uniform vec2 reusePublishedLimits;     // alpha, beta as distances from the light and from the camera
uniform float reuseSnap;               // largest distance to the pixel's point, in half widths
uniform vec2 screenSize;               // pixels

// The walk along the column through a receiver: offsets are in map coordinates.
struct ColumnWalk
{
  vec4 start; // homogeneous texture coordinates of the screen
  vec4 step;  // per unit of offset
};

ColumnWalk startWalk(MapPoint point)
{
  // The receiver's own plane continues in its depth; the paper keeps the depth.
  float slope = reusePublished == 1 ? 0.0 : dot(point.gradient, columnAxis);
  return ColumnWalk(mapToScreen * vec4(point.std, 1.0), mapToScreen * vec4(columnAxis, slope, 0.0));
}

// The point of the pixel at a place of the screen; none to reuse beside the screen.
vec4 receiverPointAt(vec2 place)
{
  bool isOnScreen = all(greaterThanEqual(place, vec2(0.0))) && all(lessThan(place, vec2(1.0)));
  return isOnScreen ? textureLod(receiverPoints, vec3(place, 0.0), 0.0) : vec4(0.0);
}

// Texture coordinates of the pixel that sees the column's point; outside [0, 1]^2 if none does.
vec2 screenAt(ColumnWalk walk, float offset)
{
  vec4 screen = walk.start + offset * walk.step;
  return screen.w > 0.0 ? screen.xy / screen.w : vec2(-1.0);
}

// The rows of a column: one per pixel that its image crosses, or per so many pixels that there are no
// more rows than taps. So rows lie in the middle of pixels along one axis of the screen.
struct ColumnRows
{
  vec2 axis;    // of the screen, the one that the column is closer to
  float stride; // between rows, in half widths
  int reach;     // rows -reach to reach; negative: the column is too short on the screen
};

// Columns that cross fewer pixels than this are read from the map.
const float shortestColumn = 4.0;

ColumnRows planRows(ColumnWalk walk, float halfWidth, int taps)
{
  vec2 screen = walk.start.xy / walk.start.w;
  vec2 rate = abs((walk.step.xy - screen * walk.step.w) / walk.start.w * screenSize);
  float pixels = 2.0 * halfWidth * max(rate.x, rate.y);
  float stride = 2.0 * max(ceil(pixels / float(taps)), 1.0) / pixels;
  vec2 axis = rate.x > rate.y ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
  return ColumnRows(axis, stride, pixels < shortestColumn ? -1 : int(1.0 / stride + 0.5));
}

// The part of the column that a row stands for: its middle and its length, in half widths.
vec2 cellOfRow(ColumnRows rows, int i)
{
  float low = max((float(i) - 0.5) * rows.stride, -1.0);
  float high = min((float(i) + 0.5) * rows.stride, 1.0);
  return vec2(0.5 * (low + high), high - low);
}

// How far the pixel's point lies off the receiver's plane, in depth.
float offPlane(MapPoint point, vec3 std)
{
  return abs(std.z - point.std.z - dot(point.gradient, std.xy - point.std.xy));
}

// Whether the pixel's point is where the row is needed: it may be off by the raster of the screen.
bool isNear(vec3 std, vec2 expected, vec2 halfWidth)
{
  return all(lessThanEqual(abs(std.xy - expected), reuseSnap * halfWidth));
}
