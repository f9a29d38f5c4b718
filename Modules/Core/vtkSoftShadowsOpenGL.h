// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkSoftShadowsOpenGL.h
 * @brief The OpenGL functions and constants of the loader that VTK itself uses.
 *
 * VTK loads OpenGL with GLEW up to 9.3 and with glad from 9.4 on. This is the one place that knows.
 * For sources only: a public header that included it would force the loader on every user.
 */

#ifndef vtkSoftShadowsOpenGL_h
#define vtkSoftShadowsOpenGL_h

#include "vtkVersionMacros.h" // For VTK_MAJOR_VERSION, VTK_MINOR_VERSION

#if VTK_MAJOR_VERSION > 9 || (VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION >= 4)
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#endif
// VTK-HeaderTest-Exclude: vtkSoftShadowsOpenGL.h
