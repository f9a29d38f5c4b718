// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HardScenes.h
 * @brief What the hard cases are put together from.
 */

#ifndef SoftShadowsTesting_HardScenes_h
#define SoftShadowsTesting_HardScenes_h

#include "HardCases.h"
#include "Props.h"

#include "vtkSmartPointer.h" // For results

class vtkActor;
class vtkAreaLight;
class vtkPolyData;
class vtkPolyDataAlgorithm;

namespace SoftShadowsTesting
{

/// The source's surface with its points in double and in world coordinates.
vtkSmartPointer<vtkPolyData> MakeMesh(
  vtkPolyDataAlgorithm* source, const Placement& placement = Placement());

/// A matte actor of a data set.
vtkSmartPointer<vtkActor> MakeMeshActor(vtkPolyData* mesh);

/// A sphere around a local point.
vtkSmartPointer<vtkPolyData> MakeSphere(const Point& center, double radius, int resolution = 24,
  const Placement& placement = Placement());

/// Three corners per triangle, each a point of its own, in double.
vtkSmartPointer<vtkPolyData> MakeTriangles(const std::vector<Point>& corners);

/// The scene that invariances start from: a ground, a ball over it and a box on it, one lamp.
struct BasicScene : HardScene
{
  vtkSmartPointer<vtkActor> Ground;
  vtkSmartPointer<vtkActor> Ball;
  vtkSmartPointer<vtkActor> Box;
  vtkSmartPointer<vtkAreaLight> Lamp;
};

BasicScene MakeBasicScene(const Placement& placement = Placement());

/// A ground, a camera and a lamp: what a caster is added to.
BasicScene MakeGroundScene();

}

#endif
