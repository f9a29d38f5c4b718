// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a scene file says, as plain values. No VTK objects, no files opened; see SceneBuilder.h for
 * the step from here to a renderer and Documentation of the format in SceneReader.h.
 */

#ifndef SceneDescription_h
#define SceneDescription_h

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace softshadows
{

using Vector2 = std::array<double, 2>;
using Vector3 = std::array<double, 3>;
using Box = std::array<double, 6>; ///< xmin, xmax, ymin, ymax, zmin, zmax

/// Where in which file something was written; what an error message starts with.
struct ScenePlace
{
  std::string File; ///< As the user named it; empty for scenes that were not read.
  int Line = 0;     ///< First line is 1; 0 is unknown.
  std::string Key;  ///< Path of the key, such as objects[2].color; empty for the whole file.
};

/// "file" of an object: a mesh of one of the kinds ply, obj, stl, vtp, glb, gltf.
struct ModelShape
{
  std::string File; ///< As written; relative names are looked up when the mesh is loaded.
  ScenePlace Place; ///< Of the key "file".
};

///@{
/// VTK's sources of these names. The values here are VTK's own defaults.
struct PlaneShape
{
  Vector3 Origin{ { -0.5, -0.5, 0.0 } };
  Vector3 Point1{ { 0.5, -0.5, 0.0 } };
  Vector3 Point2{ { -0.5, 0.5, 0.0 } };
  int XResolution = 1;
  int YResolution = 1;
};

struct BoxShape
{
  Box Bounds{ { -0.5, 0.5, -0.5, 0.5, -0.5, 0.5 } };
};

struct SphereShape
{
  Vector3 Center{ { 0.0, 0.0, 0.0 } };
  double Radius = 0.5;
  int ThetaResolution = 8;
  int PhiResolution = 8;
  double StartTheta = 0.0; ///< Degrees, like the next three.
  double EndTheta = 360.0;
  double StartPhi = 0.0;
  double EndPhi = 180.0;
};

/// Around the y axis.
struct CylinderShape
{
  Vector3 Center{ { 0.0, 0.0, 0.0 } };
  double Radius = 0.5;
  double Height = 1.0;
  int Resolution = 6;
  bool Capping = true;
};

/// The centre is half way up the axis, the tip points along Direction.
struct ConeShape
{
  Vector3 Center{ { 0.0, 0.0, 0.0 } };
  double Radius = 0.5;
  double Height = 1.0;
  int Resolution = 6;
  Vector3 Direction{ { 1.0, 0.0, 0.0 } };
  bool Capping = true;
};

/// vtkParametricTorus: around the z axis, centred at the origin.
struct TorusShape
{
  double RingRadius = 1.0;
  double CrossSectionRadius = 0.5;
  int UResolution = 50;
  int VResolution = 50;
};
///@}

using ShapeDescription =
  std::variant<ModelShape, PlaneShape, BoxShape, SphereShape, CylinderShape, ConeShape, TorusShape>;

struct ObjectDescription
{
  ShapeDescription Shape;
  /// Model to world, row by row; affine and invertible.
  std::array<double, 16> Matrix{ { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 } };
  /// Absent: the colours of the model, if its file is glTF and has some, else white.
  std::optional<Vector3> Color;
  bool CastShadow = true;
  bool ReceiveShadow = true;
  ScenePlace Place;
};

enum class LightShape
{
  Rectangle,
  Disk,
  Point
};

struct LightDescription
{
  bool Directional = false;
  Vector3 Position{ { 0.0, 0.0, 1.0 } };
  Vector3 FocalPoint{ { 0.0, 0.0, 0.0 } };
  /// Absent: the world axis least aligned with the direction.
  std::optional<Vector3> ViewUp;
  Vector3 Color{ { 1.0, 1.0, 1.0 } };
  double Intensity = 1.0;

  ///@{
  /// Of positional lights: world units; half angle in degrees, 90 and above is no cone.
  LightShape Shape = LightShape::Rectangle;
  Vector2 Size{ { 0.0, 0.0 } };
  double ConeAngle = 90.0;
  ///@}

  /// Of directional lights: degrees, 0 is a hard shadow.
  double AngularDiameter = 0.0;
};

struct CameraDescription
{
  Vector3 Position{ { 0.0, 0.0, 1.0 } };
  Vector3 FocalPoint{ { 0.0, 0.0, 0.0 } };
  Vector3 ViewUp{ { 0.0, 1.0, 0.0 } };
  double ViewAngle = 30.0; ///< Vertical, degrees.
  /// Half the height of the view in world units; set: the camera is parallel.
  std::optional<double> ParallelScale;
};

struct SceneDescription
{
  /// Relative names of models are looked up in this folder first.
  std::string Folder;
  int Width = 640;
  int Height = 480;
  /// Absent: a camera that looks along -z and sees everything, as VTK's own.
  std::optional<CameraDescription> Camera;
  std::vector<LightDescription> Lights;
  std::vector<ObjectDescription> Objects;
};

}

#endif
