// Declarations that the soft-shadow pass adds to the mappers' fragment shaders.
// SOFT_SHADOW_LIGHTS is the number of lit lights, in the mapper's own order.
uniform int softShadowStage;
uniform float softShadowReceives; // the mark of this prop's receivers
uniform float softShadowLargestRise;     // of this prop's surface over the plane of a triangle
uniform vec4 softShadowDepthToView; // (a z + b) / (c z + d) is the depth from -1 to 1 of a view z
uniform ivec2 softShadowOrigin;     // lower left pixel of the viewport
uniform sampler2DArray softShadowVisibility;
uniform int softShadowLayers[SOFT_SHADOW_LIGHTS]; // -1: casts nothing
uniform float softShadowAttenuations[SOFT_SHADOW_LIGHTS]; // what a full shadow takes away, 0 to 1

float softShadowFactor(int light)
{
  int layer = softShadowLayers[light];
  if (layer < 0 || softShadowReceives != SOFT_SHADOW_RECEIVES)
  {
    return 1.0;
  }
  ivec2 pixel = ivec2(gl_FragCoord.xy) - softShadowOrigin;
  float visibility = texelFetch(softShadowVisibility, ivec3(pixel, layer), 0).r;
  return visibility < 0.0 ? 1.0 : mix(1.0, visibility, softShadowAttenuations[light]);
}
