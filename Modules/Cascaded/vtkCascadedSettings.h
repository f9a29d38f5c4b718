// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCascadedSettings
 * @brief   The settings of a cascaded pass in one value; see vtkCascadedSoftShadowPass for each.
 */

#ifndef vtkCascadedSettings_h
#define vtkCascadedSettings_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkType.h"           // For times

#include <array> // For cascades

VTK_ABI_NAMESPACE_BEGIN

struct vtkCascadedSettings
{
  static constexpr int MaximumNumberOfCascades = 4;

  /// Grows whenever a setting changes.
  vtkMTimeType Time = 0;
  int NumberOfCascades = 0;
  double SplitLambda = 0.0;
  double BlendBand = 0.0;
  std::array<int, MaximumNumberOfCascades> SampleEdges = { {} };
  std::array<int, MaximumNumberOfCascades> Resolutions = { {} };
  std::array<int, MaximumNumberOfCascades> FilterSizes = { {} };
  /// Smooth the steps between points in the maps, over FilterSizes; else on the screen.
  bool FiltersMaps = false;
  int Pattern = 0;
  int Weights = 0;
  bool Adaptive = false;
  double Tolerance = 0.0;
  int MaximumLevel = 0;
  bool FitToView = true;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkCascadedSettings.h
