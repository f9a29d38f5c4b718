// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowImages.h"

#include "vtkImageData.h"

#include <algorithm>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkSoftShadowImages::MakeVisibility(
  const std::vector<float>& values, int width, int height)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* out = static_cast<float*>(image->GetScalarPointer());
  // Sums of rounded weights may fall short of 0 by a few units in the last place.
  constexpr float noValue = -0.5f;
  std::transform(values.begin(), values.end(), out,
    [](float value)
    {
      return value > noValue ? std::min(std::max(value, 0.0f), 1.0f)
                             : std::numeric_limits<float>::quiet_NaN();
    });
  return image;
}

//------------------------------------------------------------------------------
void vtkSoftShadowImages::MakeLit(vtkImageData* depth)
{
  auto* values = static_cast<float*>(depth->GetScalarPointer());
  std::transform(values, values + depth->GetNumberOfPoints(), values,
    [](float value) { return value == value ? 1.0f : value; });
}

//------------------------------------------------------------------------------
bool vtkSoftShadowImages::Copy(vtkImageData* from, vtkImageData* to)
{
  if (!from || !to)
  {
    return false;
  }
  to->ShallowCopy(from);
  return true;
}
VTK_ABI_NAMESPACE_END
