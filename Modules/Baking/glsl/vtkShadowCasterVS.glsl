//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Casters into a depth map: positions relative to the casters' local origin.

in vec3 positionLocal;

uniform mat4 localToClip;

void main()
{
  gl_Position = localToClip * vec4(positionLocal, 1.0);
}
