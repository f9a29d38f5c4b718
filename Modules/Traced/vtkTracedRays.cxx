// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedRays.h"

#include "vtkTracedLight.h"
#include "vtkTracedScene.h"

#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr float Infinity = std::numeric_limits<float>::infinity();
// What lies in the light's own surface does not block it.
constexpr float BeforeLight = 1.0f - 1e-5f;
}

//------------------------------------------------------------------------------
vtkTracedRays::vtkTracedRays(const vtkTracedScene& scene, const vtkTracedLight& light,
  const vtkTracedVector& eye, std::vector<vtkTracedPixel>& pixels)
  : Scene(scene)
  , Light(light)
  , Pixels(pixels)
{
  this->Hits.Scene = &scene;
  this->Hits.Eye = eye;
  for (int i = 0; i < vtkTracedHits::Width; ++i)
  {
    this->Rays.tnear[i] = 0.0f;
    this->Rays.time[i] = 0.0f;
    this->Rays.mask[i] = ~0u;
    this->Rays.id[i] = static_cast<unsigned int>(i);
    this->Rays.flags[i] = 0;
  }
}

//------------------------------------------------------------------------------
void vtkTracedRays::Add(
  std::size_t pixel, int x, int y, const vtkTracedReceivers::Point& receiver, int first, int last)
{
  const vtkTracedVector start = receiver.GetStart();
  const vtkTracedLight::Point* points = this->Light.GetPoints(x, y);
  vtkTracedPixel& sums = this->Pixels[pixel];
  for (int i = first; i < last; ++i)
  {
    const vtkTracedVector way =
      this->Light.IsDirectional() ? points[i].Place : points[i].Place - start;
    sums.All += static_cast<float>(points[i].Weight);
    if (!(vtkTraced::Dot(way, receiver.Normal) > 0.0))
    {
      // Behind the side that the camera sees the surface itself is in the way.
      sums.IsAtHorizon = true;
    }
    else if (this->IsFree)
    {
      sums.Lit += static_cast<float>(points[i].Weight);
    }
    else
    {
      this->Push(pixel, receiver, start, way, points[i].Weight);
    }
  }
}

//------------------------------------------------------------------------------
void vtkTracedRays::Push(std::size_t pixel, const vtkTracedReceivers::Point& receiver,
  const vtkTracedVector& start, const vtkTracedVector& way, double weight)
{
  const int i = this->Waiting++;
  this->Rays.org_x[i] = static_cast<float>(start[0]);
  this->Rays.org_y[i] = static_cast<float>(start[1]);
  this->Rays.org_z[i] = static_cast<float>(start[2]);
  this->Rays.dir_x[i] = static_cast<float>(way[0]);
  this->Rays.dir_y[i] = static_cast<float>(way[1]);
  this->Rays.dir_z[i] = static_cast<float>(way[2]);
  this->Rays.tfar[i] = this->Light.IsDirectional() ? Infinity : BeforeLight;
  this->Hits.Receivers[i] = receiver.Place;
  this->Hits.Tolerances[i] = receiver.Precision;
  this->PixelOfRay[i] = pixel;
  this->Weights[i] = static_cast<float>(weight);
  if (this->Waiting == vtkTracedHits::Width)
  {
    this->Flush();
  }
}

//------------------------------------------------------------------------------
void vtkTracedRays::Flush()
{
  if (this->Waiting == 0)
  {
    return;
  }
  alignas(32) int valid[vtkTracedHits::Width];
  for (int i = 0; i < vtkTracedHits::Width; ++i)
  {
    valid[i] = i < this->Waiting ? -1 : 0;
  }
  vtkTracedInit(this->Hits.Context);
  vtkTracedOccluded8(valid, this->Scene.GetHandle(), this->Hits.Context, this->Rays);
  for (int i = 0; i < this->Waiting; ++i)
  {
    vtkTracedPixel& sums = this->Pixels[this->PixelOfRay[i]];
    if (this->Rays.tfar[i] >= 0.0f)
    {
      sums.Lit += this->Weights[i];
    }
    else
    {
      const float way = this->Hits.Distances[i];
      sums.Spread += this->Light.IsDirectional() ? way : way / (1.0f - way);
      sums.Hits += 1.0f;
    }
  }
  this->Shot += this->Waiting;
  this->Waiting = 0;
}
VTK_ABI_NAMESPACE_END
