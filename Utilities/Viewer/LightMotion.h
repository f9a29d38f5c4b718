// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Moving and resizing the light of a scene description.
 */

#ifndef LightMotion_h
#define LightMotion_h

#include "SceneDescription.h"

namespace softshadows
{

/// The world axis nearest to a direction, such as a camera's view up.
Vector3 NearestAxis(const Vector3& direction);

/// Turns the light around its focal point, about an axis of unit length. Degrees, right-handed.
void TurnLight(LightDescription& light, const Vector3& up, double degrees);

/**
 * Turns the light around its focal point towards the axis up. It stops 2 degrees before the axis,
 * where turning would lose its direction, and before the opposite axis.
 */
void RaiseLight(LightDescription& light, const Vector3& up, double degrees);

/// Multiplies the distance to the focal point. Directional lights are at no distance: unchanged.
void ScaleLightDistance(LightDescription& light, double factor);

/**
 * Multiplies both sizes, or the angular diameter, which stays below 170 degrees. Lights without
 * extent get one when they are to grow: a hundredth of the distance, or half a degree.
 */
void ScaleLightSize(LightDescription& light, double factor);

/// "0.4 x 0.4", "0.53 degrees", "point"
std::string SpellLightSize(const LightDescription& light);

}

#endif
