// The footprint of a pixel on the map at hand.

uniform mat4 viewToMap;
uniform int cameraParallel;
uniform vec2 halfPixel; // view units per half pixel, at depth 1 if perspective

// How the receiver's pixel lies on the map: half axes in (s, t).
struct Footprint
{
  vec2 u;
  vec2 v;
};

// No pixel counts as seen flatter than this: its footprint would have no end.
const float flattestView = 0.01;

// Moves along the screen's axis on the receiver's plane, then through the map's projection.
vec2 warpAxis(vec3 axisVs, vec3 sightVs, Receiver receiver, MapPoint point)
{
  float facing = dot(receiver.normalVs, sightVs);
  float least = flattestView * length(sightVs);
  facing = abs(facing) < least ? (facing < 0.0 ? -least : least) : facing;
  vec3 along = axisVs - sightVs * (dot(receiver.normalVs, axisVs) / facing);
  vec4 moved = viewToMap * vec4(along, 0.0);
  float w = (viewToMap * vec4(receiver.positionVs, 1.0)).w;
  return (moved.xy - point.std.xy * moved.w) / w;
}

Footprint footprintOf(Receiver receiver, MapPoint point)
{
  float depth = cameraParallel == 1 ? 1.0 : abs(receiver.positionVs.z);
  vec3 sight = cameraParallel == 1 ? vec3(0.0, 0.0, -1.0) : receiver.positionVs;
  return Footprint(warpAxis(vec3(halfPixel.x * depth, 0.0, 0.0), sight, receiver, point),
    warpAxis(vec3(0.0, halfPixel.y * depth, 0.0), sight, receiver, point));
}

// How far from the receiver the pixel's part of a kernel reaches.
vec2 reachOf(Footprint footprint)
{
  vec3 variance = varianceOf(footprint.u, footprint.v);
  return sqrt(2.0 * variance.xz);
}

// Whether a blocker stands in the pyramid of receiver and light: 1 if its texel touches the pyramid,
// falling to 0 over one texel. At its own
// depth the light's image may be narrower than the kernel, as behind a fold that rises less than the
// light stands: such a blocker hides nothing of the light.
float shareOfBlocker(MapPoint point, vec2 kernelScale, float depth, vec2 st, vec2 margin)
{
  vec2 image = kernelScale * (point.std.z - depth) + margin;
  vec2 inside = clamp((image - abs(st - point.std.xy)) * depthMapSize + 1.5, 0.0, 1.0);
  return inside.x * inside.y;
}
