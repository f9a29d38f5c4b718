// A receiver in the coordinates of a depth map.
//
// Map coordinates (s, t, d), s and t in [0, 1] and d in [-1, 0], near to far, are a projective image of
// space: planes stay planes. The depth map holds -d. The
// receiver's plane is d = std.z + gradient . (st - std.xy), for every tap of a kernel, exactly.
// Needs vtkShadowReceiver.

uniform sampler2DArray depthMaps;
uniform float depthMapSize; // texels along an edge

struct MapPoint
{
  vec3 std;
  vec2 gradient; // slope of the receiver's plane, d per s and per t
  float bias;    // what rounding and the bend of the surface may add to a depth that is its own
  bool facesCenter; // the map's centre of projection is on the camera's side of the plane
  vec2 lift; // unit vector in (s, t): which way the receiver moves along its normal; 0: it is no surface
};

// Relative rounding of a view position after interpolation, and of the product with a matrix.
const float positionRounding = 4e-7;
// Spacing of 32-bit depths below 1, twice: the map's value and the rasteriser's interpolation. Relative
// to what depths are sums of.
const float depthRounding = 2.4e-7;
// In texels: 8 bits of subpixel precision.
const float vertexSnapping = 0.004;
// How far a surface bends towards the light within a texel, in texels.
const float surfaceBend = 0.3;

// What of a receiver is the same for all maps that are affine images of each other.
struct MapFrame
{
  vec3 std;
  vec3 normal;   // cross product of two tangents of the receiver's plane
  vec3 rounding; // of std
  float least;   // below this normal.z is noise
  float bend;    // times 1 / normal.z: how far the surface bends towards the light
  float size;    // of what depths around here are sums of, at most 1
  vec3 lift;     // of a step along the normal of a surface
};

MapFrame toFrame(mat4 viewToMap, Receiver receiver)
{
  vec3 normalVs = receiver.normalVs;
  MapFrame frame;
  vec4 homogeneous = viewToMap * vec4(receiver.positionVs, 1.0);
  float w = homogeneous.w;
  frame.std = homogeneous.xyz / w;

  // The plane, from two tangents: differentials have no cancellation, absolute positions would.
  vec3 axis = abs(normalVs.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
  vec3 tangent1 = normalize(cross(normalVs, axis));
  vec3 tangent2 = cross(normalVs, tangent1);
  vec4 h1 = viewToMap * vec4(tangent1, 0.0);
  vec4 h2 = viewToMap * vec4(tangent2, 0.0);
  vec3 d1 = (h1.xyz - frame.std * h1.w) / w;
  vec3 d2 = (h2.xyz - frame.std * h2.w) / w;
  frame.normal = cross(d1, d2);
  // Edge-on planes have no slope.
  frame.least = max(1e-5 * length(d1) * length(d2), 1e-37);

  // Rounding of (s, t, d): each is a sum of products of the matrix and the position, over w.
  vec4 magnitude = vec4(abs(receiver.positionVs), 1.0);
  mat4 absolute = mat4(abs(viewToMap[0]), abs(viewToMap[1]), abs(viewToMap[2]), abs(viewToMap[3]));
  vec4 sums = absolute * magnitude;
  frame.rounding = positionRounding * (sums.xyz + abs(frame.std) * sums.w) / abs(w);
  // In perspective all of a far depth is small; in parallel it is the small rest of large numbers.
  bool isPerspective =
    viewToMap[0][3] != 0.0 || viewToMap[1][3] != 0.0 || viewToMap[2][3] != 0.0;
  frame.size = isPerspective ? min(sums.z / abs(w), 1.0) : 1.0;
  // The rasteriser snaps vertices to a fraction of a texel.
  frame.rounding.xy += vertexSnapping / depthMapSize;

  // Taps compare at texel centres, where a plane's own depth is exact. Within a texel a mesh may bend
  // towards the light by a part of the texel's width, along the normal, but no flat one.
  vec4 hn = viewToMap * vec4(normalVs, 0.0);
  vec3 dn = (hn.xyz - frame.std * hn.w) / w;
  float texelsPerLength = depthMapSize * max(length(d1.xy), length(d2.xy));
  float bend = surfaceBend / texelsPerLength;
  frame.bend = (receiver.rise < 0.0 ? bend : min(bend, receiver.rise)) * abs(dot(frame.normal, dn));
  frame.lift = receiver.rise >= 0.0 ? dn : vec3(0.0);
  return frame;
}

// The frame in another map, which is an affine image of this one: rows of the matrix from (s, t, d, 1).
MapFrame moveFrame(MapFrame frame, vec4 rowS, vec4 rowT, vec4 rowD)
{
  vec4 std = vec4(frame.std, 1.0);
  frame.std = vec3(dot(rowS, std), dot(rowT, std), dot(rowD, std));
  // Planes are multiplied by the matrix' cofactors.
  frame.normal = vec3(dot(cross(rowT.xyz, rowD.xyz), frame.normal),
    dot(cross(rowD.xyz, rowS.xyz), frame.normal), dot(cross(rowS.xyz, rowT.xyz), frame.normal));
  frame.lift = vec3(dot(rowS.xyz, frame.lift), dot(rowT.xyz, frame.lift), dot(rowD.xyz, frame.lift));
  return frame;
}

MapPoint toPoint(MapFrame frame)
{
  MapPoint point;
  point.std = frame.std;
  point.facesCenter = frame.normal.z > 0.0;
  float slope = 1.0 / max(abs(frame.normal.z), frame.least);
  point.gradient = (point.facesCenter ? -slope : slope) * frame.normal.xy;
  point.bias = depthRounding * frame.size + frame.rounding.z + dot(abs(point.gradient), frame.rounding.xy) +
    slope * frame.bend;
  point.lift = frame.lift.xy / max(length(frame.lift.xy), 1e-37);
  return point;
}

MapPoint toMap(mat4 viewToMap, Receiver receiver)
{
  return toPoint(toFrame(viewToMap, receiver));
}

// The depth of the receiver's plane.
float planeDepth(MapPoint point, vec2 st)
{
  return point.std.z + dot(point.gradient, st - point.std.xy);
}

// The centre of the texel around st. Drivers round coordinates to a fraction of a texel before they
// choose one; at its centre all of them choose the same.
vec2 texelCenter(vec2 st)
{
  return (floor(st * depthMapSize) + 0.5) / depthMapSize;
}

// Whether a texel of that depth, which a tap at st reads, can block the receiver: it lies on the
// camera's side of the receiver's plane, and nearer to the light, since no ray to the light leads away
// from it. Where the centre is behind the plane, the camera's side is the far one.
bool isBlocker(MapPoint point, vec2 st, float depth)
{
  float plane = planeDepth(point, texelCenter(st));
  bool inFront = point.facesCenter ? depth < plane - point.bias : depth > plane + point.bias;
  return inFront && depth < point.std.z;
}

// An empty texel: nothing blocks there, however far behind the map's far plane the receiver is.
const float emptyDepth = 0.0;
// Of the near plane; what lies in front of it is drawn on it.
const float nearestDepth = -1.0;
const float infinitelyFar = 1e30;

// The map's depth; beyond its border nothing blocks, whatever a sampler makes of it.
float mapDepth(vec2 st, float layer)
{
  vec2 center = texelCenter(st);
  float depth = -textureLod(depthMaps, vec3(center, layer), 0.0).r;
  bool isInMap = all(lessThan(abs(center - 0.5), vec2(0.5)));
  return isInMap && depth < emptyDepth ? depth : infinitelyFar;
}

#ifdef SOFT_SHADOW_GATHER
// Of the four texels around a corner of texels, in the order of textureGather: those of -s +t, +s +t,
// +s -t, -s -t.
vec4 mapDepthsAround(vec2 corner, float layer)
{
  vec4 depths = -textureGather(depthMaps, vec3(corner / depthMapSize, layer));
  vec4 places = vec4(corner - 0.5, corner + 0.5) / depthMapSize;
  vec4 isInside = vec4(lessThan(abs(places - 0.5), vec4(0.5)));
  depths *= isInside.xzzx * isInside.wwyy;
  return mix(vec4(infinitelyFar), depths, lessThan(depths, vec4(emptyDepth)));
}
#endif

// Of a surface that shows in a texel: how far in front it may be, in biases, to be looked at for
// whether it meets the receiver's plane nearby; and by how much more texels may differ that show it.
const float nearbyGap = 10.0;
const float nearbyRise = 20.0;
// Surfaces bend towards the edge where they meet others: in shares of the way there.
const float nearbyBend = 1.5;

// How far the texel around st is in front of the receiver's plane, in depth.
float gapOf(MapPoint point, vec2 texel, float layer)
{
  vec2 center = texel / depthMapSize;
  return planeDepth(point, center) - mapDepth(center, layer);
}

// Whether the surface that a texel shows, given by its centre in texels and its depth, continues to the
// receiver's plane before it is over st, within a texel of it. The centre then lies beyond a concave
// edge and st before it, since nothing can be seen behind one. Texels on the other side of st must show
// the plane itself.
bool meetsPlane(MapPoint point, vec2 st, vec2 texel, float depth, float layer)
{
  float gap = planeDepth(point, texel / depthMapSize) - depth;
  if (!point.facesCenter || gap > nearbyGap * point.bias)
  {
    return false;
  }
  vec2 offset = st * depthMapSize - texel;
  vec2 side = vec2(offset.x < 0.0 ? -1.0 : 1.0, offset.y < 0.0 ? -1.0 : 1.0);
  vec2 sideX = vec2(side.x, 0.0);
  vec2 sideY = vec2(0.0, side.y);
  vec2 rise = vec2(gapOf(point, texel - sideX, layer), gapOf(point, texel - sideY, layer)) - gap;
  // Where it rises by more, something else begins.
  rise = mix(rise, vec2(0.0), greaterThan(rise, vec2(nearbyRise * point.bias)));
  vec2 fall = rise * min(nearbyBend * abs(offset), vec2(1.0));
  bvec3 meets = greaterThanEqual(vec3(fall, fall.x + fall.y), vec3(gap));
  if (!any(meets))
  {
    return false;
  }
  vec3 beside = vec3(gapOf(point, texel + sideX, layer), gapOf(point, texel + sideY, layer),
    gapOf(point, texel + side, layer));
  return any(lessThanEqual(mix(vec3(infinitelyFar), abs(beside), meets), vec3(point.bias)));
}

// Whether the texel around st, of that depth, blocks a ray that crosses the map at st.
bool blocksAt(MapPoint point, vec2 st, float depth, float layer)
{
  return isBlocker(point, st, depth) && !meetsPlane(point, st, floor(st * depthMapSize) + 0.5, depth, layer);
}

bool isBlocked(MapPoint point, vec2 st, float layer)
{
  return blocksAt(point, st, mapDepth(st, layer), layer);
}

// Whether the point of the emitter at window coordinates e is on the camera's side of the receiver's
// plane. What lies behind it is blocked by the surface itself.
bool facesPoint(MapPoint point, vec2 kernelScale, vec2 e)
{
  return (1.0 + dot(point.gradient, kernelScale * e) > 0.0) == point.facesCenter;
}
