//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// A level of a pyramid from the finer one.
//VTK::Output::Dec

uniform sampler2DArray finer;
uniform int layer;
uniform ivec2 finerCorner; // of the finer level in its image

void main()
{
  ivec2 corner = finerCorner + 2 * ivec2(gl_FragCoord.xy);
  vec2 a = texelFetch(finer, ivec3(corner, layer), 0).rg;
  vec2 b = texelFetch(finer, ivec3(corner + ivec2(1, 0), layer), 0).rg;
  vec2 c = texelFetch(finer, ivec3(corner + ivec2(0, 1), layer), 0).rg;
  vec2 d = texelFetch(finer, ivec3(corner + ivec2(1, 1), layer), 0).rg;
  gl_FragData[0] =
    vec4(min(min(a.x, b.x), min(c.x, d.x)), max(max(a.y, b.y), max(c.y, d.y)), 0.0, 1.0);
}
