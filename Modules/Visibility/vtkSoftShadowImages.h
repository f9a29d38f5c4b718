// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowImages
 * @brief   What is read of a frame, as images.
 */

#ifndef vtkSoftShadowImages_h
#define vtkSoftShadowImages_h

#include "vtkSmartPointer.h"   // For images
#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <vector> // For values

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;

struct vtkSoftShadowImages
{
  /// Of visibilities: those outside [0, 1] are rounding, negative ones no value at all, NaN.
  static vtkSmartPointer<vtkImageData> MakeVisibility(
    const std::vector<float>& values, int width, int height);

  /// Of a light that reaches every surface: 1 where the depth is a number.
  static void MakeLit(vtkImageData* depth);

  /// False if there is nothing to copy, or nowhere to copy it to.
  static bool Copy(vtkImageData* from, vtkImageData* to);
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkSoftShadowImages.h
