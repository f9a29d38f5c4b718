// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCascades.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"
#include "vtkShadowFrustumClip.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr double DepthStepsPerOctave = 4.0; // of the range's ends
constexpr double ParallelSteps = 8.0;       // of the range's length, at least
constexpr double FarAway = 1e30;        // farther than any depth; its reciprocal is a normal float
constexpr double NarrowestBand = 1e-6;  // of the depth: the shader divides by it
constexpr double DepthTolerance = 1e-5; // of the depth: a receiver's depth is a float

using Interval = vtkShadowCascades::Interval;
using Cascade = vtkShadowCascades::Cascade;

bool Overlap(const Interval& a, const Interval& b)
{
  return a.first <= b.second && b.first <= a.second;
}

double Distance(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return std::sqrt(
    (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

// The view's outline at a depth: its four corners, their mean and their distance from it.
struct Outline
{
  std::array<std::array<double, 3>, 4> Corners;
  std::array<double, 3> Middle = { { 0.0, 0.0, 0.0 } };
  double Radius = 0.0;
};

Outline FindOutline(const vtkShadowFrustumClip& frustum, double depth)
{
  Outline outline;
  for (int i = 0; i < 4; ++i)
  {
    outline.Corners[i] = frustum.CornerAt(i, depth);
    for (int axis = 0; axis < 3; ++axis)
    {
      outline.Middle[axis] += 0.25 * outline.Corners[i][axis];
    }
  }
  for (const auto& corner : outline.Corners)
  {
    outline.Radius = std::max(outline.Radius, Distance(corner, outline.Middle));
  }
  return outline;
}

// The smallest sphere with its centre on the line between the outlines' middles. Its radius depends
// on the depths and the view's angles, not on where the camera stands.
void FitSphere(const vtkShadowFrustumClip& frustum, Cascade& cascade)
{
  const Outline outlines[2] = { FindOutline(frustum, cascade.Covered.first),
    FindOutline(frustum, cascade.Covered.second) };
  const double length = Distance(outlines[0].Middle, outlines[1].Middle);
  const double squares =
    outlines[1].Radius * outlines[1].Radius - outlines[0].Radius * outlines[0].Radius;
  double along = length > 0.0 ? 0.5 * (1.0 + squares / (length * length)) : 0.0;
  along = std::min(std::max(along, 0.0), 1.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    cascade.Center[axis] =
      (1.0 - along) * outlines[0].Middle[axis] + along * outlines[1].Middle[axis];
  }
  cascade.Radius = 0.0;
  for (const Outline& outline : outlines)
  {
    for (const auto& corner : outline.Corners)
    {
      cascade.Radius = std::max(cascade.Radius, Distance(corner, cascade.Center));
    }
  }
}

// Where a point's cell may be hidden: behind the nearest caster, 0 <= d + 1, and as far beside what the map
// shows as a cell's image or a filter reaches there, -c (d + 1) - h <= s, t <= 1 + c (d + 1) + h.
vtkShadowFrustumClip::Region FindRegion(const vtkShadowCascades::LightPoint& point)
{
  const std::array<double, 16> m = point.Map.WorldToMap();
  vtkShadowFrustumClip::Region region;
  const std::array<double, 4> behind{ { m[8] + m[12], m[9] + m[13], m[10] + m[14],
    m[11] + m[15] } };
  region.push_back(behind);
  for (int row = 0; row < 2; ++row)
  {
    std::array<double, 4> low;
    std::array<double, 4> high;
    for (int i = 0; i < 4; ++i)
    {
      const double beside = point.CellScale[row] * behind[i] + point.Border * m[12 + i];
      low[i] = m[4 * row + i] + beside;
      high[i] = m[12 + i] - m[4 * row + i] + beside;
    }
    region.push_back(low);
    region.push_back(high);
  }
  return region;
}

// The diagonal of the box around all bodies.
double FindSize(const std::vector<vtkShadowCasters::Body>& bodies)
{
  double squares = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    double low = bodies.front().Bounds[2 * axis];
    double high = bodies.front().Bounds[2 * axis + 1];
    for (const vtkShadowCasters::Body& body : bodies)
    {
      low = std::min(low, body.Bounds[2 * axis]);
      high = std::max(high, body.Bounds[2 * axis + 1]);
    }
    squares += (high - low) * (high - low);
  }
  return squares > 0.0 ? std::sqrt(squares) : 1.0;
}

// The box around all bodies that receive, a bit larger: what is drawn are floats.
std::array<double, 6> FindReceivers(const std::vector<vtkShadowCasters::Body>& bodies)
{
  const double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 6> box = { { infinity, -infinity, infinity, -infinity, infinity, -infinity } };
  for (const vtkShadowCasters::Body& body : bodies)
  {
    for (int i = 0; body.Receives && i < 6; i += 2)
    {
      box[i] = std::min(box[i], body.Bounds[i]);
      box[i + 1] = std::max(box[i + 1], body.Bounds[i + 1]);
    }
  }
  const double margin = DepthTolerance * FindSize(bodies);
  for (int i = 0; i < 6; i += 2)
  {
    box[i] -= margin;
    box[i + 1] += margin;
  }
  return box;
}

// Half the width of the band around each inner split; 0 at the ends.
std::vector<double> FindHalfBands(const std::vector<double>& splits, double band)
{
  std::vector<double> halves(splits.size(), 0.0);
  for (size_t i = 1; i + 1 < splits.size(); ++i)
  {
    const double shorter = std::min(splits[i] - splits[i - 1], splits[i + 1] - splits[i]);
    halves[i] = std::max(0.5 * band * shorter, NarrowestBand * std::abs(splits[i]));
  }
  return halves;
}

} // namespace

//------------------------------------------------------------------------------
vtkShadowCascades::View vtkShadowCascades::View::Of(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  View view;
  std::copy_n(
    camera->GetCompositeProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0)
      ->GetData(),
    16, view.WorldToClip.begin());
  const double* worldToView = camera->GetModelViewTransformMatrix()->GetData();
  for (int i = 0; i < 4; ++i)
  {
    view.WorldToDepth[i] = -worldToView[8 + i];
  }
  view.Parallel = camera->GetParallelProjection() != 0;
  return view;
}

//------------------------------------------------------------------------------
std::vector<double> vtkShadowCascades::Split(
  double nearest, double farthest, int count, double lambda)
{
  std::vector<double> splits;
  for (int i = 0; i <= count; ++i)
  {
    const double share = static_cast<double>(i) / count;
    const double uniform = nearest + (farthest - nearest) * share;
    const double logarithmic =
      lambda > 0.0 ? nearest * std::pow(farthest / nearest, share) : uniform;
    splits.push_back(lambda * logarithmic + (1.0 - lambda) * uniform);
  }
  splits.front() = nearest;
  splits.back() = farthest;
  return splits;
}

//------------------------------------------------------------------------------
std::vector<Interval> vtkShadowCascades::FindDepths(
  const std::vector<vtkShadowCasters::Body>& bodies, const View& view)
{
  vtkShadowFrustumClip frustum(view.WorldToClip, view.WorldToDepth);
  std::vector<vtkShadowFrustumClip::Region> regions;
  std::transform(view.Points.begin(), view.Points.end(), std::back_inserter(regions), FindRegion);
  frustum.SetRegions(regions);
  std::vector<Interval> depths;
  for (const vtkShadowCasters::Body& body : bodies)
  {
    Interval interval;
    if (body.Receives && frustum.FindDepths(body, interval))
    {
      depths.emplace_back(interval.first - DepthTolerance * std::abs(interval.first),
        interval.second + DepthTolerance * std::abs(interval.second));
    }
  }
  return depths;
}

//------------------------------------------------------------------------------
Interval vtkShadowCascades::Round(const std::vector<Interval>& depths, bool parallel, double unit)
{
  Interval range = depths.front();
  for (const Interval& interval : depths)
  {
    range.first = std::min(range.first, interval.first);
    range.second = std::max(range.second, interval.second);
  }
  if (parallel || range.first <= 0.0)
  {
    const double length =
      std::max(range.second - range.first, DepthTolerance * std::abs(range.second));
    const double step =
      length > 0.0 ? std::exp2(std::floor(std::log2(length / ParallelSteps))) : 1.0;
    return { step * std::floor(range.first / step), step * std::ceil(range.second / step) };
  }
  const auto steps = [unit](double depth) { return DepthStepsPerOctave * std::log2(depth / unit); };
  return { unit * std::exp2(std::floor(steps(range.first)) / DepthStepsPerOctave),
    unit * std::exp2(std::ceil(steps(range.second)) / DepthStepsPerOctave) };
}

//------------------------------------------------------------------------------
std::vector<Cascade> vtkShadowCascades::Find(const std::vector<vtkShadowCasters::Body>& bodies,
  const View& view, int count, double lambda, double band)
{
  const vtkShadowFrustumClip frustum(view.WorldToClip, view.WorldToDepth);
  const std::vector<Interval> depths = vtkShadowCascades::FindDepths(bodies, view);
  std::vector<Cascade> cascades;
  if (depths.empty())
  {
    Cascade whole;
    whole.Covered = frustum.GetDepths();
    View everywhere = view;
    everywhere.Points.clear();
    // Bodies may know less than what is drawn: without any in view, all of it counts.
    whole.Occupied =
      view.Points.empty() || vtkShadowCascades::FindDepths(bodies, everywhere).empty();
    cascades.push_back(whole);
  }
  else
  {
    const Interval range = vtkShadowCascades::Round(depths, view.Parallel, FindSize(bodies));
    const bool uniform = view.Parallel || range.first <= 0.0;
    const std::vector<double> splits =
      vtkShadowCascades::Split(range.first, range.second, count, uniform ? 0.0 : lambda);
    const std::vector<double> halves = FindHalfBands(splits, band);
    for (int i = 0; i < count; ++i)
    {
      Cascade cascade;
      cascade.Covered = { splits[i] - halves[i], splits[i + 1] + halves[i + 1] };
      const auto isInside = [&cascade](const Interval& interval)
      { return Overlap(interval, cascade.Covered); };
      if (std::any_of(depths.begin(), depths.end(), isInside))
      {
        cascades.push_back(cascade);
      }
    }
  }
  // Neighbours overlap by their band; where a part between them is empty they fade across it.
  cascades.front().FadeIn = { -2.0 * FarAway, -FarAway };
  cascades.back().FadeOut = { FarAway, 2.0 * FarAway };
  for (size_t i = 1; i < cascades.size(); ++i)
  {
    const Interval band2 = std::minmax(cascades[i - 1].Covered.second, cascades[i].Covered.first);
    cascades[i - 1].FadeOut = cascades[i].FadeIn = band2;
  }
  const std::array<double, 6> receivers = FindReceivers(bodies);
  for (Cascade& cascade : cascades)
  {
    FitSphere(frustum, cascade);
    if (!depths.empty())
    {
      cascade.Corners = frustum.FindCorners(cascade.Covered, receivers);
    }
  }
  return cascades;
}

//------------------------------------------------------------------------------
void vtkShadowCascades::Join(Cascade& cascade, const Cascade& next)
{
  cascade.Covered.second = std::max(cascade.Covered.second, next.Covered.second);
  cascade.FadeOut = next.FadeOut;
  cascade.Radius = std::max(cascade.Radius, Distance(cascade.Center, next.Center) + next.Radius);
  if (cascade.Corners.empty() || next.Corners.empty())
  {
    cascade.Corners.clear();
  }
  else
  {
    cascade.Corners.insert(cascade.Corners.end(), next.Corners.begin(), next.Corners.end());
  }
}

//------------------------------------------------------------------------------
double vtkShadowCascades::Weight(const Cascade& cascade, double depth)
{
  const auto smooth = [depth](const Interval& band)
  {
    const double x =
      std::min(std::max((depth - band.first) / (band.second - band.first), 0.0), 1.0);
    return x * x * (3.0 - 2.0 * x);
  };
  return smooth(cascade.FadeIn) * (1.0 - smooth(cascade.FadeOut));
}
VTK_ABI_NAMESPACE_END
