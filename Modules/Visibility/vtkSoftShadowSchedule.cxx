// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowSchedule.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// r / (1 - r), squared, for r = 0.6: what is left of the maps' error after one more doubling's gain.
constexpr float FloorFactor = 2.25f;
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
  return std::min(most, this->Goal - this->Count);
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
    [](float change) { return FloorFactor * change; });
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
  this->Converged = this->EstimatedError <= this->Tolerance;
  const bool hopeless = std::sqrt(worstFloor) > this->Tolerance && 16.0f * worstChange < worstFloor;
  this->Exhausted = !this->Converged && (hopeless || this->Count >= MostPoints);
  this->Goal *= 2;
  return this->IsEnded() ? END : HOLD;
}
VTK_ABI_NAMESPACE_END
