// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SupersampledContestant
 * @brief   A technique drawn at a multiple of the size and averaged: brute-force antialiasing.
 */

#ifndef SoftShadowsBenchmark_SupersampledContestant_h
#define SoftShadowsBenchmark_SupersampledContestant_h

#include "WindowContestant.h"

namespace softshadows
{

class SupersampledContestant : public TechniqueContestant
{
public:
  /// factor x factor samples per pixel of an image of width x height.
  SupersampledContestant(const SceneFactory& makeScene, int width, int height, int factor,
    const vtkSmartPointer<vtkSoftShadowPass>& pass);

  /// Means over the samples that have a value; NaN where none has.
  std::vector<std::vector<float>> GetVisibility() override;
  ColorImage GetPicture() override;

private:
  int Width;
  int Height;
  int Factor;
};

}

#endif
