// The visible point under this pixel, and whether the light of this draw can reach it at all.
// Space suffixes: Vs view coordinates.

uniform sampler2D receiverPosition; // xyz: position Vs, w: SOFT_SHADOW_RECEIVES, ..._SURFACE or else
uniform sampler2D receiverNormal;   // xyz: unit normal of the visible triangle's plane, Vs, w: rise
uniform sampler2D receiverSurface;  // the smooth surface: xyz: unit normal Vs, w: height over the triangle
uniform int receiverSmooth;         // 1: receivers lie on the smooth surface

struct Receiver
{
  vec3 positionVs;
  vec3 normalVs;  // towards the camera
  float rise;     // of the surface over that plane, at most; -1: a point or a line, whose plane is made up
};

// Position and mark at a place in [0, 1]^2 of the viewport.
vec4 receiverAt(vec2 place)
{
  vec4 position = textureLod(receiverPosition, place, 0.0);
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
  return position.w == SOFT_SHADOW_RECEIVES;
}
