// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowSchedule.h"

#include <algorithm>
#include <cmath>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// r / (1 - r), squared, for r = 0.55: what is left of the maps' error after one more doubling's gain.
constexpr float FloorFactor = 1.5f;
} // namespace

//------------------------------------------------------------------------------
void vtkSoftShadowSchedule::Start(int mapSize, int largestMapSize, double tolerance)
{
  this->Reset();
  this->MapSize = std::max(mapSize / 2, 16);
  this->LargestMapSize = std::max(largestMapSize, mapSize);
  this->Tolerance = tolerance;
}

//------------------------------------------------------------------------------
void vtkSoftShadowSchedule::Finish(bool converged)
{
  this->Converged = converged;
  this->Exhausted = this->Failed = !converged;
  this->EstimatedError = converged ? 0.0 : 1.0;
}

//------------------------------------------------------------------------------
std::string vtkSoftShadowSchedule::Describe() const
{
  std::ostringstream text;
  text.precision(3);
  if (!this->IsStarted() && !this->IsEnded())
  {
    text << "not started";
  }
  else if (this->Failed)
  {
    text << "there is no memory for a mean";
  }
  else if (!this->IsStarted())
  {
    text << "converged: nothing casts a shadow";
  }
  else
  {
    text << (this->Converged      ? "converged"
                : this->Exhausted ? "not converged"
                                  : "goes on")
         << ": estimated error " << this->EstimatedError << " after " << this->Count
         << " points with maps of " << this->MapSize << " texels";
    if (this->Exhausted && this->MapError > this->Tolerance)
    {
      text << ", whose texels alone leave " << this->MapError
           << (this->Lost ? "; there is no memory for larger maps"
                          : "; no larger maps are allowed");
    }
    else if (this->Exhausted)
    {
      text << ", the most points";
    }
  }
  return text.str();
}

//------------------------------------------------------------------------------
bool vtkSoftShadowSchedule::LoseMaps()
{
  if (!this->Grown || this->Lost)
  {
    this->Finish(false);
    return false;
  }
  // The floor is that of the last size, and held the mean of its first points: the next look compares
  // points, as if the maps had never grown.
  this->Lost = true;
  this->HasFloor = true;
  this->MapSize /= 2;
  this->Count = 0;
  this->Goal = 2 * FirstPoints;
  return true;
}

//------------------------------------------------------------------------------
float vtkSoftShadowSchedule::GetShare() const
{
  if (this->Failed || (this->Probing && !this->IsEnded()))
  {
    return 0.0f;
  }
  const int most = this->IsEnded() ? FirstPoints : std::min(this->Count, FirstPoints);
  return static_cast<float>(most) / static_cast<float>(FirstPoints);
}

//------------------------------------------------------------------------------
int vtkSoftShadowSchedule::GetRun(int most) const
{
  constexpr int half = FirstPoints / 2;
  const int next = this->ComparesMaps() && this->Count < half ? half : this->Goal;
  return std::min(most, next - this->Count);
}

//------------------------------------------------------------------------------
bool vtkSoftShadowSchedule::Advance(int points)
{
  this->Count += points;
  return this->Count >= this->Goal;
}

//------------------------------------------------------------------------------
vtkSoftShadowSchedule::NextType vtkSoftShadowSchedule::Look(const std::vector<float>& changes)
{
  if (this->Probing)
  {
    this->Probing = false;
    this->MapSize *= 2;
    this->Count = 0;
    return HOLD_AND_CLEAR;
  }
  return this->HasFloor ? this->LookAtPoints(changes) : this->LookAtMaps(changes);
}

//------------------------------------------------------------------------------
vtkSoftShadowSchedule::NextType vtkSoftShadowSchedule::LookAtMaps(const std::vector<float>& changes)
{
  this->Floor.resize(changes.size());
  std::transform(changes.begin(), changes.end(), this->Floor.begin(),
    [](float change) { return FloorFactor * std::max(change, 0.0f); }); // a mean of products
  const float worst =
    this->Floor.empty() ? 0.0f : *std::max_element(this->Floor.begin(), this->Floor.end());
  if (std::sqrt(worst) > 0.5 * this->Tolerance && 2 * this->MapSize <= this->LargestMapSize)
  {
    this->MapSize *= 2;
    this->Count = 0;
    this->Grown = true;
    return HOLD_AND_CLEAR;
  }
  this->HasFloor = true;
  this->Goal = 2 * FirstPoints;
  return HOLD;
}

//------------------------------------------------------------------------------
vtkSoftShadowSchedule::NextType vtkSoftShadowSchedule::LookAtPoints(
  const std::vector<float>& changes)
{
  float worst = 0.0f;
  float worstChange = 0.0f;
  float worstFloor = 0.0f;
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    worst = std::max(worst, changes[i] + this->Floor[i]);
    worstChange = std::max(worstChange, changes[i]);
    worstFloor = std::max(worstFloor, this->Floor[i]);
  }
  this->EstimatedError = std::sqrt(worst);
  this->MapError = std::sqrt(worstFloor);
  this->Converged = this->EstimatedError <= this->Tolerance;
  const bool hopeless = this->MapError > this->Tolerance && 16.0f * worstChange < worstFloor;
  this->Exhausted = !this->Converged && (hopeless || this->Count >= MostPoints);
  this->Goal *= 2;
  return this->IsEnded() ? END : HOLD;
}
VTK_ABI_NAMESPACE_END
