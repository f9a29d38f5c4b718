// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowScreen.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
vtkShadowScreen vtkShadowScreen::Of(vtkRenderer* renderer, int height)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double* toView = camera->GetModelViewTransformMatrix()->GetData();
  const double* toClip =
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0)->GetData();
  // A height of h is h toClip[5] / w of the two units that the picture is high, where w is linear too.
  const double scale = 2.0 / (std::abs(toClip[5]) * std::max(height, 1));
  vtkShadowScreen screen;
  for (int i = 0; i < 4; ++i)
  {
    screen.Plane[i] = scale * toClip[14] * toView[8 + i];
  }
  screen.Plane[3] += scale * toClip[15];
  screen.Least = scale * (toClip[15] - toClip[14] * camera->GetClippingRange()[0]);
  return screen;
}

//------------------------------------------------------------------------------
double vtkShadowScreen::FindLargest(const std::array<double, 6>& box) const
{
  double size = this->Plane[3];
  for (int i = 0; i < 3; ++i)
  {
    size += std::max(this->Plane[i] * box[2 * i], this->Plane[i] * box[2 * i + 1]);
  }
  return std::max(size, this->Least);
}

VTK_ABI_NAMESPACE_END
