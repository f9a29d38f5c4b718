// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What the occlusion queries of adaptive sampling say.
#include "vtkCascadedSoftShadowPassInternals.h"

#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// Of the viewport: what so few pixels need is not worth another level's maps.
constexpr double FewPixels = 5e-4;
} // namespace

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCascadedSoftShadowPass::GetFewPixels() const
{
  vtkShadowReceivers* receivers = this->Impl->Receivers;
  return receivers
    ? static_cast<vtkTypeInt64>(FewPixels * receivers->GetWidth() * receivers->GetHeight())
    : 0;
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::SetQueryReader(std::shared_ptr<vtkShadowQueryReader> reader)
{
  this->Impl->Reader = reader ? std::move(reader) : std::make_shared<vtkShadowQueryReader>();
}

//------------------------------------------------------------------------------
bool vtkCascadedSoftShadowPass::WantsVisibilityAnew()
{
  if (!this->Adaptive)
  {
    return false;
  }
  bool anew = false;
  for (auto& emitter : this->Impl->Emitters)
  {
    for (Refinement::Plan& plan : emitter.second.Plans)
    {
      anew = plan.Collect(*this->Impl->Reader, this->GetFewPixels(), this->MaximumLevel) || anew;
    }
  }
  return anew;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCascadedSoftShadowPass::GetNumberOfPixelSamples()
{
  vtkTypeInt64 samples = 0;
  for (auto& emitter : this->Impl->Emitters)
  {
    for (Refinement::Plan& plan : emitter.second.Plans)
    {
      plan.Collect(*this->Impl->Reader, this->GetFewPixels(), this->MaximumLevel);
      vtkTypeInt64 before = 0;
      for (int level = 0; level <= vtkShadowBorderGrid::LargestLevel; ++level)
      {
        const vtkTypeInt64 edge = (1 << level) + 1;
        samples += plan.Counts[level] * (edge * edge - before);
        before = edge * edge;
      }
    }
  }
  return samples;
}
VTK_ABI_NAMESPACE_END
