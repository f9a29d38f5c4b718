  if (softShadowStage == SOFT_SHADOW_STAGE_RECEIVE)
  {
    // The plane of the visible triangle; the screen's x and y span it so that it faces the camera.
    vec3 softShadowX = dFdx(vertexVC.xyz);
    vec3 softShadowY = dFdy(vertexVC.xyz);
    vec3 softShadowNormal = cross(normalize(softShadowX), normalize(softShadowY));
    float softShadowLength = length(softShadowNormal);
    gl_FragData[0] = vec4(vertexVC.xyz, softShadowReceives);
    gl_FragData[1] = vec4(softShadowLength > 0.0 ? softShadowNormal / softShadowLength
                                                 : vec3(0.0, 0.0, 1.0), 0.0);
    return;
  }
