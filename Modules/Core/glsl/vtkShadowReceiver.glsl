// The visible point under this pixel, and whether the light of this draw can reach it at all.
// Space suffixes: Vs view coordinates.

uniform sampler2D receiverPosition; // xyz: position Vs, w: SOFT_SHADOW_RECEIVES, ..._SURFACE or else
uniform sampler2D receiverNormal;   // xyz: unit normal of the visible triangle's plane, Vs

struct Receiver
{
  vec3 positionVs;
  vec3 normalVs; // towards the camera
};

bool loadReceiver(ivec2 pixel, out Receiver receiver)
{
  vec4 position = texelFetch(receiverPosition, pixel, 0);
  receiver.positionVs = position.xyz;
  receiver.normalVs = texelFetch(receiverNormal, pixel, 0).xyz;
  return position.w == SOFT_SHADOW_RECEIVES;
}
