// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSeparableReuseCount.h"

#include "vtkImageData.h"

#include <limits>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkSeparableReuseCount::Add(vtkTypeInt64 frame)
{
  this->Size[0] = this->Shares[0]->GetWidth();
  this->Size[1] = this->Shares[0]->GetHeight();
  for (int stage = 0; stage < Stages; ++stage)
  {
    const std::vector<float> shares = this->Shares[stage]->ReadLayer(0);
    Stage& total = this->Totals[stage];
    if (this->Frame != frame || total.Counts.size() != shares.size())
    {
      total.Counts.assign(shares.size(), 0);
      total.Sums.assign(shares.size(), 0.0f);
    }
    for (size_t i = 0; i < shares.size(); ++i)
    {
      if (shares[i] != Uncounted)
      {
        ++total.Counts[i];
        total.Sums[i] += shares[i];
      }
    }
  }
  this->Frame = frame;
}

//------------------------------------------------------------------------------
bool vtkSeparableReuseCount::Has(int stage) const
{
  return stage >= 0 && stage < Stages && !this->Totals[stage].Counts.empty();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkSeparableReuseCount::MakeImage(int stage) const
{
  if (!this->Has(stage))
  {
    return nullptr;
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(this->Size[0], this->Size[1], 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  const Stage& total = this->Totals[stage];
  for (size_t i = 0; i < total.Counts.size(); ++i)
  {
    values[i] = total.Counts[i] > 0 ? total.Sums[i] / static_cast<float>(total.Counts[i])
                                    : std::numeric_limits<float>::quiet_NaN();
  }
  return image;
}

//------------------------------------------------------------------------------
double vtkSeparableReuseCount::GetShare(int stage) const
{
  if (!this->Has(stage))
  {
    return 0.0;
  }
  double sum = 0.0;
  double count = 0.0;
  for (size_t i = 0; i < this->Totals[stage].Counts.size(); ++i)
  {
    sum += this->Totals[stage].Sums[i];
    count += this->Totals[stage].Counts[i];
  }
  return count > 0.0 ? sum / count : 0.0;
}
VTK_ABI_NAMESPACE_END
