// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The keys of the scene file, written once: what reads, writes or lists them is a visitor with
 *
 *   template <typename T> void operator()(const char* key, T& value, Range range);
 *
 * T is bool, int, double, a std::array of doubles, LightShape, std::string or a std::optional of
 * these. A value whose key is absent is left as it is.
 */

#ifndef SceneKeys_h
#define SceneKeys_h

#include "SceneDescription.h"

#include <limits>

namespace softshadows
{

/// Allowed values of a number, or of every number of a list.
struct Range
{
  double Least = -std::numeric_limits<double>::infinity();
  double Most = std::numeric_limits<double>::infinity();
  bool WithoutLeast = false; ///< The least value itself is not allowed.
  bool WithoutMost = false;
};

constexpr Range Any{};
constexpr Range NotNegative{ 0.0 };
constexpr Range Positive{ 0.0, std::numeric_limits<double>::infinity(), true };
constexpr Range Unit{ 0.0, 1.0 };
constexpr Range Circle{ 0.0, 360.0 };

/// Of images: what graphics drivers can be trusted with.
constexpr Range ImageEdge{ 1, 16384 };
/// Of spheres, tori and planes: 4096 x 4096 cells are 33 million triangles.
constexpr Range Cells{ 1, 4096 };
constexpr Range Around{ 3, 4096 };
/// VTK's largest cell (VTK_CELL_SIZE) is the cap of a cylinder or cone.
constexpr Range CapCorners{ 3, 512 };

template <typename Visitor>
void DescribeImage(Visitor& visit, SceneDescription& scene)
{
  visit("width", scene.Width, ImageEdge);
  visit("height", scene.Height, ImageEdge);
}

template <typename Visitor>
void Describe(Visitor& visit, CameraDescription& camera)
{
  visit("position", camera.Position, Any);
  visit("focal_point", camera.FocalPoint, Any);
  visit("view_up", camera.ViewUp, Any);
  visit("view_angle", camera.ViewAngle, Range{ 0.0, 180.0, true, true });
  visit("parallel_scale", camera.ParallelScale, Positive);
}

/// Which keys there are depends on `Directional`, which is to be right beforehand.
template <typename Visitor>
void Describe(Visitor& visit, LightDescription& light)
{
  visit("directional", light.Directional, Any);
  visit("position", light.Position, Any);
  visit("focal_point", light.FocalPoint, Any);
  visit("view_up", light.ViewUp, Any);
  if (light.Directional)
  {
    visit("angular_diameter", light.AngularDiameter, Range{ 0.0, 170.0 });
  }
  else
  {
    visit("shape", light.Shape, Any);
    visit("size", light.Size, NotNegative);
    visit("cone_angle", light.ConeAngle, Positive);
  }
  visit("color", light.Color, NotNegative);
  visit("intensity", light.Intensity, NotNegative);
}

/// Of every object, whatever its shape.
template <typename Visitor>
void DescribeCommon(Visitor& visit, ObjectDescription& object)
{
  visit("matrix", object.Matrix, Any);
  visit("color", object.Color, Unit);
  visit("cast_shadow", object.CastShadow, Any);
  visit("receive_shadow", object.ReceiveShadow, Any);
}

template <typename Visitor>
void Describe(Visitor& visit, ModelShape& model)
{
  visit("file", model.File, Any);
}

template <typename Visitor>
void Describe(Visitor& visit, PlaneShape& plane)
{
  visit("origin", plane.Origin, Any);
  visit("point1", plane.Point1, Any);
  visit("point2", plane.Point2, Any);
  visit("x_resolution", plane.XResolution, Cells);
  visit("y_resolution", plane.YResolution, Cells);
}

template <typename Visitor>
void Describe(Visitor& visit, BoxShape& box)
{
  visit("bounds", box.Bounds, Any);
}

template <typename Visitor>
void Describe(Visitor& visit, SphereShape& sphere)
{
  visit("center", sphere.Center, Any);
  visit("radius", sphere.Radius, Positive);
  visit("theta_resolution", sphere.ThetaResolution, Around);
  visit("phi_resolution", sphere.PhiResolution, Around);
  visit("start_theta", sphere.StartTheta, Circle);
  visit("end_theta", sphere.EndTheta, Circle);
  visit("start_phi", sphere.StartPhi, Circle);
  visit("end_phi", sphere.EndPhi, Circle);
}

template <typename Visitor>
void Describe(Visitor& visit, CylinderShape& cylinder)
{
  visit("center", cylinder.Center, Any);
  visit("radius", cylinder.Radius, Positive);
  visit("height", cylinder.Height, Positive);
  visit("resolution", cylinder.Resolution, CapCorners);
  visit("capping", cylinder.Capping, Any);
}

template <typename Visitor>
void Describe(Visitor& visit, ConeShape& cone)
{
  visit("center", cone.Center, Any);
  visit("radius", cone.Radius, Positive);
  visit("height", cone.Height, Positive);
  visit("resolution", cone.Resolution, CapCorners);
  visit("direction", cone.Direction, Any);
  visit("capping", cone.Capping, Any);
}

template <typename Visitor>
void Describe(Visitor& visit, TorusShape& torus)
{
  visit("ring_radius", torus.RingRadius, Positive);
  visit("cross_section_radius", torus.CrossSectionRadius, Positive);
  visit("u_resolution", torus.UResolution, Around);
  visit("v_resolution", torus.VResolution, Around);
}

///@{
/// Value of "source" for each shape that is one.
inline const char* SourceName(const ModelShape&)
{
  return nullptr;
}
inline const char* SourceName(const PlaneShape&)
{
  return "plane";
}
inline const char* SourceName(const BoxShape&)
{
  return "box";
}
inline const char* SourceName(const SphereShape&)
{
  return "sphere";
}
inline const char* SourceName(const CylinderShape&)
{
  return "cylinder";
}
inline const char* SourceName(const ConeShape&)
{
  return "cone";
}
inline const char* SourceName(const TorusShape&)
{
  return "torus";
}
///@}

/// Names of LightShape's values, in their order.
constexpr const char* LightShapeNames[] = { "rectangle", "disk", "point" };

}

#endif
