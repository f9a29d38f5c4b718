//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The ends of strokes, relative to their local origin.

in vec3 positionLocal;

void main()
{
  gl_Position = vec4(positionLocal, 1.0);
}
