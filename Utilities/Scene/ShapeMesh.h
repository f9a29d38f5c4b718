// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The polygons of a scene's shapes.
 */

#ifndef ShapeMesh_h
#define ShapeMesh_h

#include "ModelStore.h"
#include "SceneDescription.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace softshadows
{

/**
 * The mesh of a shape in its own coordinates: VTK's source of that name with points in double, or
 * the file that the store finds. Throws SceneError for files.
 */
vtkSmartPointer<vtkPolyData> MakeMesh(
  const ShapeDescription& shape, const std::string& sceneFolder, ModelStore& models);

}

#endif
