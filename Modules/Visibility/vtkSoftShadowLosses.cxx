// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowLosses.h"

#include <algorithm>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr int LongestDelay = 64; // frames
const std::string NoReason;
} // namespace

//------------------------------------------------------------------------------
void vtkSoftShadowLosses::Lose(int light, const std::string& reason)
{
  if (this->Reasons[light].empty())
  {
    this->Reasons[light] = reason;
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowLosses::LoseAll(const std::string& reason)
{
  for (size_t light = 0; light < this->Reasons.size(); ++light)
  {
    this->Lose(static_cast<int>(light), reason);
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowLosses::End()
{
  if (this->HasAny())
  {
    this->Left = this->Delay;
    this->Delay = std::min(2 * this->Delay, LongestDelay);
  }
  else
  {
    this->Delay = 1;
    this->Told.clear();
  }
}

//------------------------------------------------------------------------------
bool vtkSoftShadowLosses::HasAny() const
{
  return std::any_of(this->Reasons.begin(), this->Reasons.end(),
    [](const std::string& reason) { return !reason.empty(); });
}

//------------------------------------------------------------------------------
const std::string& vtkSoftShadowLosses::GetReason(int light) const
{
  return light >= 0 && light < static_cast<int>(this->Reasons.size()) ? this->Reasons[light]
                                                                      : NoReason;
}

//------------------------------------------------------------------------------
bool vtkSoftShadowLosses::IsRetryDue()
{
  return this->HasAny() && --this->Left <= 0;
}

//------------------------------------------------------------------------------
std::string vtkSoftShadowLosses::TakeNews(const std::vector<int>& names)
{
  std::ostringstream news;
  std::string reason;
  int count = 0;
  for (size_t light = 0; light < this->Reasons.size(); ++light)
  {
    if (!this->Reasons[light].empty() && this->Told.insert(names[light]).second)
    {
      news << (count > 0 ? ", " : "") << names[light];
      reason = count > 0 ? reason : this->Reasons[light];
      ++count;
    }
  }
  if (count == 0)
  {
    return NoReason;
  }
  return (count > 1 ? "Lights " : "Light ") + news.str() + (count > 1 ? " are" : " is") +
    " shown without shadows: " + reason + ".";
}
VTK_ABI_NAMESPACE_END
