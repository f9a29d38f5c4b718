// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCascadedPlan.h"

#include "vtkShadowQueryReader.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
int vtkCascadedPlan::GetLastLevel() const
{
  return this->LastLevel < 0 ? this->LargestLevel : std::min(this->LastLevel, this->LargestLevel);
}

//------------------------------------------------------------------------------
void vtkCascadedPlan::Collect(vtkShadowQueryReader& reader, vtkTypeInt64 fewPixels)
{
  if (this->Pending == 0)
  {
    return;
  }
  for (int i = 0; i < this->Pending; ++i)
  {
    if (!reader.IsAvailable(this->Queries.GetName(i)))
    {
      return;
    }
  }
  this->Counts.fill(0);
  this->LastLevel = 0;
  for (int i = 0; i < this->Pending; ++i)
  {
    this->Counts[i] = reader.GetResult(this->Queries.GetName(i));
    this->LastLevel = i > 0 && this->Counts[i] > fewPixels ? i : this->LastLevel;
  }
  this->Counted = this->Pending - 1;
  this->Pending = 0;
  this->WantsMore = this->GetLastLevel() >= this->Counted;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCascadedPlan::GetNumberOfPixelSamples() const
{
  vtkTypeInt64 samples = 0;
  vtkTypeInt64 before = 0;
  for (int level = 0; level < this->Counted; ++level)
  {
    const vtkTypeInt64 edge = this->IsHard ? 1 : (1 << level) + 1;
    samples += this->Counts[level] * (edge * edge - before);
    before = edge * edge;
  }
  return samples;
}

//------------------------------------------------------------------------------
void vtkCascadedPlan::ReleaseGraphicsResources()
{
  this->Queries.Release();
  this->Pending = 0;
}
VTK_ABI_NAMESPACE_END
