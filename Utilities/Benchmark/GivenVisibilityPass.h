// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GivenVisibilityPass
 * @brief   Lights a scene by visibilities that are given as images.
 *
 * With ray-traced visibilities it draws the picture that every technique should draw: the same
 * materials, the same shaders, exact shadows.
 */

#ifndef SoftShadowsBenchmark_GivenVisibilityPass_h
#define SoftShadowsBenchmark_GivenVisibilityPass_h

#include "vtkSoftShadowPass.h"

#include <memory> // For the implementation
#include <vector> // For images

namespace softshadows
{

class GivenVisibilityPass : public vtkSoftShadowPass
{
public:
  static GivenVisibilityPass* New();
  vtkTypeMacro(GivenVisibilityPass, vtkSoftShadowPass);

  /**
   * One image per light that is switched on, top row first, as large as the viewport. Pixels without
   * a value (NaN) are lit.
   */
  void SetVisibility(int width, int height, const std::vector<std::vector<float>>& images);

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  GivenVisibilityPass();
  ~GivenVisibilityPass() override;

  vtkSoftShadowRequirements GetRequirements() const override;
  void Add(const vtkSoftShadowServices& services) override;

private:
  GivenVisibilityPass(const GivenVisibilityPass&) = delete;
  void operator=(const GivenVisibilityPass&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl;
};

}

#endif
