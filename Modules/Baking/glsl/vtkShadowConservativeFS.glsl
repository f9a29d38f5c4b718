//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Conservative rasterisation, see vtkShadowConservativeGS: drops the texels that only the bounding
// box touches, and writes the nearest depth of the triangle's plane within the texel.

flat in vec4 edgesX;
flat in vec4 edgesY;
flat in vec4 edgesC;
flat in vec3 depthPlane;
flat in float nearest;
in vec2 place;

void main()
{
  vec4 beyond = edgesX * place.x + edgesY * place.y + edgesC;
  if (any(greaterThan(beyond, vec4(0.0))))
  {
    discard;
  }
  gl_FragDepth = clamp(min(dot(depthPlane, vec3(place, 1.0)), nearest), 0.0, 1.0);
}
