// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSeparableReuseCount
 * @brief   The share of rows that were reused, per stage and pixel, over all emitters of a frame.
 */

#ifndef vtkSeparableReuseCount_h
#define vtkSeparableReuseCount_h

#include "vtkNew.h"                // For textures
#include "vtkShadowTextureArray.h" // For textures
#include "vtkSmartPointer.h"       // For images
#include "vtkSoftShadowsABI.h"     // For the ABI namespace

#include <array>  // For stages
#include <vector> // For sums

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;

class vtkSeparableReuseCount
{
public:
  static constexpr int Stages = 2;
  /// In the textures: no row was needed.
  static constexpr float Uncounted = -1.0f;

  /// R32F: what one emitter's steps have written.
  vtkShadowTextureArray* GetShares(int stage) { return this->Shares[stage]; }

  /// Adds the textures, after those of the same frame.
  void Add(vtkTypeInt64 frame);

  /// NaN where nothing was counted; null if nothing was at all.
  vtkSmartPointer<vtkImageData> MakeImage(int stage) const;

  /// Over all pixels; 0 if nothing was counted.
  double GetShare(int stage) const;

private:
  struct Stage
  {
    std::vector<float> Sums;
    std::vector<int> Counts;
  };
  bool Has(int stage) const;

  std::array<vtkNew<vtkShadowTextureArray>, Stages> Shares;
  std::array<Stage, Stages> Totals;
  int Size[2] = { 0, 0 };
  vtkTypeInt64 Frame = -1;
};

VTK_ABI_NAMESPACE_END
#endif
