#define SOFT_SHADOW_STEPS
  // The way to the neighbours on the screen, while no fragment has been discarded.
  vec3 softShadowX = dFdx(vertexVC.xyz);
  vec3 softShadowY = dFdy(vertexVC.xyz);
