// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVirtualEmitter
 * @brief   What is kept per light and part: its tiles, their maps, and what its pixels asked for.
 */

#ifndef vtkVirtualEmitter_h
#define vtkVirtualEmitter_h

#include "vtkShadowEmitter.h"   // For the emitter
#include "vtkSoftShadowsABI.h"  // For the ABI namespace
#include "vtkType.h"            // For times
#include "vtkVirtualRequest.h"  // For members
#include "vtkVirtualTileMaps.h" // For members
#include "vtkVirtualTileTree.h" // For members

VTK_ABI_NAMESPACE_BEGIN
class vtkVirtualScreen;

struct vtkVirtualEmitter
{
  vtkVirtualTileMaps Maps;
  vtkVirtualTileTree Tree;
  vtkVirtualRequest Request;
  vtkShadowEmitter Emitter;
  int Light = 0; // as of the last frame that showed it
  int Part = 0;
  vtkMTimeType CastersTime = 0;
  bool IsStatic = false; // nothing but the camera moved since the frame before
  bool IsShown = false;  // in the last frame that drew visibilities
  /// The screen that its kernels were drawn to, in which state; null before.
  vtkVirtualScreen* Screen = nullptr;
  vtkTypeInt64 ShapesState = -1;
  /// The last frame's tiles were planned by an older frame's request.
  bool IsLate = false;
  /// By how many cells of the map points may have moved since.
  int Shift = 0;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkVirtualEmitter.h
