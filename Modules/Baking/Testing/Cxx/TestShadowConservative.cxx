// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Conservative rasterisation: every texel touched, no depth too great.
#include "BakingScene.h"

#include "vtkCellArray.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using Point = std::array<double, 3>;
using Polygon = std::vector<Point>;
constexpr int RESOLUTION = 32;

vtkShadowMapView MakeView(bool directional)
{
  vtkShadowMapView view;
  view.Emitter = MakeDownwardEmitter(0.0, 0.0, 5.0, directional);
  const double unit = directional ? 5.0 : 1.0;
  view.Window = { { -0.4 * unit, 0.4 * unit, -0.4 * unit, 0.4 * unit } };
  view.Near = 2.0;
  view.Far = 8.0;
  return view;
}

Point ToMap(const vtkShadowMapView& view, const Point& p)
{
  const auto m = view.WorldToMap();
  double h[4];
  for (int i = 0; i < 4; ++i)
  {
    h[i] = m[4 * i] * p[0] + m[4 * i + 1] * p[1] + m[4 * i + 2] * p[2] + m[4 * i + 3];
  }
  return { { h[0] / h[3], h[1] / h[3], h[2] / h[3] + 1.0 } }; // as BakingScene::BakeDepths has it
}

// The part of a polygon where sign * (p[axis] - bound) >= 0.
Polygon Cut(const Polygon& polygon, int axis, double sign, double bound)
{
  Polygon kept;
  for (size_t i = 0; i < polygon.size(); ++i)
  {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    const double da = sign * (a[axis] - bound);
    const double db = sign * (b[axis] - bound);
    if (da >= 0.0)
    {
      kept.push_back(a);
    }
    if ((da >= 0.0) != (db >= 0.0))
    {
      const double t = da / (da - db);
      kept.push_back(
        { { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]) } });
    }
  }
  return kept;
}

// What of the triangle lies in the texel (i, j) grown by so much of its edge.
Polygon InTexel(const Polygon& triangle, int i, int j, double grown)
{
  const double texel = 1.0 / RESOLUTION;
  Polygon part = Cut(triangle, 0, 1.0, (i - grown) * texel);
  part = part.empty() ? part : Cut(part, 0, -1.0, (i + 1 + grown) * texel);
  part = part.empty() ? part : Cut(part, 1, 1.0, (j - grown) * texel);
  return part.empty() ? part : Cut(part, 1, -1.0, (j + 1 + grown) * texel);
}

double LeastDepth(const Polygon& polygon)
{
  double least = 2.0;
  for (const Point& p : polygon)
  {
    least = std::min(least, p[2]);
  }
  return least;
}

void SetTriangle(BakingScene& scene, vtkPolyData* data, const Polygon& triangle)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& p : triangle)
  {
    points->InsertNextPoint(p.data());
  }
  data->SetPoints(points);
  scene.Casters->Update(scene.Renderer);
}
}

//------------------------------------------------------------------------------
TEST(ShadowConservative, CoversWhatATriangleTouchesAndNoDepthIsTooGreat)
{
  BakingScene scene;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2 });
  data->SetPolys(cells);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(data);
  scene.AddActor(producer);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(7);
  const auto next = [&random](double low, double high)
  {
    random->Next();
    return random->GetRangeValue(low, high);
  };
  int touched = 0;
  int spared = 0;
  for (int round = 0; round < 40; ++round)
  {
    const vtkShadowMapView view = MakeView(round % 2 == 0);
    const double size = round < 20 ? 2.0 : 0.2; // many texels, about one texel
    const Point middle{ { next(-1.0, 1.0), next(-1.0, 1.0), next(-1.0, 1.0) } };
    Polygon triangle;
    for (int i = 0; i < 3; ++i)
    {
      triangle.push_back({ { middle[0] + next(-size, size), middle[1] + next(-size, size),
        middle[2] + next(-size, size) } });
    }
    SetTriangle(scene, data, triangle);
    const auto depths = scene.BakeDepths(view, RESOLUTION, true);
    Polygon mapped;
    for (const Point& p : triangle)
    {
      mapped.push_back(ToMap(view, p));
    }
    for (int j = 0; j < RESOLUTION; ++j)
    {
      for (int i = 0; i < RESOLUTION; ++i)
      {
        const double depth = depths[static_cast<size_t>(j) * RESOLUTION + i];
        const Polygon inside = InTexel(mapped, i, j, -1e-3);
        if (!inside.empty())
        {
          ++touched;
          ASSERT_LE(depth, LeastDepth(inside) + 1e-6) << round << ": " << i << ", " << j;
          ASSERT_GE(depth, LeastDepth(mapped) - 1e-6) << round << ": " << i << ", " << j;
        }
        else if (InTexel(mapped, i, j, 1e-2).empty())
        {
          ++spared;
          ASSERT_EQ(depth, 1.0) << round << ": " << i << ", " << j << " is not touched";
        }
      }
    }
  }
  EXPECT_GT(touched, 1000);
  EXPECT_GT(spared, 10000);
}

//------------------------------------------------------------------------------
TEST(ShadowConservative, AThinBarIsNeverLost)
{
  BakingScene scene;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2, 3 });
  data->SetPolys(cells);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(data);
  scene.AddActor(producer);
  const vtkShadowMapView view = MakeView(true);
  const double texel = (view.Window[1] - view.Window[0]) / RESOLUTION;
  int lost = 0;
  for (int step = 0; step < 10; ++step)
  {
    const double x = 0.1 * step * texel;
    const double width = 0.4 * texel;
    SetTriangle(scene, data,
      { { { x, -1, 0 } }, { { x + width, -1, 0 } }, { { x + width, 1, 0 } }, { { x, 1, 0 } } });
    for (const bool conservative : { false, true })
    {
      const auto depths = scene.BakeDepths(view, RESOLUTION, conservative);
      const auto row = depths.begin() + RESOLUTION / 2 * RESOLUTION;
      const bool found = std::any_of(row, row + RESOLUTION, [](float d) { return d < 1.0f; });
      EXPECT_TRUE(found || !conservative) << step;
      lost += found ? 0 : 1;
    }
  }
  EXPECT_GT(lost, 0) << "without, it is lost at some places: the test can fail";
}

//------------------------------------------------------------------------------
TEST(ShadowConservative, TrianglesThatReachBehindTheLightAreCut)
{
  BakingScene scene;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2 });
  data->SetPolys(cells);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(data);
  scene.AddActor(producer);
  // A tall wall x = 0.8 from below to far above the light at z = 5.
  SetTriangle(scene, data, { { { 0.8, -30, -3 } }, { { 0.8, 30, -3 } }, { { 0.8, 0, 30 } } });
  const auto normal = scene.BakeDepths(MakeView(false), RESOLUTION, false);
  const auto conservative = scene.BakeDepths(MakeView(false), RESOLUTION, true);
  int covered = 0;
  for (size_t i = 0; i < normal.size(); ++i)
  {
    ASSERT_LE(conservative[i], normal[i] + 1e-6) << i;
    covered += normal[i] < 1.0f ? 1 : 0;
  }
  EXPECT_GT(covered, RESOLUTION * RESOLUTION / 8);
}
