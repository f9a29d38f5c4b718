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

// The mark of this prop's receivers with a normal in a few bits: the number of its cell on the
// octahedron, whose lower half is folded over the upper one.
float softShadowMark(vec3 normalVs)
{
  vec3 corner = normalVs / (abs(normalVs.x) + abs(normalVs.y) + abs(normalVs.z));
  vec2 side = mix(vec2(-1.0), vec2(1.0), greaterThanEqual(corner.xy, vec2(0.0)));
  vec2 folded = corner.z < 0.0 ? (1.0 - abs(corner.yx)) * side : corner.xy;
  vec2 cell = floor((0.5 * folded + 0.5) * (SOFT_SHADOW_NORMAL_STEPS - 1.0) + 0.5);
  float mark = SOFT_SHADOW_FIRST_NORMAL + cell.x + SOFT_SHADOW_NORMAL_STEPS * cell.y;
  return softShadowReceives == SOFT_SHADOW_RECEIVES ? mark : -mark;
}

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
