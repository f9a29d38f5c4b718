// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Where depth maps go wrong first: a surface that shadows itself, and a shadow that does not touch
// what throws it.
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"
#include "WorldPositions.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace SoftShadowsTesting;

namespace
{

const int Width = 120;
const int Height = 90;
const double OneByte = 1.0 / 255.0;

class Surface : public testing::TestWithParam<Technique>
{
protected:
  vtkSmartPointer<vtkSoftShadowPass> MakePass() const
  {
    return this->GetParam().Make(Effort::Quick, Weights::Mean);
  }
};

//------------------------------------------------------------------------------
/// Towards a light that stands so many degrees off the plane's normal.
Point DirectionAt(double degreesOffNormal)
{
  const double angle = vtkMath::RadiansFromDegrees(degreesOffNormal);
  return { { 0.8 * std::sin(angle), 0.6 * std::sin(angle), std::cos(angle) } };
}

//------------------------------------------------------------------------------
/// A ground that is baked: the quad below it, which nothing sees, makes its actor no flat body.
vtkSmartPointer<vtkActor> MakeCastingGround(double halfSize)
{
  const double h = halfSize;
  return MakeQuadActor(
    { { { { -h, -h, 0.0 } }, { { 2.0 * h, 0.0, 0.0 } }, { { 0.0, 2.0 * h, 0.0 } } },
      { { { -0.1, -0.1, -0.5 } }, { { 0.2, 0.0, 0.0 } }, { { 0.0, 0.2, 0.0 } } } });
}

//------------------------------------------------------------------------------
void ExpectLit(const Picture& visibility, const std::string& where)
{
  int wrong = 0;
  for (int y = 0; y < visibility.Height; ++y)
  {
    for (int x = 0; x < visibility.Width; ++x)
    {
      const float v = visibility.At(x, y);
      if (!(v >= 1.0 - OneByte && v <= 1.0 + 1e-6) && ++wrong == 1)
      {
        ADD_FAILURE() << where << ": pixel (" << x << ", " << y << ") has visibility " << v;
      }
    }
  }
  EXPECT_EQ(wrong, 0) << where << ": of " << visibility.Values.size() << " pixels";
}

//------------------------------------------------------------------------------
bool Hides(const std::vector<Quad>& quads, const Point& from, const Point& to)
{
  for (const Quad& quad : quads)
  {
    if (quad.Blocks(from, to))
    {
      return true;
    }
  }
  return false;
}

}

//------------------------------------------------------------------------------
TEST_P(Surface, PlaneDoesNotShadowItself)
{
  for (const double degrees : { 0.0, 45.0, 75.0, 85.0, 89.0 })
  {
    for (const bool directional : { true, false })
    {
      const auto renderer = MakeRenderer({ { 1.0, -3.0, 2.0 } }, { { 0.0, 0.0, 0.0 } }, 25.0);
      renderer->AddActor(MakeCastingGround(3.0));
      Point position = DirectionAt(degrees);
      for (double& c : position)
      {
        c *= 6.0;
      }
      const auto light =
        directional ? MakeSun(position, 0.53) : MakeLamp(position, { { 0.0, 0.0, 0.0 } }, 0.1);
      renderer->AddLight(light);
      renderer->ResetCameraClippingRange();
      const auto pass = this->MakePass();
      Stage stage(renderer, pass, Width, Height);
      const Picture visibility = stage.RenderVisibility(light);
      EXPECT_TRUE(!this->GetParam().HasMaps || pass->GetStatistics().MapsBaked > 0)
        << "the ground must be in the map";
      ExpectLit(
        visibility, std::to_string(degrees) + " degrees, " + (directional ? "sun" : "lamp"));
    }
  }
}

//------------------------------------------------------------------------------
// A convex body of triangles: a triangle that faces the whole light is lit, whatever is beside it.
TEST_P(Surface, SphereDoesNotShadowItself)
{
  const auto renderer = MakeRenderer({ { 1.0, -4.0, 2.0 } }, { { 0.0, 0.0, 0.0 } }, 22.0);
  renderer->AddActor(MakeSphereActor({ { 0.0, 0.0, 0.0 } }, 0.7, 40));
  renderer->AddActor(MakeGroundActor(4.0, -2.0)); // without a receiver nothing casts
  Point toSun = { { 0.6, -0.5, 0.6 } };
  vtkMath::Normalize(toSun.data());
  const auto sun = MakeSun(toSun, 3.0);
  renderer->AddLight(sun);
  renderer->ResetCameraClippingRange();
  const auto pass = this->MakePass();
  Stage stage(renderer, pass, Width, Height);
  const Picture visibility = stage.RenderVisibility(sun);
  EXPECT_TRUE(!this->GetParam().HasMaps || pass->GetStatistics().MapsBaked > 0);
  int tested = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      SightLine line = SightLineOf(renderer, Width, Height, x, y);
      vtkMath::Normalize(line.Direction.data());
      // A sphere a little smaller than the facets' own: its silhouette is inside theirs.
      const double along = -vtkMath::Dot(line.Start.data(), line.Direction.data());
      const double square = vtkMath::Dot(line.Start.data(), line.Start.data()) - along * along;
      const double radius = 0.69;
      if (square >= radius * radius)
      {
        continue;
      }
      const double t = along - std::sqrt(radius * radius - square);
      double cosine = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        cosine += (line.Start[c] + t * line.Direction[c]) / radius * toSun[c];
      }
      // Facets lean at most 4.5 degrees from the sphere, the sun's rim is at 1.5 degrees.
      if (cosine > std::sin(vtkMath::RadiansFromDegrees(8.0)))
      {
        ++tested;
        EXPECT_GE(visibility.At(x, y), 1.0 - OneByte)
          << "pixel " << x << ' ' << y << ", cosine to the sun " << cosine;
      }
    }
  }
  EXPECT_GT(tested, 500);
}

namespace
{

//------------------------------------------------------------------------------
struct Contact
{
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkAreaLight> Light;
  std::vector<Quad> Box;
};

//------------------------------------------------------------------------------
Contact MakeContact()
{
  Contact contact;
  contact.Box = BoxQuads({ { -0.5, 0.5, -0.5, 0.5, 0.0, 1.0 } });
  contact.Renderer = MakeRenderer({ { 3.0, -1.5, 2.5 } }, { { 0.5, 0.0, 0.1 } }, 22.0);
  contact.Renderer->AddActor(MakeGroundActor(6.0));
  contact.Renderer->AddActor(MakeQuadActor(contact.Box));
  contact.Light = MakeLamp({ { -2.5, 0.4, 3.0 } }, { { 0.0, 0.0, 0.3 } }, 0.2);
  contact.Renderer->AddLight(contact.Light);
  contact.Renderer->ResetCameraClippingRange();
  return contact;
}

//------------------------------------------------------------------------------
/// Ground pixels behind the box as the light sees it: dark from the second pixel on.
void ExpectNoGap(const Contact& contact, const Picture& visibility)
{
  const std::vector<Point> positions = PlanePositions(contact.Renderer, Width, Height, Plane());
  const Point eye = SightLineOf(contact.Renderer, Width, Height, 0, 0).Start;
  int tested = 0;
  for (int y = 1; y < Height; ++y)
  {
    for (int x = 1; x < Width; ++x)
    {
      const Point& p = positions[y * Width + x];
      const Point& beside = positions[y * Width + x - 1];
      const Point& below = positions[(y - 1) * Width + x];
      const double footprint = std::max(std::abs(p[0] - beside[0]), std::abs(p[0] - below[0]));
      const double gap = p[0] - 0.5;
      if (gap > footprint && gap < 0.3 && std::abs(p[1]) < 0.35 && !Hides(contact.Box, eye, p))
      {
        ++tested;
        EXPECT_LE(visibility.At(x, y), OneByte)
          << "pixel " << x << ' ' << y << ", " << gap << " from the box, pixel size " << footprint;
      }
    }
  }
  EXPECT_GT(tested, 100);
}

}

//------------------------------------------------------------------------------
TEST_P(Surface, ShadowTouchesTheBox)
{
  const Contact contact = MakeContact();
  Stage stage(contact.Renderer, this->MakePass(), Width, Height);
  ExpectNoGap(contact, stage.RenderVisibility(contact.Light));
}

//------------------------------------------------------------------------------
// A deep scene: the map's depths reach a thousand times as far as the contact.
TEST_P(Surface, ShadowTouchesTheBoxInADeepScene)
{
  const Contact contact = MakeContact();
  contact.Renderer->AddActor(
    MakeBoxActor({ { 1499.0, 1501.0, -241.0, -239.0, -1900.0, -1700.0 } }));
  contact.Renderer->AddActor(MakeQuadActor(
    { { { { -1e4, -1e4, -2000.0 } }, { { 2e4, 0.0, 0.0 } }, { { 0.0, 2e4, 0.0 } } } }));
  // The camera is not what is tested: far as the scene reaches, it looks at what is near.
  contact.Renderer->GetActiveCamera()->SetClippingRange(1.0, 20.0);
  // Depths are what is tested: over so wide a ground texels of 512 are 0.1 wide, and an edge is blurred
  // by one.
  const auto pass = this->MakePass();
  pass->SetMapSize(1024);
  Stage stage(contact.Renderer, pass, Width, Height);
  ExpectNoGap(contact, stage.RenderVisibility(contact.Light));
}

//------------------------------------------------------------------------------
// The ground before the box, as the light sees it, is lit up to the box.
TEST_P(Surface, LightTouchesTheBox)
{
  const Contact contact = MakeContact();
  const auto seen = MakeRenderer({ { -3.0, -1.5, 2.5 } }, { { -0.5, 0.0, 0.1 } }, 22.0);
  seen->AddActor(MakeGroundActor(6.0));
  seen->AddActor(MakeQuadActor(contact.Box));
  seen->AddLight(contact.Light);
  seen->ResetCameraClippingRange();
  Stage stage(seen, this->MakePass(), Width, Height);
  const Picture visibility = stage.RenderVisibility(contact.Light);
  const std::vector<Point> positions = PlanePositions(seen, Width, Height, Plane());
  const Point eye = SightLineOf(seen, Width, Height, 0, 0).Start;
  int tested = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const Point& p = positions[y * Width + x];
      if (p[0] < -0.52 && p[0] > -1.0 && std::abs(p[1]) < 0.35 && !Hides(contact.Box, eye, p))
      {
        ++tested;
        EXPECT_GE(visibility.At(x, y), 1.0 - OneByte)
          << "pixel " << x << ' ' << y << ", " << -0.5 - p[0] << " from the box";
      }
    }
  }
  EXPECT_GT(tested, 100);
}

INSTANTIATE_TEST_SUITE_P(Techniques, Surface, testing::ValuesIn(AllTechniques()), NameOfTechnique);
