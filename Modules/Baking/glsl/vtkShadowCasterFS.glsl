//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Depth alone.
//
// OpenGL's own clip space, from -w to w, would round all far depths to the spacing of floats at 1. Where
// there is no other, the depth is written here.

#ifdef SHADOW_WRITES_DEPTH
in float depthTimesW;

void main()
{
  gl_FragDepth = clamp(depthTimesW * gl_FragCoord.w, 0.0, 1.0);
}
#else
void main()
{
}
#endif
