// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChangesInPlace.h
 * @brief Objects at every depth of a scene, and what may be changed in them while they stay the same.
 */

#ifndef SoftShadowsTesting_ChangesInPlace_h
#define SoftShadowsTesting_ChangesInPlace_h

#include "Props.h"

#include <functional> // For changes
#include <iosfwd>     // For names in messages
#include <string>     // For names
#include <vector>     // For lists

namespace SoftShadowsTesting
{

/// Puts something into the scene in place of its ball and returns what changes it.
using SceneChange = std::function<std::function<void()>(BallScene&)>;

struct ChangeInPlace
{
  std::string Name;
  SceneChange Make;
};

/// Changes after which other fragments exist, or lie elsewhere.
const std::vector<ChangeInPlace>& AllChangesInPlace();

///@{
/// Parts of that list: of actors and what hangs on them; of mappers and their inputs.
std::vector<ChangeInPlace> ChangesOfActors();
std::vector<ChangeInPlace> ChangesOfMappers();
///@}

/// Changes after which only colours are others.
const std::vector<ChangeInPlace>& AllChangesOfColors();

std::ostream& operator<<(std::ostream& os, const ChangeInPlace& change);

}

#endif
