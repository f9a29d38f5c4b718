// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace SoftShadowsTesting
{
namespace
{

const double NaN = std::numeric_limits<double>::quiet_NaN();

//------------------------------------------------------------------------------
/// a + t b
Point Along(const Point& a, double t, const Point& b)
{
  return { { a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2] } };
}

//------------------------------------------------------------------------------
Point Unit(Point v)
{
  vtkMath::Normalize(v.data());
  return v;
}

//------------------------------------------------------------------------------
Point Cross(const Point& a, const Point& b)
{
  Point c;
  vtkMath::Cross(a.data(), b.data(), c.data());
  return c;
}

//------------------------------------------------------------------------------
void LookAt(Scene& scene, const Point& target, const Point& from, double distance, double degrees)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetFocalPoint(scene.Where.ToWorld(target).data());
  camera->SetPosition(scene.Where.ToWorld(Along(target, distance, Unit(from))).data());
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(degrees);
  scene.Renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
void PlaceLight(Scene& scene, const Point& position, const Point& focalPoint)
{
  scene.Light->SetLightTypeToSceneLight();
  scene.Light->SetPosition(scene.Where.ToWorld(position).data());
  scene.Light->SetFocalPoint(scene.Where.ToWorld(focalPoint).data());
  scene.Renderer->AutomaticLightCreationOff();
  scene.Renderer->AddLight(scene.Light);
}

//------------------------------------------------------------------------------
/// The receiving plane reaches so far beyond the region that no pixel near it sees its border.
void AddActors(Scene& scene, const Point& middle, double halfSize)
{
  const Quad ground{ { { middle[0] - halfSize, middle[1] - halfSize, 0.0 } },
    { { 2.0 * halfSize, 0.0, 0.0 } }, { { 0.0, 2.0 * halfSize, 0.0 } } };
  scene.ReceiverActor = MakeQuadActor({ ground }, scene.Where);
  scene.Renderer->AddActor(scene.ReceiverActor);
  for (const Quad& blocker : scene.Blockers)
  {
    scene.BlockerActors.push_back(MakeQuadActor({ blocker }, scene.Where));
    scene.Renderer->AddActor(scene.BlockerActors.back());
  }
}

//------------------------------------------------------------------------------
Scene NewScene(const std::string& description, const Placement& placement)
{
  Scene scene;
  scene.Description = description;
  scene.Where = placement;
  scene.Renderer = vtkSmartPointer<vtkRenderer>::New();
  scene.Light = vtkSmartPointer<vtkAreaLight>::New();
  return scene;
}

}

//------------------------------------------------------------------------------
Point Placement::ToWorld(const Point& local) const
{
  return Along(this->Translation, this->Scale, local);
}

//------------------------------------------------------------------------------
Point Placement::ToLocal(const Point& world) const
{
  Point local;
  for (int c = 0; c < 3; ++c)
  {
    local[c] = (world[c] - this->Translation[c]) / this->Scale;
  }
  return local;
}

//------------------------------------------------------------------------------
bool Quad::Blocks(const Point& from, const Point& to) const
{
  const Point normal = Cross(this->Edge1, this->Edge2);
  const Point direction = Along(to, -1.0, from);
  const double slope = vtkMath::Dot(direction.data(), normal.data());
  if (slope == 0.0)
  {
    return false;
  }
  const Point toOrigin = Along(this->Origin, -1.0, from);
  const double t = vtkMath::Dot(toOrigin.data(), normal.data()) / slope;
  if (t < 0.0 || t > 1.0)
  {
    return false;
  }
  const Point hit = Along(Along(from, t, direction), -1.0, this->Origin);
  const double area2 = vtkMath::Dot(normal.data(), normal.data());
  const double a = vtkMath::Dot(Cross(hit, this->Edge2).data(), normal.data()) / area2;
  const double b = vtkMath::Dot(Cross(this->Edge1, hit).data(), normal.data()) / area2;
  return a >= 0.0 && a <= 1.0 && b >= 0.0 && b <= 1.0;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeQuads(const std::vector<Quad>& quads, const Placement& placement)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  for (const Quad& quad : quads)
  {
    const Point far = Along(quad.Origin, 1.0, quad.Edge1);
    const vtkIdType corners[4] = { points->InsertNextPoint(placement.ToWorld(quad.Origin).data()),
      points->InsertNextPoint(placement.ToWorld(far).data()),
      points->InsertNextPoint(placement.ToWorld(Along(far, 1.0, quad.Edge2)).data()),
      points->InsertNextPoint(placement.ToWorld(Along(quad.Origin, 1.0, quad.Edge2)).data()) };
    polygons->InsertNextCell(4, corners);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeQuadActor(const std::vector<Quad>& quads, const Placement& placement)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeQuads(quads, placement));
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.0);
  actor->GetProperty()->SetDiffuse(1.0);
  actor->GetProperty()->SetSpecular(0.0);
  return actor;
}

//------------------------------------------------------------------------------
std::vector<Quad> BoxQuads(const std::array<double, 6>& b)
{
  const Point low = { { b[0], b[2], b[4] } };
  const Point high = { { b[1], b[3], b[5] } };
  std::vector<Quad> quads;
  for (int axis = 0; axis < 3; ++axis)
  {
    // Edges ordered so that the low corner's sides face outwards, and the high corner's as well.
    Point edges[2] = { { { 0.0, 0.0, 0.0 } }, { { 0.0, 0.0, 0.0 } } };
    const int first = (axis + 1) % 3;
    const int second = (axis + 2) % 3;
    edges[0][first] = high[first] - low[first];
    edges[1][second] = high[second] - low[second];
    quads.push_back({ low, edges[1], edges[0] });
    edges[0][first] = -edges[0][first];
    edges[1][second] = -edges[1][second];
    quads.push_back({ high, edges[0], edges[1] });
  }
  return quads;
}

//------------------------------------------------------------------------------
Plane Scene::GetReceiver() const
{
  Plane plane;
  plane.Origin = this->Where.Translation;
  return plane;
}

//------------------------------------------------------------------------------
Scene MakeRectangleScene(Weights weights, const Placement& placement)
{
  Scene scene =
    NewScene("square of 1 at height 1 under a light of 0.7 x 0.5 at height 3", placement);
  scene.LightWeights = weights;
  const Rectangle blocker{ { { -0.5, 0.5 } }, { { -0.5, 0.5 } }, 1.0 };
  const Point lamp = { { 0.3, -0.2, 3.0 } };
  const std::array<double, 2> size = { { 0.7, 0.5 } };
  const Rectangle light{ { { lamp[0] - 0.5 * size[0], lamp[0] + 0.5 * size[0] } },
    { { lamp[1] - 0.5 * size[1], lamp[1] + 0.5 * size[1] } }, lamp[2] };

  scene.Blockers.push_back(
    { { { -0.5, -0.5, 1.0 } }, { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } } });
  scene.Region = { { -1.4, 1.1, -1.1, 1.3 } };
  scene.Visibility = [=](const Point& p)
  { return VisibilityOfRectangle(p, blocker, light, weights); };
  // The edge on the right, away from the corners.
  scene.Across = [](const Point& p)
  { return p[0] > -0.15 && std::abs(p[1] - 0.1) < 0.25 ? p[0] : NaN; };

  scene.Light->SetConeAngle(60.0);
  scene.Light->SetShapeToRectangle();
  scene.Light->SetSize(size[0] * placement.Scale, size[1] * placement.Scale);
  scene.Light->SetViewUp(0.0, 1.0, 0.0);
  PlaceLight(scene, lamp, { { lamp[0], lamp[1], 0.0 } });
  AddActors(scene, { { 0.0, 0.0, 0.0 } }, 8.0);
  LookAt(scene, { { -0.15, 0.1, 0.0 } }, { { 0.1, -1.0, 0.7 } }, 6.0, 21.0);
  return scene;
}

//------------------------------------------------------------------------------
Scene MakeDiskScene(const Placement& placement)
{
  Scene scene =
    NewScene("half plane x <= 0 at height 1 under a disk of radius 0.4 at height 3", placement);
  const Point lamp = { { 0.2, 0.1, 3.0 } };
  const double radius = 0.4;

  // A half plane for every line between the region and the light.
  scene.Blockers.push_back(
    { { { -1.5, -1.5, 1.0 } }, { { 1.5, 0.0, 0.0 } }, { { 0.0, 3.0, 0.0 } } });
  scene.Region = { { -0.6, 0.4, -0.5, 0.5 } };
  scene.Visibility = [=](const Point& p) { return VisibilityOfDisk(p, 0.0, 1.0, lamp, radius); };
  scene.Across = [](const Point& p) { return p[0]; };

  scene.Light->SetShapeToDisk();
  scene.Light->SetSize(2.0 * radius * placement.Scale, 2.0 * radius * placement.Scale);
  PlaceLight(scene, lamp, { { lamp[0], lamp[1], 0.0 } });
  AddActors(scene, { { 0.0, 0.0, 0.0 } }, 8.0);
  LookAt(scene, { { -0.1, 0.0, 0.0 } }, { { 0.6, -0.6, 0.6 } }, 5.0, 12.0);
  return scene;
}

//------------------------------------------------------------------------------
Scene MakeSunScene(double degrees, bool inclined, const Placement& placement)
{
  std::ostringstream description;
  description << "half plane at distance 10 under a sun of " << degrees << " degrees, "
              << (inclined ? "50 degrees above the plane" : "vertically above the plane");
  Scene scene = NewScene(description.str(), placement);

  const double diameter = vtkMath::RadiansFromDegrees(degrees);
  const double distance = 10.0;
  const double width = 2.0 * distance * std::tan(0.5 * diameter); // of the penumbra, across the sun
  const double height = vtkMath::RadiansFromDegrees(50.0);
  const Point toSun = inclined
    ? Point{ { 0.8 * std::cos(height), -0.6 * std::cos(height), std::sin(height) } }
    : Point{ { 0.0, 0.0, 1.0 } };

  // The half plane's edge passes through `edge`, seen from the origin straight before the sun.
  const Point edge = Along({ { 0.0, 0.0, 0.0 } }, distance, toSun);
  const Point alongEdge = Unit(Cross(toSun, { { 1.0, 0.2, 0.0 } }));
  const Point toBlocked = Unit(Cross(toSun, alongEdge));
  const double size = 6.0 * width;
  scene.Blockers.push_back({ Along(edge, -0.5 * size, alongEdge),
    { { size * alongEdge[0], size * alongEdge[1], size * alongEdge[2] } },
    { { 0.5 * size * toBlocked[0], 0.5 * size * toBlocked[1], 0.5 * size * toBlocked[2] } } });
  const double reach = 1.3 * width;
  scene.Region = { { -reach, reach, -reach, reach } };
  scene.Visibility = [=](const Point& p)
  { return VisibilityOfSun(p, edge, alongEdge, toBlocked, toSun, diameter); };
  scene.Across = [=](const Point& p) { return -vtkMath::Dot(p.data(), toBlocked.data()); };

  scene.Light->PositionalOff();
  scene.Light->SetAngularDiameter(degrees);
  PlaceLight(scene, toSun, { { 0.0, 0.0, 0.0 } });
  AddActors(scene, { { 0.0, 0.0, 0.0 } }, 20.0 * width);
  LookAt(scene, { { 0.0, 0.0, 0.0 } }, { { 0.3, 1.0, 1.1 } }, 0.5 * distance,
    vtkMath::DegreesFromRadians(2.0 * std::atan(1.3 * reach / (0.5 * distance))));
  return scene;
}

//------------------------------------------------------------------------------
std::vector<NamedScene> ClosedFormScenes()
{
  return {
    { "Rectangle", [](const Placement& p) { return MakeRectangleScene(Weights::Mean, p); } },
    { "Disk", [](const Placement& p) { return MakeDiskScene(p); } },
    { "Sun053Vertical", [](const Placement& p) { return MakeSunScene(0.53, false, p); } },
    { "Sun053Inclined", [](const Placement& p) { return MakeSunScene(0.53, true, p); } },
    { "Sun5Vertical", [](const Placement& p) { return MakeSunScene(5.0, false, p); } },
    { "Sun5Inclined", [](const Placement& p) { return MakeSunScene(5.0, true, p); } },
  };
}

//------------------------------------------------------------------------------
std::vector<PlanePixel> GetPlanePixels(const Scene& scene, int width, int height)
{
  const std::vector<Point> positions =
    PlanePositions(scene.Renderer, width, height, scene.GetReceiver());
  const Point eye = scene.Where.ToLocal(
    [&]
    {
      Point position;
      scene.Renderer->GetActiveCamera()->GetPosition(position.data());
      return position;
    }());
  std::vector<PlanePixel> pixels;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const Point& world = positions[static_cast<std::size_t>(y) * width + x];
      const Point p = scene.Where.ToLocal(world);
      bool known = p[0] >= scene.Region[0] && p[0] <= scene.Region[1] && p[1] >= scene.Region[2] &&
        p[1] <= scene.Region[3];
      for (const Quad& blocker : scene.Blockers)
      {
        known = known && !blocker.Blocks(eye, p);
      }
      if (known)
      {
        pixels.push_back({ x, y, world, scene.Visibility(p), scene.Across(p) });
      }
    }
  }
  return pixels;
}

//------------------------------------------------------------------------------
Picture ExpectedPicture(const Scene& scene, int width, int height)
{
  Picture picture(width, height, 1, static_cast<float>(NaN));
  for (const PlanePixel& pixel : GetPlanePixels(scene, width, height))
  {
    picture.At(pixel.X, pixel.Y) = static_cast<float>(pixel.Expected);
  }
  return picture;
}

}
