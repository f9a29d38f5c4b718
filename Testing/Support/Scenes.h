// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Scenes.h
 * @brief Scenes whose visibility is known at every point of their receiving plane.
 *
 * A scene is described in local coordinates, its receiving plane z = 0, and placed in the world by
 * a scale and a translation: the visibility must not notice either.
 */

#ifndef SoftShadowsTesting_Scenes_h
#define SoftShadowsTesting_Scenes_h

#include "ClosedForms.h"
#include "Picture.h"
#include "WorldPositions.h"

#include "vtkSmartPointer.h" // For members

#include <functional> // For closed forms
#include <ostream>
#include <string> // For names
#include <vector> // For lists

class vtkActor;
class vtkAreaLight;
class vtkPolyData;
class vtkRenderer;

namespace SoftShadowsTesting
{

/// world = Scale * local + Translation
struct Placement
{
  double Scale = 1.0;
  Point Translation = { { 0.0, 0.0, 0.0 } };

  Point ToWorld(const Point& local) const;
  Point ToLocal(const Point& world) const;
};

/// A parallelogram with corners Origin, Origin + Edge1, Origin + Edge2 and Origin + Edge1 + Edge2.
struct Quad
{
  Point Origin;
  Point Edge1;
  Point Edge2;

  /// True if the segment between the two points meets the parallelogram.
  bool Blocks(const Point& from, const Point& to) const;
};

/// Parallelograms as one data set, its points in double and in world coordinates.
vtkSmartPointer<vtkPolyData> MakeQuads(
  const std::vector<Quad>& quads, const Placement& placement = Placement());

/// A matte actor of them: no ambient, no specular light.
vtkSmartPointer<vtkActor> MakeQuadActor(
  const std::vector<Quad>& quads, const Placement& placement = Placement());

/// The six sides of a box {xmin, xmax, ymin, ymax, zmin, zmax}.
std::vector<Quad> BoxQuads(const std::array<double, 6>& bounds);

struct Scene
{
  std::string Description;
  Weights LightWeights = Weights::Mean;
  Placement Where;

  /// Camera, light and actors, ready to be added to a window.
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkAreaLight> Light;
  vtkSmartPointer<vtkActor> ReceiverActor;
  std::vector<vtkSmartPointer<vtkActor>> BlockerActors;

  ///@{
  /// In local coordinates.
  std::vector<Quad> Blockers;
  /// Bounds {xmin, xmax, ymin, ymax} on the plane z = 0 within which the closed form holds.
  std::array<double, 4> Region;
  std::function<double(const Point&)> Visibility;
  /// A coordinate across one edge's penumbra, NaN where there is no such thing (corners).
  std::function<double(const Point&)> Across;
  ///@}

  /// The receiving plane in world coordinates.
  Plane GetReceiver() const;
};

///@{
/// A rectangle over the plane under a parallel rectangle light. One blocker depth.
Scene MakeRectangleScene(Weights weights, const Placement& placement = Placement());
/// A half plane under a parallel disk light. One blocker depth.
Scene MakeDiskScene(const Placement& placement = Placement());
/**
 * A half plane, perpendicular to the sun's direction, under a sun of so many degrees that stands
 * vertically above the receiving plane, or inclined to it. One blocker depth.
 */
Scene MakeSunScene(double degrees, bool inclined, const Placement& placement = Placement());
///@}

using SceneFactory = std::function<Scene(const Placement&)>;

struct NamedScene
{
  std::string Name;
  SceneFactory Make;

  /// Else GoogleTest prints the bytes, padding and all, and valgrind complains.
  friend void PrintTo(const NamedScene& scene, std::ostream* os) { *os << scene.Name; }
};

/// All of the above that have uniform weights. Makes no scene, so it may be called anywhere.
std::vector<NamedScene> ClosedFormScenes();

/// One pixel that shows the receiving plane where the closed form holds.
struct PlanePixel
{
  int X;
  int Y;
  Point World;
  double Expected;
  double Across;
};

/**
 * The pixels of a picture of width x height (bottom row first) for which the scene knows the
 * answer: the point lies in the region and no blocker hides it from the camera.
 */
std::vector<PlanePixel> GetPlanePixels(const Scene& scene, int width, int height);

/// The expected visibility as a picture of one channel; NaN where the scene does not know it.
Picture ExpectedPicture(const Scene& scene, int width, int height);

}

#endif
