// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The one exception of the scene library: its text is "file:line: key: message".
 */

#ifndef SceneError_h
#define SceneError_h

#include "SceneDescription.h"

#include <stdexcept>
#include <string>

namespace softshadows
{

class SceneError : public std::runtime_error
{
public:
  SceneError(ScenePlace place, const std::string& message);

  const ScenePlace& GetPlace() const { return this->Place; }

private:
  ScenePlace Place;
};

}

#endif
