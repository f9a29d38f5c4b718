// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A scene around models that come without one.
 */

#ifndef ModelScene_h
#define ModelScene_h

#include "ModelStore.h"
#include "SceneDescription.h"

#include <string>
#include <vector>

namespace softshadows
{

/// Which axis of the models points up.
enum class UpAxis
{
  X,
  Y,
  Z
};

/**
 * The models as they are, and around them, with R the radius of the sphere around their bounding
 * box and the box's centre C:
 *  - a ground plane of 100 R x 100 R at their lowest point;
 *  - a camera with a view angle of 30 degrees, 30 degrees to the right of the front (the axis after
 *    the up axis in the cycle x, y, z, x), 20 degrees above the ground, 3.5 R away, aimed at C;
 *  - one key light: a square of 0.8 R x 0.8 R, 40 degrees to the left of the front, 50 degrees
 *    above the ground, 4 R away, aimed at C.
 * Throws SceneError for models that cannot be read.
 */
SceneDescription SceneAroundModels(
  const std::vector<std::string>& files, UpAxis up, ModelStore& models);

}

#endif
