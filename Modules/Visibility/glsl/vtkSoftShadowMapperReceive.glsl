  if (softShadowStage == SOFT_SHADOW_STAGE_RECEIVE)
  {
    // The plane of the visible triangle; the screen's x and y span it so that it faces the camera.
    vec3 softShadowX = dFdx(vertexVC.xyz);
    vec3 softShadowY = dFdy(vertexVC.xyz);
    vec3 softShadowNormal = cross(normalize(softShadowX), normalize(softShadowY));
    float softShadowLength = length(softShadowNormal);
    gl_FragData[0] = vec4(vertexVC.xyz, softShadowReceives);
    softShadowNormal = softShadowLength > 0.0 ? softShadowNormal / softShadowLength
                                              : vec3(0.0, 0.0, 1.0);
    gl_FragData[1] = vec4(softShadowNormal, 0.0);
#ifdef SOFT_SHADOW_BEND
    gl_FragData[2] = softShadowSurface(vertexVC.xyz, softShadowNormal);
#else
    gl_FragData[2] = vec4(softShadowNormal, 0.0);
#endif
    return;
  }
