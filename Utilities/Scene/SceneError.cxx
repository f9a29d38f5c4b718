// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneError.h"

#include <utility>

namespace softshadows
{
namespace
{

std::string Prefix(const ScenePlace& place)
{
  std::string prefix = place.File;
  if (place.Line > 0)
  {
    prefix += ":" + std::to_string(place.Line);
  }
  if (!prefix.empty())
  {
    prefix += ": ";
  }
  if (!place.Key.empty())
  {
    prefix += place.Key + ": ";
  }
  return prefix;
}

}

//--------------------------------------------------------------------------------------------------
SceneError::SceneError(ScenePlace place, const std::string& message)
  : std::runtime_error(Prefix(place) + message)
  , Place(std::move(place))
{
}

}
