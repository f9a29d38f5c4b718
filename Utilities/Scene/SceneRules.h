// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the values of a scene file must be beyond their type and range. Everything refused is a
 * SceneError with file, line and key.
 */

#ifndef SceneRules_h
#define SceneRules_h

#include "SceneDescription.h"
#include "SceneKeyReader.h"

namespace softshadows
{

///@{
/// Shapes without extent.
void CheckShape(const KeyReader& keys, const ModelShape& model);
void CheckShape(const KeyReader& keys, const PlaneShape& plane);
void CheckShape(const KeyReader& keys, const BoxShape& box);
void CheckShape(const KeyReader& keys, const SphereShape& sphere);
void CheckShape(const KeyReader& keys, const ConeShape& cone);
inline void CheckShape(const KeyReader&, const CylinderShape&) {}
inline void CheckShape(const KeyReader&, const TorusShape&) {}
///@}

/// Affine, written row by row, and invertible.
void CheckMatrix(const KeyReader& keys, const std::array<double, 16>& matrix);

/// Of lights and cameras: position and focal point apart, so that there is a direction.
void CheckDirection(const KeyReader& keys, const Vector3& position, const Vector3& focalPoint);

/// Not along the camera's direction.
void CheckViewUp(const KeyReader& keys, const CameraDescription& camera);

}

#endif
