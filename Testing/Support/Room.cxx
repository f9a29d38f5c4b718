// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Room.h"

#include "Scenes.h"
#include "WorldPositions.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <cmath>

namespace SoftShadowsTesting
{
namespace
{
void AddQuad(vtkRenderer* renderer, const Point& origin, const Point& edge1, const Point& edge2)
{
  renderer->AddActor(MakeQuadActor({ { origin, edge1, edge2 } }));
}

}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderer> MakeRoom(double lampSize)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  AddQuad(renderer, { { -4, -4, 0 } }, { { 8, 0, 0 } }, { { 0, 5, 0 } });
  AddQuad(renderer, { { -4, 1, 0 } }, { { 8, 0, 0 } }, { { 0, 0, 4 } });
  AddQuad(renderer, { { -1, -1.5, 0.8 } }, { { 2, 0, 0 } }, { { 0, 2, 0 } });
  vtkNew<vtkAreaLight> lamp;
  lamp->SetConeAngle(30.0);
  lamp->SetPosition(0.2, -1.0, 6.0);
  lamp->SetFocalPoint(0.2, -1.0, 0.0);
  lamp->SetShapeToRectangle();
  lamp->SetSize(lampSize, lampSize);
  renderer->AddLight(lamp);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(1.0, -7.0, 3.5);
  camera->SetFocalPoint(0.0, 0.0, 0.4);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
  return renderer;
}

//------------------------------------------------------------------------------
std::vector<int> RoomSurfaces(vtkRenderer* renderer, const Picture& depth)
{
  const Plane planes[] = { { { { 0, 0, 0 } }, { { 0, 0, 1 } } },
    { { { 0, 1, 0 } }, { { 0, 1, 0 } } }, { { { 0, 0, 0.8 } }, { { 0, 0, 1 } } } };
  double position[3];
  double direction[3];
  renderer->GetActiveCamera()->GetPosition(position);
  renderer->GetActiveCamera()->GetDirectionOfProjection(direction);
  std::vector<int> surfaces(depth.Values.size(), -1);
  for (int plane = 0; plane < 3; ++plane)
  {
    const std::vector<Point> points =
      PlanePositions(renderer, depth.Width, depth.Height, planes[plane]);
    for (size_t i = 0; i < points.size(); ++i)
    {
      double along = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        along += (points[i][k] - position[k]) * direction[k];
      }
      if (std::abs(along - depth.Values[i]) < 1e-3)
      {
        surfaces[i] = plane;
      }
    }
  }
  return surfaces;
}

}
