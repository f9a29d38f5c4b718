//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The depth of a stroke: that of the sphere or the tube it stands for. What is drawn flat faces the
// camera, not the light; its shadow lies half its width behind it, lest it shade itself.

uniform mat4 localToClip;
uniform vec4 eyeLocal;
uniform float halfTexel;
uniform int isRound;

in vec3 placeLocal;
flat in vec3 startLocal;
flat in float startRadius;
flat in vec3 alongLine;
flat in float growth;
flat in float endOfLine;

void main()
{
  vec3 ray = normalize(eyeLocal.w > 0.0 ? placeLocal - eyeLocal.xyz : eyeLocal.xyz);
  vec3 offset = placeLocal - startLocal; // from the stroke's middle
  float way = dot(offset, alongLine);
  offset -= way * alongLine;
  float radius = startRadius + growth * way;
  float w = dot(vec4(localToClip[0].w, localToClip[1].w, localToClip[2].w, localToClip[3].w),
    vec4(placeLocal - offset, 1.0));
  offset *= radius / max(radius, halfTexel * w); // the rectangle may be wider
  float toSurface = radius;
  if (isRound == 1)
  {
    if (endOfLine <= 0.0 && dot(offset, offset) > radius * radius)
    {
      discard;
    }
    // Where the ray meets the sphere, the tube or the cone.
    float along = dot(ray, alongLine);
    vec3 perpendicular = ray - along * alongLine;
    along *= growth;
    float a = max(dot(perpendicular, perpendicular) - along * along, 1e-4);
    float b = dot(offset, perpendicular) - radius * along;
    float c = dot(offset, offset) - radius * radius;
    toSurface = endOfLine < 0.0 ? 0.0 : (-b - sqrt(max(b * b - a * c, 0.0))) / a;
    way += toSurface * dot(ray, alongLine);
    if (endOfLine > 0.0 && (way < 0.0 || way > endOfLine))
    {
      discard;
    }
  }
  vec4 clip = localToClip * vec4(placeLocal + toSurface * ray, 1.0);
  gl_FragDepth = clamp(clip.z / clip.w, 0.0, 1.0);
}
