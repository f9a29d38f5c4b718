#define SOFT_SHADOW_BEND
in vec4 softShadowBend; // interpolated: the vertices' unit normals, and how far along them they lie
uniform int softShadowSmooth;

// Below this length of the mean of unit normals they belong to an edge, from this length on to a bend.
const float softShadowEdge = 0.8;
const float softShadowRound = 0.9;
// What rounding leaves of a height, relative to the distance from the camera.
const float softShadowRounding = 2e-6;
// Of the interpolated height over the tangent planes: half is a sphere's own.
const float softShadowRise = 0.5;

// The plane of the smooth surface that the vertices' normals tell of, and how high it lies above the
// triangle, whose plane is given, along the normal.
//
// The mean over the vertices of their tangent planes' heights above the fragment, weighted as the fragment
// lies between them: both the positions and the normals are linear, so it is a difference of two
// products. A surface of second order lies half as high.
vec4 softShadowSurface(vec3 positionVs, vec3 normalVs)
{
  float size = length(softShadowBend.xyz);
  float side = dot(softShadowBend.xyz, normalVs) < 0.0 ? -1.0 : 1.0;
  float height = side * (softShadowBend.w - dot(positionVs, softShadowBend.xyz));
  float share = smoothstep(softShadowEdge, softShadowRound, size);
  if (softShadowSmooth == 0 || !(height * share > softShadowRounding * length(positionVs)))
  {
    return vec4(normalVs, 0.0);
  }
  return vec4(normalize(mix(normalVs, side / size * softShadowBend.xyz, share)),
    softShadowRise * share * height);
}
