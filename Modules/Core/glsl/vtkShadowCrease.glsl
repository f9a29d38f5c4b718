// Receivers in the crease of two surfaces, the other of which blocks. Needs vtkShadowDepthMap.
//
// Within a texel of the crease the map cannot tell: the texel's centre may lie beyond the other surface's
// end, and the bias hides how little that surface is in front. Two texels away from the receiver, on the
// way along its normal, the map does show it. In map coordinates that surface's plane is as flat as the
// receiver's, so the receiver's side of the crease is known to a fraction of a texel.

// From the receiver to the middle of the four texels, in texels: all of their centres are far enough
// from a crease at the receiver for the bias.
const float creaseLook = 2.0;
// So near to a crease, in texels, a texel's centre may lie beyond it or be within its bias.
const float creaseReach = 2.0;

// Of a crease: how far its other surface is in front where it is looked at, in biases.
const float creaseSteepness = 3.0;
// Half the light's image there, in texels, at most.
const float creaseAslant = 0.25;

// Of four texels, in the order of textureGather.
vec4 gapsAround(MapPoint point, vec2 corner, float layer)
{
  vec2 side = vec2(0.5, -0.5);
  return vec4(gapOf(point, corner + side.yx, layer), gapOf(point, corner + side.xx, layer),
    gapOf(point, corner + side.xy, layer), gapOf(point, corner + side.yy, layer));
}

// Whether the texels around the receiver show that nothing ends there, or that the other surface, which
// the map would show with this gap at the receiver and slope per texel, ends before it comes as near.
bool deniesCrease(MapPoint point, float gap, vec2 slope, float layer)
{
  vec2 place = point.std.xy * depthMapSize;
  vec2 around = floor(place + 0.5);
  vec4 expected = gap + dot(slope, around - place) +
    0.5 * vec4(slope.y - slope.x, slope.x + slope.y, slope.x - slope.y, -slope.x - slope.y);
  vec4 shown = gapsAround(point, around, layer);
  vec4 bias = vec4(point.bias);
  vec4 missing = vec4(lessThan(shown, bias)) * vec4(greaterThan(expected, 1.05 * bias));
  return all(lessThan(abs(shown), bias)) || dot(missing, vec4(1.0)) > 0.0;
}

// A map may hold the least depths within its texels: planes lie so far in front of where they are at the
// centres.
float leastDepthReach(vec2 slopePerTexel)
{
#ifdef SOFT_SHADOW_LEAST_DEPTHS
  return 0.5 * dot(abs(slopePerTexel), vec2(1.0));
#else
  return 0.0;
#endif
}

// Whether the receiver is within reach texels of a crease, on the side of it that the other surface
// hides from all of the emitter. A point or a line has no plane: drawn on a surface, it would be in the
// crease of that with a plane that is made up.
bool isInCrease(MapPoint point, vec2 kernelScale, float reach, float layer)
{
  vec2 own = point.gradient / depthMapSize;
  point.std.z -= leastDepthReach(own);
  // Most receivers see their own surface on the way along their normal, or nothing.
  vec2 ahead = point.std.xy * depthMapSize + creaseLook * point.lift;
  if (!point.facesCenter || point.lift == vec2(0.0) ||
    gapOf(point, floor(ahead) + 0.5, layer) <= point.bias)
  {
    return false;
  }
  // Four texels there, all of them in front of the receiver's plane.
  vec2 corner = floor(ahead + 0.5);
  vec4 gaps = gapsAround(point, corner, layer);
  if (any(lessThanEqual(gaps, vec4(point.bias))))
  {
    return false;
  }
  // The plane of the other surface.
  vec2 slope = 0.5 * vec2(gaps.y + gaps.z - gaps.x - gaps.w, gaps.x + gaps.y - gaps.z - gaps.w);
  float middle = dot(gaps, vec4(0.25));
  float shown = middle + dot(slope, point.std.xy * depthMapSize - corner);
  float here = shown + leastDepthReach(own) - leastDepthReach(own - slope);
  bool nears = here <= reach * length(slope) && dot(slope, point.lift) > 0.0;
  // A surface that bends over as far on its other side may bend away before it comes here.
  vec2 beyond = floor(corner + creaseLook * point.lift) + 0.5;
  float bend = abs(gapOf(point, beyond, layer) - middle - dot(slope, beyond - corner)) +
    abs(gaps.x - gaps.y + gaps.z - gaps.w);
  // Bumps and folds of one surface are not as steep.
  bool isSure = here > bend && middle >= creaseSteepness * point.bias;
  if (!nears || !isSure || deniesCrease(point, shown, slope, layer))
  {
    return false;
  }
  // What of the light is on this side of the other surface passes it by, and rays far aslant leave what
  // the four texels show of it.
  float steepest = dot(abs(point.gradient - slope * depthMapSize), kernelScale);
  vec2 aslant = middle / max(1.0 - steepest, 1e-6) * kernelScale * depthMapSize;
  return steepest < 1.0 && max(aslant.x, aslant.y) <= creaseAslant;
}
