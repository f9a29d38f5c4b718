//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// A stroke becomes a rectangle through its middle that faces the light: as wide as a number of pixels
// is there in the picture, and never thinner than a texel.

layout(lines) in;
layout(triangle_strip, max_vertices = 12) out;

uniform mat4 localToClip;
uniform vec4 eyeLocal;    // the map's centre of projection; w = 0: xyz is the direction of its rays
uniform vec4 pixelLocal;  // a pixel's size at p is dot(pixelLocal, (p, 1)) ...
uniform float leastPixel; // ... and not less than this
uniform float halfPixels; // half of the stroke's width
uniform float halfTexel;  // half of a texel's size where the clip coordinate w is 1
uniform int isDot;        // both ends are the same point
uniform int isRound;

out vec3 placeLocal;
flat out vec3 startLocal;  // one end, ...
flat out float startRadius;
flat out vec3 alongLine;   // ... the direction from there (0 for a dot) ...
flat out float growth;     // ... how the radius grows on the way ...
flat out float endOfLine;  // ... and how long it is; 0 for a dot, -1 for the lid of a tube

float findRadius(vec3 p)
{
  return halfPixels * max(dot(pixelLocal, vec4(p, 1.0)), leastPixel);
}

float findHalfWidth(vec3 p)
{
  float w = dot(vec4(localToClip[0].w, localToClip[1].w, localToClip[2].w, localToClip[3].w),
    vec4(p, 1.0));
  return max(findRadius(p), halfTexel * w);
}

vec3 anySide(vec3 direction)
{
  vec3 axis = abs(direction.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
  return normalize(cross(direction, axis));
}

// What a stroke's fragments need, the same for all of them.
struct Stroke
{
  vec3 start;
  float radius;
  vec3 along;
  float growth;
  float end;
};

void emitRectangle(Stroke stroke, vec3 places[2], vec3 sides[2], vec3 others[2])
{
  for (int i = 0; i < 4; ++i)
  {
    // Outputs are undefined once a vertex was emitted.
    startLocal = stroke.start;
    startRadius = stroke.radius;
    alongLine = stroke.along;
    growth = stroke.growth;
    endOfLine = stroke.end;
    float halfWidth = findHalfWidth(places[i / 2]);
    placeLocal =
      places[i / 2] + halfWidth * ((i % 2 == 0 ? -1.0 : 1.0) * sides[i / 2] + others[i / 2]);
    gl_Position = localToClip * vec4(placeLocal, 1.0);
    gl_Position.z = 0.0; // the depth is written later: nothing is clipped by it
    EmitVertex();
  }
  EndPrimitive();
}

void main()
{
  vec3 ends[2] = vec3[2](gl_in[0].gl_Position.xyz, gl_in[1].gl_Position.xyz);
  vec3 line = ends[1] - ends[0];
  float lineLength = isDot == 1 ? 1.0 : max(length(line), 1e-30);
  line /= lineLength;
  vec3 sides[2];
  vec3 others[2];
  for (int i = 0; i < 2; ++i)
  {
    vec3 ray = normalize(eyeLocal.w > 0.0 ? ends[i] - eyeLocal.xyz : eyeLocal.xyz);
    float outward = i == 0 ? -1.0 : 1.0;
    if (isDot == 1)
    {
      sides[i] = anySide(ray);
      others[i] = outward * cross(ray, sides[i]);
    }
    else
    {
      vec3 across = cross(line, ray);
      float sine = length(across);
      sides[i] = sine > 1e-4 ? across / sine : anySide(ray);
      // The side of a tube that the light sees lies before the rectangle through its middle.
      others[i] =
        isRound == 1 ? outward * abs(dot(line, ray)) / max(sine, 0.2) * line : vec3(0.0);
    }
  }
  float radius = findRadius(ends[0]);
  Stroke stroke = isDot == 1
    ? Stroke(ends[0], radius, vec3(0.0), 0.0, 0.0)
    : Stroke(ends[0], radius, line, (findRadius(ends[1]) - radius) / lineLength, lineLength);
  emitRectangle(stroke, ends, sides, others);
  for (int i = 0; i < 2 && isDot == 0 && isRound == 1; ++i)
  {
    vec3 side = anySide(line);
    Stroke lid = Stroke(ends[i], findRadius(ends[i]), vec3(0.0), 0.0, -1.0);
    emitRectangle(lid, vec3[2](ends[i], ends[i]), vec3[2](side, side),
      vec3[2](-cross(line, side), cross(line, side)));
  }
}
