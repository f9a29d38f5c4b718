// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SceneChanges.h
 * @brief Changes to a scene that has been built, for measurements.
 */

#ifndef SoftShadowsBenchmark_SceneChanges_h
#define SoftShadowsBenchmark_SceneChanges_h

class vtkRenderer;

namespace softshadows
{

/// Scales the extents of all area lights. 0 makes points of them: shadows are hard.
void ScaleLights(vtkRenderer* renderer, double scale);

/**
 * Leaves the given one of the lights that are switched on, white and of intensity 1, and makes all
 * surfaces white and diffuse without ambient or specular parts, the background black. So a pixel
 * shows the cosine at its surface times the light's visibility and fall-off.
 */
void KeepOneWhiteLight(vtkRenderer* renderer, int litLight);

}

#endif
