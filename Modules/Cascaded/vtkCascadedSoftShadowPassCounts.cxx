// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What the occlusion queries of adaptive sampling say.
#include "vtkCascadedSoftShadowPassInternals.h"

#include <algorithm>
#include <utility>
#include <vector>

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
std::vector<vtkCascadedSoftShadowPass::Refinement::Plan*>
vtkCascadedSoftShadowPass::Internals::CollectCounts(const vtkCascadedSoftShadowPass* self)
{
  std::vector<Refinement::Plan*> plans;
  for (auto& emitter : this->Emitters)
  {
    // What was drawn in earlier frames, a light that is off or a cascade more, is out of date.
    const size_t count = emitter.second.Frame == this->Frame ? emitter.second.Cascades.size() : 0;
    for (size_t i = 0; i < count; ++i)
    {
      emitter.second.Plans[i].Collect(*this->Reader, self->GetFewPixels());
      plans.push_back(&emitter.second.Plans[i]);
    }
  }
  return plans;
}

//------------------------------------------------------------------------------
bool vtkCascadedSoftShadowPass::WantsVisibilityAnew()
{
  if (!this->Adaptive)
  {
    return false;
  }
  const std::vector<Refinement::Plan*> plans = this->Impl->CollectCounts(this);
  return std::any_of(
    plans.begin(), plans.end(), [](const Refinement::Plan* plan) { return plan->WantsMore; });
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCascadedSoftShadowPass::GetNumberOfPixelSamples()
{
  vtkTypeInt64 samples = 0;
  for (const Refinement::Plan* plan : this->Impl->CollectCounts(this))
  {
    samples += plan->GetNumberOfPixelSamples();
  }
  return samples;
}
VTK_ABI_NAMESPACE_END
