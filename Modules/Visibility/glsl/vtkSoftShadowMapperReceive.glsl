  if (softShadowStage == SOFT_SHADOW_STAGE_RECEIVE)
  {
    vec3 softShadowPosition = vertexVC.xyz;
#if defined(SOFT_SHADOW_TUBE) && !defined(SOFT_SHADOW_STEPS)
    vec3 softShadowX = dFdx(vertexVC.xyz);
    vec3 softShadowY = dFdy(vertexVC.xyz);
#endif
    vec3 softShadowNormal;
#if defined(SOFT_SHADOW_SPHERE) || defined(SOFT_SHADOW_TUBE)
    // A point or a line drawn as a sphere or a tube: vertexVC is its middle, and VTK's normal is that of
    // a body straight before the camera. Here it is turned to where the body is.
    vec3 softShadowFront = cameraParallel == 1 ? vec3(0.0, 0.0, 1.0) : normalize(-vertexVC.xyz);
    float softShadowRadius = ZCalcR * (cameraParallel == 1 ? 1.0 : -vertexVC.z);
#endif
#ifdef SOFT_SHADOW_TUBE
    vec3 softShadowAxis = normalize(
      dot(softShadowX, softShadowX) > dot(softShadowY, softShadowY) ? softShadowX : softShadowY);
    vec3 softShadowSide = normalize(cross(softShadowAxis, softShadowFront));
    float softShadowAcross = min(length(tubeBasis1), 1.0) * sign(dot(softShadowSide, tubeBasis1));
    softShadowNormal = softShadowAcross * softShadowSide +
      sqrt(1.0 - softShadowAcross * softShadowAcross) * cross(softShadowSide, softShadowAxis);
    softShadowPosition += softShadowRadius * softShadowNormal;
    // As many pixels wide everywhere, a tube gets thicker away from a perspective camera: a cone.
    softShadowNormal +=
      cameraParallel == 1 ? vec3(0.0) : ZCalcR * softShadowAxis.z * softShadowAxis;
#else
#ifdef SOFT_SHADOW_SPHERE
    if (SOFT_SHADOW_SPHERE)
    {
      vec3 softShadowSide = normalize(cross(vec3(0.0, 1.0, 0.0), softShadowFront));
      softShadowNormal = normalVCVSOutput.x * softShadowSide +
        normalVCVSOutput.y * cross(softShadowFront, softShadowSide) +
        normalVCVSOutput.z * softShadowFront;
      softShadowPosition += softShadowRadius * softShadowNormal;
    }
    else
#endif
    {
#ifdef SOFT_SHADOW_MOVED_DEPTH
      // Along the ray to where the shader put the fragment.
      if (abs(gl_FragDepth - gl_FragCoord.z) > 1e-6)
      {
        float softShadowDepth = 2.0 * gl_FragDepth - 1.0;
        float softShadowZ =
          (softShadowDepthToView.y - softShadowDepth * softShadowDepthToView.w) /
          (softShadowDepth * softShadowDepthToView.z - softShadowDepthToView.x);
        softShadowPosition = softShadowDepthToView.z == 0.0 ? vec3(vertexVC.xy, softShadowZ)
                                                 : vertexVC.xyz * (softShadowZ / vertexVC.z);
      }
#endif
      // The plane of the visible triangle; the screen's x and y span it so that it faces the camera.
#ifndef SOFT_SHADOW_STEPS
      vec3 softShadowX = dFdx(softShadowPosition);
      vec3 softShadowY = dFdy(softShadowPosition);
#endif
      softShadowNormal = cross(normalize(softShadowX), normalize(softShadowY));
    }
#endif
    float softShadowLength = length(softShadowNormal);
    softShadowNormal = softShadowLength > 0.0 ? softShadowNormal / softShadowLength
                                              : vec3(0.0, 0.0, 1.0);
#ifdef SOFT_SHADOW_OPACITY
    // The holes of a wireframe that is drawn as a surface: after the derivatives, which they would spoil.
    if (SOFT_SHADOW_OPACITY <= 0.0)
    {
      discard;
    }
#endif
    gl_FragData[0] = vec4(softShadowPosition, softShadowMark(softShadowNormal));
    // Along a line or in a point all steps are parallel or none, but for rounding.
    gl_FragData[1] = vec4(softShadowNormal, softShadowLength > 1e-3 ? softShadowLargestRise : -1.0);
#if defined(SOFT_SHADOW_BEND) && !defined(SOFT_SHADOW_MOVED_DEPTH)
    gl_FragData[2] = softShadowSurface(vertexVC.xyz, softShadowNormal);
#else
    gl_FragData[2] = vec4(softShadowNormal, 0.0);
#endif
    return;
  }
