// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowDrawnMappers.h"

#include <algorithm>
#include <functional>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkSoftShadowDrawnMappers::Add(const vtkProp* prop, const vtkAbstractMapper* mapper)
{
  this->Pairs.emplace_back(prop, mapper);
}

//------------------------------------------------------------------------------
bool vtkSoftShadowDrawnMappers::Contradicts(const vtkSoftShadowDrawnMappers& other) const
{
  if (this->Pairs == other.Pairs)
  {
    return false; // as in nearly every frame
  }
  using Pair = std::pair<const vtkProp*, const vtkAbstractMapper*>;
  const auto byProp = [](const Pair& a, const Pair& b) { return std::less<>()(a.first, b.first); };
  std::vector<Pair> sorted = other.Pairs;
  std::sort(sorted.begin(), sorted.end(), byProp);
  return std::any_of(this->Pairs.begin(), this->Pairs.end(),
    [&](const Pair& pair)
    {
      const auto range = std::equal_range(sorted.begin(), sorted.end(), pair, byProp);
      return range.first != range.second &&
        std::find(range.first, range.second, pair) == range.second;
    });
}
VTK_ABI_NAMESPACE_END
