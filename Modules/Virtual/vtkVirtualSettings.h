// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVirtualSettings
 * @brief   The settings of a virtual pass in one value; see vtkVirtualSoftShadowPass for each.
 */

#ifndef vtkVirtualSettings_h
#define vtkVirtualSettings_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN

struct vtkVirtualSettings
{
  int SearchMapSize = 0;
  bool Adaptive = true;
  int FixedLevels = 0;
  bool Antialiasing = false;
  int Metric = 0;
  bool GaussianWeights = false;
  double Quality = 0.0;
  int SearchWidth = 0;
  int MaximumTiles = 0;
  int GridLatency = 0;
  int DebugView = 0;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkVirtualSettings.h
