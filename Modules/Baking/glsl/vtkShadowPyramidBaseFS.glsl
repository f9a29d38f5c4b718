//VTK::System::Dec
#extension GL_ARB_texture_gather : enable
// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The finest level of a pyramid: minimum and maximum of d, which the map holds negated, over 2 x 2
// texels.
//VTK::Output::Dec

uniform sampler2DArray depthMaps;
uniform int layer;

// Beyond the map's border is nothing: depth 0.
vec4 fetchFour(ivec2 corner)
{
  ivec3 size = textureSize(depthMaps, 0);
#ifdef GL_ARB_texture_gather
  vec2 isInside = vec2(lessThan(corner + 1, size.xy));
  vec4 depths = textureGather(depthMaps, vec3(vec2(corner + 1) / vec2(size.xy), float(layer)));
  return -depths * vec4(isInside.y, isInside.x * isInside.y, isInside.x, 1.0);
#else
  vec4 depths = vec4(0.0);
  for (int i = 0; i < 4; ++i)
  {
    ivec2 texel = corner + ivec2(i & 1, i >> 1);
    if (all(lessThan(texel, size.xy)))
    {
      depths[i] = -texelFetch(depthMaps, ivec3(texel, layer), 0).r;
    }
  }
  return depths;
#endif
}

void main()
{
  ivec2 corner = 2 * ivec2(gl_FragCoord.xy);
  ivec2 size = textureSize(depthMaps, 0).xy;
  vec4 depths = any(greaterThanEqual(corner, size)) ? vec4(0.0) : fetchFour(corner);
  vec2 least = min(depths.xy, depths.zw);
  vec2 most = max(depths.xy, depths.zw);
  gl_FragData[0] = vec4(min(least.x, least.y), max(most.x, most.y), 0.0, 1.0);
}
