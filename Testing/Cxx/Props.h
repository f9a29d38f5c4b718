// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Props.h
 * @brief Small props, lights and views that several tests put together.
 */

#ifndef SoftShadowsTesting_Props_h
#define SoftShadowsTesting_Props_h

#include "Scenes.h"

#include "vtkSmartPointer.h" // For results

#include <string> // For names
#include <vector> // For lists

class vtkActor;
class vtkAreaLight;
class vtkLight;
class vtkPolyDataAlgorithm;
class vtkProp;
class vtkRenderer;

namespace SoftShadowsTesting
{

///@{
/// Matte actors: no ambient, no specular light.
vtkSmartPointer<vtkActor> MakeActor(vtkPolyDataAlgorithm* source);
vtkSmartPointer<vtkActor> MakeSphereActor(const Point& center, double radius, int resolution = 32);
vtkSmartPointer<vtkActor> MakeBoxActor(const std::array<double, 6>& bounds);
/// z = height, |x| and |y| up to halfSize.
vtkSmartPointer<vtkActor> MakeGroundActor(double halfSize, double height = 0.0);
///@}

/// A renderer with a camera that looks from one point to another, z up, and no light.
vtkSmartPointer<vtkRenderer> MakeRenderer(
  const Point& from, const Point& to, double viewAngle = 30.0);

/// A disk light without a cone.
vtkSmartPointer<vtkAreaLight> MakeLamp(const Point& position, const Point& focalPoint, double size);

/// A directional light; direction is towards the light.
vtkSmartPointer<vtkAreaLight> MakeSun(const Point& toSun, double degrees);

/// The ways in which VTK can draw one and the same rectangle.
enum class Drawing
{
  Plain,
  Specular,
  Gouraud,
  PhysicallyBased,
  Composite,
  Glyph,
  Assembly
};

struct NamedDrawing
{
  std::string Name;
  Drawing Way;
};

const std::vector<NamedDrawing>& AllDrawings();

/// The parallelogram as a prop that is drawn in that way.
vtkSmartPointer<vtkProp> MakeReceiver(Drawing way, const Quad& quad);

/// A small ball over a ground plane with one lamp: a shadow that anything may be tried on.
struct BallScene
{
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkAreaLight> Lamp;
  vtkSmartPointer<vtkActor> Ground;
  vtkSmartPointer<vtkActor> Ball;
};

BallScene MakeBallScene(double lampSize = 0.3);

}

#endif
