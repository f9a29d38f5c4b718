// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads a scene file.
 *
 * A scene is one JSON object with the keys
 *
 *   version   1; must be there
 *   image     {width, height}: pixels, 1 to 16384; default 640 x 480
 *   camera    {position, focal_point, view_up, view_angle | parallel_scale}: position must be
 * there; left out as a whole, a camera sees all objects lights    list of {position, focal_point,
 * view_up, color, intensity} and, for directional lights
 *             ("directional": true), angular_diameter; for others shape, size, cone_angle. position
 *             must be there, and so must size, unless the shape is "point"
 *   objects   list of {matrix, color, cast_shadow, receive_shadow} and either file or source with
 *             the keys of that source: plane, box, sphere, cylinder, cone, torus
 *
 * Keys left out have VTK's defaults (see SceneDescription.h); image, lights and objects may be left
 * out too. Nothing else is accepted: unknown keys, keys given twice, wrong types, lists of a wrong
 * length, values out of range and shapes without extent are errors.
 */

#ifndef SceneReader_h
#define SceneReader_h

#include "SceneDescription.h"
#include "SceneError.h"

#include <string>

namespace softshadows
{

/**
 * Reads the text of a scene file. Opens no files: models are looked for when the scene is built.
 * Throws SceneError, which names file, line and key. The file's name serves messages and gives the
 * folder in which models are looked for.
 */
SceneDescription ParseScene(const std::string& text, const std::string& fileName);

/// Reads a scene file. Throws SceneError, also when the file cannot be read.
SceneDescription ReadScene(const std::string& fileName);

}

#endif
