// A receiver in the coordinates of a depth map.
//
// Map coordinates (s, t, d) in [0, 1]^3 are a projective image of space: planes stay planes. The
// receiver's plane is d = std.z + gradient . (st - std.xy), for every tap of a kernel, exactly.

uniform sampler2DArray depthMaps;
uniform float depthMapSize; // texels along an edge

struct MapPoint
{
  vec3 std;
  vec2 gradient; // slope of the receiver's plane, d per s and per t
  float bias;    // what rounding and the bend of the surface may add to a depth that is its own
  bool facesCenter; // the map's centre of projection is on the camera's side of the plane
};

// Relative rounding of a view position after interpolation, and of the product with a matrix.
const float positionRounding = 4e-7;
// Spacing of 32-bit depths below 1, twice: the map's value and the rasteriser's interpolation.
const float depthRounding = 2.4e-7;
// In texels: 8 bits of subpixel precision.
const float vertexSnapping = 0.004;
// How far a surface bends towards the light within a texel, in texels.
const float surfaceBend = 0.3;

MapPoint toMap(mat4 viewToMap, vec3 positionVs, vec3 normalVs)
{
  MapPoint point;
  vec4 homogeneous = viewToMap * vec4(positionVs, 1.0);
  float w = homogeneous.w;
  point.std = homogeneous.xyz / w;

  // The slope, from two tangents: differentials have no cancellation, absolute positions would.
  vec3 axis = abs(normalVs.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
  vec3 tangent1 = normalize(cross(normalVs, axis));
  vec3 tangent2 = cross(normalVs, tangent1);
  vec4 h1 = viewToMap * vec4(tangent1, 0.0);
  vec4 h2 = viewToMap * vec4(tangent2, 0.0);
  vec3 d1 = (h1.xyz - point.std * h1.w) / w;
  vec3 d2 = (h2.xyz - point.std * h2.w) / w;
  float determinant = d1.x * d2.y - d2.x * d1.y;
  point.facesCenter = determinant > 0.0;
  // Edge-on planes have no slope; below this one the numbers are noise.
  float least = 1e-5 * length(d1) * length(d2);
  determinant = abs(determinant) < least ? (determinant < 0.0 ? -least : least) : determinant;
  point.gradient =
    vec2(d1.z * d2.y - d2.z * d1.y, d2.z * d1.x - d1.z * d2.x) / max(abs(determinant), 1e-37) *
    sign(determinant);

  // Rounding of (s, t, d): each is a sum of products of the matrix and the position, over w.
  vec4 magnitude = vec4(abs(positionVs), 1.0);
  mat4 absolute = mat4(abs(viewToMap[0]), abs(viewToMap[1]), abs(viewToMap[2]), abs(viewToMap[3]));
  vec4 sums = absolute * magnitude;
  vec3 rounding = positionRounding * (sums.xyz + abs(point.std) * sums.w) / abs(w);
  // The rasteriser snaps vertices to a fraction of a texel.
  rounding.xy += vertexSnapping / depthMapSize;

  // Taps compare at texel centres, where a plane's own depth is exact. Within a texel a mesh may bend
  // towards the light by a part of the texel's width, along the normal.
  vec4 hn = viewToMap * vec4(normalVs, 0.0);
  vec3 dn = (hn.xyz - point.std * hn.w) / w;
  float texelsPerLength = depthMapSize * max(length(d1.xy), length(d2.xy));
  float bend = surfaceBend / texelsPerLength * abs(dn.z - dot(point.gradient, dn.xy));
  point.bias = depthRounding + rounding.z + dot(abs(point.gradient), rounding.xy) + bend;
  return point;
}

// The depth of the receiver's plane.
float planeDepth(MapPoint point, vec2 st)
{
  return point.std.z + dot(point.gradient, st - point.std.xy);
}

// Whether a texel of that depth, which a tap at st reads, can block the receiver: it lies on the
// camera's side of the receiver's plane, and nearer to the light, since no ray to the light leads away
// from it. Where the centre is behind the plane, the camera's side is the far one.
bool isBlocker(MapPoint point, vec2 st, float depth)
{
  vec2 center = (floor(st * depthMapSize) + 0.5) / depthMapSize;
  float plane = planeDepth(point, center);
  bool inFront = point.facesCenter ? depth < plane - point.bias : depth > plane + point.bias;
  return inFront && depth < point.std.z;
}

// An empty texel: nothing blocks there, however far behind the map's far plane the receiver is.
const float emptyDepth = 1.0;
const float infinitelyFar = 1e30;

// The map's depth; beyond its border nothing blocks.
float mapDepth(vec2 st, float layer)
{
  float depth = textureLod(depthMaps, vec3(st, layer), 0.0).r;
  return depth < emptyDepth ? depth : infinitelyFar;
}

bool isBlocked(MapPoint point, vec2 st, float layer)
{
  return isBlocker(point, st, mapDepth(st, layer));
}

// Whether the point of the emitter at window coordinates e is on the camera's side of the receiver's
// plane. What lies behind it is blocked by the surface itself.
bool facesPoint(MapPoint point, vec2 kernelScale, vec2 e)
{
  return (1.0 + dot(point.gradient, kernelScale * e) > 0.0) == point.facesCenter;
}
