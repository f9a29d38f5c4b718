//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Conservative rasterisation: every texel that a triangle touches gets a fragment.
//
// A texel (a square) and a triangle are apart exactly if one of the square's axes or one of the
// triangle's edge normals separates them. The rectangle drawn here, the triangle's bounding box grown
// by half a texel, does the first two tests; the fragment shader does the others, with the edges as
// half planes grown by half a texel. The idea of growing edges: Hasselgren, Akenine-Moller, Ohlsson,
// "Conservative Rasterization", GPU Gems 2, 2005.
//
// A triangle that reaches behind the light is cut at w = leastW first, which can give it a fourth
// corner.

layout(triangles) in;
layout(triangle_strip, max_vertices = 4) out;

uniform float halfTexel; // in normalised device coordinates, grown a little against rounding
uniform float leastW;    // of a visible point; w is the distance along the light's direction, or 1

flat out vec4 edgesX;    // outward normals of the four edges ...
flat out vec4 edgesY;
flat out vec4 edgesC;    // ... with edgesX x + edgesY y + edgesC <= 0 inside the grown edge
flat out vec3 depthPlane; // what the map holds, 1 near and 0 far, = dot(depthPlane, (x, y, 1))
flat out float nearest;   // of the triangle
out vec2 place;

void main()
{
  // Cut at w = leastW.
  vec3 corners[4];
  int count = 0;
  for (int i = 0; i < 3; ++i)
  {
    vec4 a = gl_in[i].gl_Position;
    vec4 b = gl_in[(i + 1) % 3].gl_Position;
    if (a.w >= leastW && count < 4)
    {
      corners[count++] = a.xyz / a.w;
    }
    if ((a.w >= leastW) != (b.w >= leastW) && count < 4)
    {
      vec4 cut = mix(a, b, (leastW - a.w) / (b.w - a.w));
      corners[count++] = cut.xyz / leastW;
    }
  }
  if (count < 3)
  {
    return;
  }
  if (count == 3)
  {
    corners[3] = corners[2];
  }

  vec3 low = min(min(corners[0], corners[1]), min(corners[2], corners[3]));
  vec3 high = max(max(corners[0], corners[1]), max(corners[2], corners[3]));
  // The plane of the triangle. Seen edge-on it has no depth to interpolate: the nearest one holds.
  vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]) +
    cross(corners[2] - corners[0], corners[3] - corners[0]);
  // From the corners before they were cut and divided: a cut one may lie so far outside that nothing of
  // the plane's depth within the map would be left.
  vec4 p = gl_in[0].gl_Position;
  vec4 u = gl_in[1].gl_Position - p;
  vec4 v = gl_in[2].gl_Position - p;
  vec3 across = cross(u.xyw, v.xyw);
  float volume = dot(p.xyw, across);
  bool isFaced = abs(normal.z) > 1e-12 && volume != 0.0;
  vec3 plane = isFaced
    ? (p.z * across + u.z * cross(v.xyw, p.xyw) + v.z * cross(p.xyw, u.xyw)) / volume
    : vec3(0.0, 0.0, high.z);
  // Brought to the nearest depth within a texel around its centre.
  plane.z += halfTexel * (abs(plane.x) + abs(plane.y));

  mat3x4 edges; // x, y, and the constant
  float turn = normal.z < 0.0 ? -1.0 : 1.0;
  for (int i = 0; i < 4; ++i)
  {
    vec2 a = corners[i].xy;
    vec2 along = turn * (corners[(i + 1) % 4].xy - a);
    vec2 outward = vec2(along.y, -along.x);
    edges[0][i] = outward.x;
    edges[1][i] = outward.y;
    edges[2][i] = -dot(outward, a) - halfTexel * (abs(outward.x) + abs(outward.y));
  }

  vec2 from = clamp(low.xy - halfTexel, vec2(-1.0), vec2(1.0));
  vec2 to = clamp(high.xy + halfTexel, vec2(-1.0), vec2(1.0));
  for (int i = 0; i < 4; ++i)
  {
    // Outputs are undefined once a vertex was emitted.
    edgesX = edges[0];
    edgesY = edges[1];
    edgesC = edges[2];
    depthPlane = plane;
    nearest = high.z;
    place = vec2((i & 1) == 0 ? from.x : to.x, (i & 2) == 0 ? from.y : to.y);
    gl_Position = vec4(place, 0.0, 1.0);
    EmitVertex();
  }
  EndPrimitive();
}
