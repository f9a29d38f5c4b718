  // What the fragments need of the vertices: their unit normals, and how far along them they lie.
  vec3 softShadowUnit = normalize(normalVCVSOutput);
  softShadowBend = vec4(softShadowUnit, dot(vertexVCVSOutput.xyz, softShadowUnit));
