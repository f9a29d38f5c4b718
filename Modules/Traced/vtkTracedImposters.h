// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedImposters
 * @brief   The spheres and sticks that VTK's mappers of imposters draw.
 */

#ifndef vtkTracedImposters_h
#define vtkTracedImposters_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkTracedRounds.h"

#include <vector> // For rounds

VTK_ABI_NAMESPACE_BEGIN
class vtkMapper;

struct vtkTracedImposters
{
  /// In model coordinates relative to center. False for mappers that draw something else.
  static bool Find(
    vtkMapper* mapper, std::vector<vtkTracedRounds::Round>& rounds, vtkTracedVector& center);
};

VTK_ABI_NAMESPACE_END
#endif
