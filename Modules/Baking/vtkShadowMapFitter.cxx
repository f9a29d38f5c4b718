// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowMapFitter.h"

#include "vtkMath.h"
#include "vtkShadowProjection.h"
#include "vtkShadowSides.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Body = vtkShadowCasters::Body;
using Part = vtkShadowProjection::Part;
using Window = vtkShadowProjection::Window;

constexpr double LARGEST_TANGENT = 11.430052302761343; // tan(85 degrees)
constexpr double FACE_TANGENT = 1.05;                  // of a cube's face, with its border
constexpr double NEAREST = 1e-7;                       // of the far distance
constexpr double FAR_AWAY = 1e5;                       // in radii of the scene
constexpr double MARGIN = 1.0 / 30.0 + 1e-6;           // (1 + 2 m) / 32 <= m
constexpr double DEPTH_MARGIN = 0.01;                  // of the depth
constexpr double THINNEST = 1e-3;                      // of a window's longer edge

Window Intersect(const Window& a, const Window& b)
{
  return { { std::max(a[0], b[0]), std::min(a[1], b[1]), std::max(a[2], b[2]),
    std::min(a[3], b[3]) } };
}

bool IsEmpty(const Window& window)
{
  return !(window[0] <= window[1] && window[2] <= window[3]);
}

bool Contains(const Part& whole, const Part& part)
{
  return !whole.Empty && whole.Extent[0] <= part.Extent[0] && whole.Extent[1] >= part.Extent[1] &&
    whole.Extent[2] <= part.Extent[2] && whole.Extent[3] >= part.Extent[3] &&
    whole.Nearest <= part.Nearest && whole.Farthest >= part.Farthest;
}

void Unite(Part& whole, const Part& part)
{
  if (whole.Empty)
  {
    whole = part;
  }
  else if (!part.Empty)
  {
    whole.Extent = { { std::min(whole.Extent[0], part.Extent[0]),
      std::max(whole.Extent[1], part.Extent[1]), std::min(whole.Extent[2], part.Extent[2]),
      std::max(whole.Extent[3], part.Extent[3]) } };
    whole.Nearest = std::min(whole.Nearest, part.Nearest);
    whole.Farthest = std::max(whole.Farthest, part.Farthest);
  }
}

// Can shadow itself: a plane cannot.
bool IsItsOwnReceiver(const Body& body)
{
  return !body.Flat && body.Receives;
}

// The part of one depth map's work: an emitter and what it sees of the bodies.
class Fit
{
public:
  Fit(const std::vector<Body>& bodies, const vtkShadowEmitter& emitter, const Window& limit)
    : Bodies(bodies)
    , Emitter(emitter)
  {
    const vtkShadowProjection projection(emitter, limit);
    this->Parts.reserve(bodies.size());
    std::transform(bodies.begin(), bodies.end(), std::back_inserter(this->Parts),
      [&projection](const Body& body) { return projection.Project(body); });
  }

  // What the effective casters cover.
  Part Run()
  {
    Part covered;
    for (std::size_t i = 0; i < this->Bodies.size(); ++i)
    {
      if (this->Bodies[i].Casts && IsItsOwnReceiver(this->Bodies[i]))
      {
        Unite(covered, this->Parts[i]);
      }
    }
    for (std::size_t i = 0; i < this->Bodies.size(); ++i)
    {
      if (this->Bodies[i].Casts && !IsItsOwnReceiver(this->Bodies[i]) && !this->Parts[i].Empty &&
        !Contains(covered, this->Parts[i]))
      {
        Unite(covered, this->EffectivePart(i));
      }
    }
    return covered;
  }

private:
  // How far the emitter's extent moves the shadow of something at depth nearest on something at depth
  // farthest, in the units of the window.
  std::array<double, 2> Penumbra(double nearest, double farthest) const
  {
    const double least = std::max(nearest, NEAREST * farthest);
    const double scale =
      this->Emitter.Directional ? farthest - nearest : std::max(1.0 / least - 1.0 / farthest, 0.0);
    return { { this->Emitter.HalfSize[0] * scale, this->Emitter.HalfSize[1] * scale } };
  }

  // The part of a caster in front of which, seen from the receivers, the light is.
  //
  // Most often one large body, the same for many casters, takes the shadow of the whole caster: it is
  // asked first, or thousands of flat casters would each ask thousands of bodies.
  Part EffectivePart(std::size_t index)
  {
    const Body& caster = this->Bodies[index];
    const Part& part = this->Parts[index];
    const int side = caster.Flat ? vtkShadowSides::OfEmitter(caster, this->Emitter) : 0;
    Part shadowing;
    for (std::size_t step = 0; step <= this->Bodies.size(); ++step)
    {
      const std::size_t i = step == 0 ? this->LastBehind : step - 1;
      const Part& behind = this->Parts[i];
      if (i == index || !this->Bodies[i].Receives || behind.Empty ||
        behind.Farthest <= part.Nearest ||
        !vtkShadowSides::ReachesBehind(caster, side, this->Bodies[i]))
      {
        continue;
      }
      const auto penumbra = this->Penumbra(part.Nearest, behind.Farthest);
      const Window reach = { { behind.Extent[0] - penumbra[0], behind.Extent[1] + penumbra[0],
        behind.Extent[2] - penumbra[1], behind.Extent[3] + penumbra[1] } };
      const Window shared = Intersect(part.Extent, reach);
      if (!IsEmpty(shared))
      {
        Unite(shadowing, { false, shared, part.Nearest, part.Farthest });
        if (shadowing.Extent == part.Extent)
        {
          this->LastBehind = i;
          return shadowing;
        }
      }
    }
    if (shadowing.Empty)
    {
      return shadowing;
    }
    // Only so much of it counts, and that may be less deep.
    return vtkShadowProjection(this->Emitter, shadowing.Extent).Project(caster);
  }

  const std::vector<Body>& Bodies;
  const vtkShadowEmitter& Emitter;
  std::vector<Part> Parts;
  std::size_t LastBehind = 0; // that took the shadow of a whole caster
};

// Half the width of a cube's face at distance 1. What blocks a receiver within the face may lie
// outside it by the emitter's extent over the blocker's depth.
double GetFaceTangent(const vtkShadowEmitter& emitter, const std::vector<Body>& bodies)
{
  const double extent = std::max(emitter.HalfSize[0], emitter.HalfSize[1]);
  if (!(extent > 0.0))
  {
    return FACE_TANGENT;
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (const Body& body : bodies)
  {
    double distance = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double c = emitter.Center[i];
      const double offset = std::max({ body.Bounds[2 * i] - c, c - body.Bounds[2 * i + 1], 0.0 });
      distance += offset * offset;
    }
    nearest = body.Casts ? std::min(nearest, std::sqrt(distance)) : nearest;
  }
  // Towards a corner of the cube a distance is sqrt(3) times its part along the face's direction.
  return std::min(FACE_TANGENT + std::sqrt(3.0) * extent / nearest, LARGEST_TANGENT);
}

void SetWindow(const Part& covered, vtkShadowMapView& view)
{
  const double width = covered.Extent[1] - covered.Extent[0];
  const double height = covered.Extent[3] - covered.Extent[2];
  const double depth = view.Emitter.Directional ? covered.Farthest - covered.Nearest : 1.0;
  // Something seen edge-on, or a point, still needs a window.
  const double thinnest = std::max({ THINNEST * width, THINNEST * height, 1e-6 * depth, 1e-30 });
  for (int axis = 0; axis < 2; ++axis)
  {
    const double low = covered.Extent[2 * axis];
    const double high = covered.Extent[2 * axis + 1];
    const double half = 0.5 * std::max(high - low, thinnest) * (1.0 + 2.0 * MARGIN);
    view.Window[2 * axis] = 0.5 * (low + high) - half;
    view.Window[2 * axis + 1] = 0.5 * (low + high) + half;
  }
}

// The ball around all bodies, its middle on a raster of its size, so that it rests while things move.
double FindBall(const std::vector<Body>& bodies, std::array<double, 3>& middle)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double squares = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    double low = infinity;
    double high = -infinity;
    for (const Body& body : bodies)
    {
      low = std::min(low, body.Bounds[2 * axis]);
      high = std::max(high, body.Bounds[2 * axis + 1]);
    }
    middle[axis] = 0.5 * (low + high);
    squares += 0.25 * (high - low) * (high - low);
  }
  const double radius = std::sqrt(squares);
  if (!(radius > 0.0) || !std::isfinite(radius))
  {
    return 0.0;
  }
  const double step = std::exp2(std::ceil(std::log2(radius)));
  for (double& coordinate : middle)
  {
    coordinate = step * std::round(coordinate / step);
  }
  return 3.0 * radius;
}

// The axes and the size of an emitter as they look along a direction, at distance 1.
void Foreshorten(const std::array<double, 3>& direction, vtkShadowEmitter& emitter)
{
  constexpr double ALIGNED = 1e-9;
  const double cosine = vtkMath::Dot(emitter.Direction.data(), direction.data());
  std::array<double, 3> u = emitter.AxisU;
  std::array<double, 3> v = emitter.AxisV;
  std::array<double, 2> shares{ { 1.0, 1.0 } };
  for (int i = 0; i < 3; ++i)
  {
    u[i] -= vtkMath::Dot(emitter.AxisU.data(), direction.data()) * direction[i];
    v[i] -= vtkMath::Dot(emitter.AxisV.data(), direction.data()) * direction[i];
  }
  std::array<double, 3> tilt = emitter.Direction;
  for (int i = 0; i < 3; ++i)
  {
    tilt[i] -= cosine * direction[i];
  }
  const bool isRound =
    emitter.Shape == vtkShadowEmitter::DISK && emitter.HalfSize[0] == emitter.HalfSize[1];
  if (isRound && vtkMath::Normalize(tilt.data()) > ALIGNED)
  {
    // Flattened along the tilt, as wide as ever across it.
    shares[0] = std::abs(cosine);
    vtkMath::Cross(tilt.data(), direction.data(), v.data());
  }
  else
  {
    shares = { { vtkMath::Norm(u.data()), vtkMath::Norm(v.data()) } };
  }
  emitter.Direction = direction;
  if (!(vtkMath::Normalize(v.data()) > ALIGNED))
  {
    vtkMath::Perpendiculars(direction.data(), nullptr, v.data(), 0.0);
  }
  emitter.AxisV = v;
  vtkMath::Cross(direction.data(), v.data(), emitter.AxisU.data());
  emitter.HalfSize = { { emitter.HalfSize[0] * shares[0], emitter.HalfSize[1] * shares[1] } };
}

void SetDepths(const Part& covered, vtkShadowMapView& view)
{
  if (view.Emitter.Directional)
  {
    const double window =
      std::max(view.Window[1] - view.Window[0], view.Window[3] - view.Window[2]);
    const double margin = DEPTH_MARGIN * std::max(covered.Farthest - covered.Nearest, window);
    view.Near = covered.Nearest - margin;
    view.Far = covered.Farthest + margin;
  }
  else
  {
    view.Far = covered.Farthest * (1.0 + DEPTH_MARGIN);
    view.Near = std::max(covered.Nearest * (1.0 - DEPTH_MARGIN), NEAREST * view.Far);
  }
}
}

//------------------------------------------------------------------------------
vtkShadowMapFitter::vtkShadowMapFitter(const std::vector<vtkShadowCasters::Body>& bodies)
  : Bodies(bodies)
{
}

//------------------------------------------------------------------------------
bool vtkShadowMapFitter::Fit(const vtkShadowEmitter& emitter, vtkShadowMapView& view) const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double tangent = emitter.Directional ? infinity
    : emitter.Face                           ? GetFaceTangent(emitter, this->Bodies)
                                             : LARGEST_TANGENT;
  const Window limit = { { -tangent, tangent, -tangent, tangent } };
  const Part covered = ::Fit(this->Bodies, emitter, limit).Run();
  if (covered.Empty)
  {
    return false;
  }
  view.Emitter = emitter;
  SetWindow(covered, view);
  SetDepths(covered, view);
  return true;
}

//------------------------------------------------------------------------------
int vtkShadowMapFitter::CountTooNear(const vtkShadowMapView& view) const
{
  if (view.Emitter.Directional || view.Near > 2.0 * NEAREST * view.Far)
  {
    return 0;
  }
  const Window limit = { { -LARGEST_TANGENT, LARGEST_TANGENT, -LARGEST_TANGENT, LARGEST_TANGENT } };
  const vtkShadowProjection projection(view.Emitter, limit);
  return static_cast<int>(std::count_if(this->Bodies.begin(), this->Bodies.end(),
    [&projection, &view](const Body& body)
    {
      const Part part = projection.Project(body);
      return body.Casts && !part.Empty && part.Farthest < view.Near;
    }));
}

//------------------------------------------------------------------------------
vtkShadowEmitter vtkShadowMapFitter::SeeFromAfar(const vtkShadowEmitter& emitter) const
{
  if (emitter.Directional || this->Bodies.empty())
  {
    return emitter;
  }
  std::array<double, 3> middle{};
  const double radius = FindBall(this->Bodies, middle);
  std::array<double, 3> direction{};
  double most = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    direction[i] = middle[i] - emitter.Center[i];
    most = std::max(most, std::abs(direction[i]));
  }
  if (!(radius > 0.0) || !(most > FAR_AWAY * radius))
  {
    return emitter;
  }
  for (double& coordinate : direction)
  {
    coordinate /= most; // or its square may overflow
  }
  const double distance = most * vtkMath::Normalize(direction.data());
  const double cosine = vtkMath::Dot(emitter.Direction.data(), direction.data());
  const double angle = std::acos(std::min(std::max(cosine, -1.0), 1.0));
  if (!emitter.Omni && angle + radius / distance >= vtkMath::RadiansFromDegrees(emitter.ConeAngle))
  {
    return emitter;
  }
  vtkShadowEmitter parallel = emitter;
  Foreshorten(direction, parallel);
  parallel.HalfSize = { { parallel.HalfSize[0] / distance, parallel.HalfSize[1] / distance } };
  parallel.Directional = true;
  parallel.Omni = false;
  parallel.ConeAngle = 90.0;
  parallel.Center = middle;
  parallel.Apex = middle;
  return parallel;
}

//------------------------------------------------------------------------------
std::vector<vtkShadowMapView> vtkShadowMapFitter::FitAll(const vtkShadowEmitter& emitter) const
{
  std::vector<vtkShadowMapView> views;
  vtkShadowMapView view;
  for (const vtkShadowEmitter& face : emitter.Faces())
  {
    if (this->Fit(face, view))
    {
      views.push_back(view);
    }
  }
  return views;
}

VTK_ABI_NAMESPACE_END
