//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Casters into a depth map: positions relative to the casters' local origin.

in vec3 positionLocal;

// z from w on the near plane to 0 on the far one
#ifdef SHADOW_LAYERS
uniform mat4 localToClip[SHADOW_LAYERS]; // a map per instance
uniform int firstLayer;
#else
uniform mat4 localToClip;
#endif

#ifdef SHADOW_WRITES_DEPTH
out float depthTimesW;
#endif

void main()
{
#ifdef SHADOW_LAYERS
  gl_Position = localToClip[gl_InstanceID] * vec4(positionLocal, 1.0);
  gl_Layer = firstLayer + gl_InstanceID;
#else
  gl_Position = localToClip * vec4(positionLocal, 1.0);
#endif
#ifdef SHADOW_WRITES_DEPTH
  depthTimesW = gl_Position.z;
  gl_Position.z = 0.0; // nothing is clipped by depth
#endif
}
