// The visible point under this pixel, and whether the light of this draw can reach it at all.
// Space suffixes: Vs view coordinates.

uniform sampler2D receiverPosition; // xyz: position Vs, w: its mark, with the normal in a few bits
uniform sampler2D receiverNormal;   // xyz: unit normal of the visible triangle's plane, Vs, w: rise
uniform sampler2D receiverSurface;  // the smooth surface: xyz: unit normal Vs, w: height over the triangle
uniform int receiverSmooth;         // 1: receivers lie on the smooth surface

struct Receiver
{
  vec3 positionVs;
  vec3 normalVs;  // towards the camera
  float rise;     // of the surface over that plane, at most; -1: a point or a line, whose plane is made up
};

// SOFT_SHADOW_RECEIVES, SOFT_SHADOW_SURFACE (receives nothing), or 0 where there is no surface.
float markOf(vec4 position)
{
  return position.w >= SOFT_SHADOW_FIRST_NORMAL ? SOFT_SHADOW_RECEIVES
    : (position.w <= -SOFT_SHADOW_FIRST_NORMAL ? SOFT_SHADOW_SURFACE : 0.0);
}

// The normal in a mark, right to 0.002: a number of a cell of the octahedron's map.
vec3 normalOf(vec4 position)
{
  float number = abs(position.w) - SOFT_SHADOW_FIRST_NORMAL;
  vec2 cell = vec2(mod(number, SOFT_SHADOW_NORMAL_STEPS), floor(number / SOFT_SHADOW_NORMAL_STEPS));
  vec2 folded = 2.0 * cell / (SOFT_SHADOW_NORMAL_STEPS - 1.0) - 1.0;
  float z = 1.0 - abs(folded.x) - abs(folded.y);
  vec2 side = mix(vec2(-1.0), vec2(1.0), greaterThanEqual(folded, vec2(0.0)));
  return normalize(vec3(folded - side * max(-z, 0.0), z));
}

// Position and mark at a place in [0, 1]^2 of the viewport.
vec4 receiverAt(vec2 place)
{
  vec4 position = textureLod(receiverPosition, place, 0.0);
  position.w = markOf(position);
  if (receiverSmooth == 1)
  {
    vec4 surface = textureLod(receiverSurface, place, 0.0);
    position.xyz += surface.w * surface.xyz;
  }
  return position;
}

bool loadReceiver(ivec2 pixel, out Receiver receiver)
{
  vec4 position = texelFetch(receiverPosition, pixel, 0);
  vec4 normal = texelFetch(receiverNormal, pixel, 0);
  receiver.positionVs = position.xyz;
  receiver.rise = normal.w;
  if (receiverSmooth == 1)
  {
    vec4 surface = texelFetch(receiverSurface, pixel, 0);
    receiver.normalVs = surface.xyz;
    receiver.positionVs += surface.w * surface.xyz;
  }
  else
  {
    receiver.normalVs = normal.xyz;
  }
  return markOf(position) == SOFT_SHADOW_RECEIVES;
}

// A neighbour of a receiver, for filters on the screen: its normal is right to 0.002, and it takes
// one look at a texture where a receiver takes two.
bool loadNeighbour(ivec2 pixel, out vec3 positionVs, out vec3 normalVs)
{
  vec4 position = texelFetch(receiverPosition, pixel, 0);
  positionVs = position.xyz;
  normalVs = normalOf(position);
  if (receiverSmooth == 1)
  {
    vec4 surface = texelFetch(receiverSurface, pixel, 0);
    normalVs = surface.xyz;
    positionVs += surface.w * surface.xyz;
  }
  return markOf(position) == SOFT_SHADOW_RECEIVES;
}
