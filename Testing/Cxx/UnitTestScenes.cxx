// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// A scene's closed form against rays from its receiving plane to its light, past its blockers: the
// formula, the light's parameters and the blockers must tell the same story.
#include "Scenes.h"

#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace SoftShadowsTesting;

namespace
{

const int GridSize = 100;

//------------------------------------------------------------------------------
/// A point of the light, or one far away in its direction; false where a disk has none.
bool PointOfLight(const Scene& scene, double u, double v, const Point& receiver, Point& point)
{
  vtkAreaLight* light = scene.Light;
  double axes[3][3];
  vtkAreaLight::GetTransformedAxes(light, axes[0], axes[1], axes[2]);
  const bool positional = light->GetPositional() != 0;
  const bool disk = !positional || light->GetShape() == vtkAreaLight::DISK;
  if (disk && u * u + v * v > 1.0)
  {
    return false;
  }
  if (positional)
  {
    double center[3];
    light->GetTransformedPosition(center);
    for (int c = 0; c < 3; ++c)
    {
      point[c] = center[c] + 0.5 * u * light->GetSize()[0] * axes[0][c] +
        0.5 * v * light->GetSize()[1] * axes[1][c];
    }
    return true;
  }
  const double half = 0.5 * vtkMath::RadiansFromDegrees(light->GetAngularDiameter());
  const double cosine = 1.0 - (u * u + v * v) * (1.0 - std::cos(half));
  const double sine = std::sqrt(1.0 - cosine * cosine);
  const double phi = std::atan2(v, u);
  const double far = 100.0 * scene.Where.Scale;
  for (int c = 0; c < 3; ++c)
  {
    point[c] = receiver[c] +
      far *
        (sine * (std::cos(phi) * axes[0][c] + std::sin(phi) * axes[1][c]) - cosine * axes[2][c]);
  }
  return true;
}

//------------------------------------------------------------------------------
double TraceVisibility(const Scene& scene, const Point& receiver)
{
  double sum = 0.0;
  double total = 0.0;
  for (int j = 0; j < GridSize; ++j)
  {
    for (int i = 0; i < GridSize; ++i)
    {
      const double u = (2.0 * i + 1.0) / GridSize - 1.0;
      const double v = (2.0 * j + 1.0) / GridSize - 1.0;
      Point point;
      if (!PointOfLight(scene, u, v, receiver, point))
      {
        continue;
      }
      const double weight =
        scene.LightWeights == Weights::Gaussian ? std::exp(-2.0 * (u * u + v * v)) : 1.0;
      bool visible = true;
      for (const Quad& blocker : scene.Blockers)
      {
        visible =
          visible && !blocker.Blocks(scene.Where.ToLocal(receiver), scene.Where.ToLocal(point));
      }
      total += weight;
      sum += visible ? weight : 0.0;
    }
  }
  return sum / total;
}

//------------------------------------------------------------------------------
void ExpectConsistent(const Scene& scene)
{
  const std::vector<PlanePixel> pixels = GetPlanePixels(scene, 64, 48);
  ASSERT_GT(pixels.size(), 64u * 48u / 4u) << scene.Description;
  int penumbra = 0;
  int umbra = 0;
  int lit = 0;
  for (std::size_t i = 0; i < pixels.size(); i += 7)
  {
    const PlanePixel& pixel = pixels[i];
    EXPECT_NEAR(TraceVisibility(scene, pixel.World), pixel.Expected, 0.02)
      << scene.Description << ", pixel " << pixel.X << ' ' << pixel.Y << ", local "
      << testing::PrintToString(scene.Where.ToLocal(pixel.World));
    penumbra += pixel.Expected > 0.0 && pixel.Expected < 1.0 ? 1 : 0;
    umbra += pixel.Expected == 0.0 ? 1 : 0;
    lit += pixel.Expected == 1.0 ? 1 : 0;
  }
  EXPECT_GT(penumbra, 20) << scene.Description;
  EXPECT_GT(umbra, 5) << scene.Description;
  EXPECT_GT(lit, 5) << scene.Description;
}

}

//------------------------------------------------------------------------------
TEST(Scenes, ClosedFormsEqualRays)
{
  for (const NamedScene& scene : ClosedFormScenes())
  {
    SCOPED_TRACE(scene.Name);
    ExpectConsistent(scene.Make(Placement()));
  }
  ExpectConsistent(MakeRectangleScene(Weights::Gaussian));
}

//------------------------------------------------------------------------------
TEST(Scenes, PlacementChangesNoExpectation)
{
  for (const NamedScene& scene : ClosedFormScenes())
  {
    SCOPED_TRACE(scene.Name);
    const Picture first = ExpectedPicture(scene.Make(Placement()), 32, 24);
    const Placement moved{ 1000.0, { { 5e4, -3e4, 2e4 } } };
    ExpectConsistent(scene.Make(moved));
    const Picture second = ExpectedPicture(scene.Make(moved), 32, 24);
    int compared = 0;
    for (std::size_t i = 0; i < first.Values.size(); ++i)
    {
      // A pixel at the region's border may lie in one and not in the other.
      if (!std::isnan(first.Values[i]) && !std::isnan(second.Values[i]))
      {
        EXPECT_NEAR(first.Values[i], second.Values[i], 1e-5);
        ++compared;
      }
    }
    EXPECT_GT(compared, 200);
  }
}
