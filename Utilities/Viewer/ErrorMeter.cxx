// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ErrorMeter.h"

#include "ErrorMeasures.h"
#include "Silhouettes.h"

#include <cmath>
#include <cstdio>
#include <limits>

namespace softshadows
{

//--------------------------------------------------------------------------------------------------
void ErrorMeter::Start(vtkRenderer* renderer, int width, int height, bool gaussian)
{
  // The viewer moves camera and lights, never surfaces.
  this->Snapshot = this->Snapshot
    ? std::make_shared<ReferenceSnapshot>(renderer, width, height, gaussian, *this->Snapshot)
    : std::make_shared<ReferenceSnapshot>(renderer, width, height, gaussian);
  this->Gaussian = gaussian;
  this->Started = true;
  this->Reference.Start(this->Snapshot, { 4, 8, 16, 32 });
}

//--------------------------------------------------------------------------------------------------
void ErrorMeter::Cancel()
{
  this->Reference.Cancel();
  this->Started = false;
  this->SilhouettesOf.reset();
}

//--------------------------------------------------------------------------------------------------
double ErrorMeter::Measure(int light, const std::vector<float>& visibility)
{
  const auto reference = this->GetReference();
  if (!reference)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const ReferenceVisibility& truth = reference->Images;
  if (reference != this->SilhouettesOf)
  {
    this->Silhouettes = FindSilhouettes(truth.Width, truth.Height, truth.Depth);
    this->SilhouettesOf = reference;
  }
  return MeasureErrors(
    truth.Width, truth.Height, truth.Visibility[light], visibility, this->Silhouettes)
    .All.Rmse;
}

//--------------------------------------------------------------------------------------------------
std::string ErrorMeter::Spell(double rmse) const
{
  const std::string failure = this->Reference.GetFailure();
  if (!failure.empty())
  {
    return "no error against ray tracing: " + failure;
  }
  std::string text;
  const auto reference = this->GetReference();
  if (reference)
  {
    char number[32];
    std::snprintf(number, sizeof(number), "%.4f", rmse);
    text = (std::isnan(rmse) ? std::string("no RMSE in this view")
                             : "RMSE " + std::string(number) + " to ray tracing") +
      " with " + std::to_string(reference->RaysPerPixel) + " rays per pixel";
  }
  const std::string progress = this->Reference.SpellProgress();
  if (!progress.empty())
  {
    text += (text.empty() ? "tracing " : "; now ") + progress;
  }
  return text;
}

}
