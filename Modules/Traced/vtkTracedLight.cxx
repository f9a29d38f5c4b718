// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedLight.h"

#include "vtkMath.h"
#include "vtkShadowLightSampling.h"
#include "vtkTracedScene.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

constexpr double InDoubt = 1e-5; // what single precision leaves of a border

// Which run of the sequence a pixel has: the four pixels of every 2 x 2 have four of the first, second,
// third and fourth quarter, and so have the four that lie two apart.
int RunOfPixel(int x, int y)
{
  const int fine = (x & 1) ^ (y & 1) ? 1 : 0;
  const int coarse = ((x >> 1) ^ (y >> 1)) & 1;
  return 8 * fine + 4 * (y & 1) + 2 * coarse + ((y >> 1) & 1);
}

} // namespace

//------------------------------------------------------------------------------
vtkTracedLight::vtkTracedLight(const vtkShadowEmitter& emitter, int faceAxis, int weights, int rays,
  int mostRays, const vtkTracedScene& scene)
  : Emitter(emitter)
  , Apex(scene.ToLocal(emitter.Apex))
  , FaceAxis(faceAxis)
  , Rays(emitter.HasExtent() ? rays : 1)
  , MostRays(emitter.HasExtent() ? std::max(rays, mostRays) : 1)
  , CosineOfCone(std::cos(vtkMath::RadiansFromDegrees(emitter.ConeAngle)))
{
  this->Emitter.Center = scene.ToLocal(emitter.Center);
  if (!emitter.Directional)
  {
    this->Emitter.HalfSize[0] *= scene.GetScale();
    this->Emitter.HalfSize[1] *= scene.GetScale();
  }
  constexpr int runs = Block * Block;
  this->Points.reserve(static_cast<std::size_t>(runs) * this->MostRays);
  for (int pixel = 0; pixel < runs; ++pixel)
  {
    const int run = RunOfPixel(pixel % Block, pixel / Block);
    for (int i = 0; i < this->MostRays; ++i)
    {
      // The first rays of all pixels are the sequence's first points, their next ones the next.
      const int index = (i / this->Rays * runs + run) * this->Rays + i % this->Rays;
      this->Points.push_back(this->FindPoint(static_cast<unsigned int>(index), weights));
      this->Bounds.Add(this->Points.back().Place);
    }
  }
}

//------------------------------------------------------------------------------
vtkTracedLight::Point vtkTracedLight::FindPoint(unsigned int index, int weights) const
{
  const vtkShadowLightSampling::Sample sample =
    vtkShadowLightSampling::PointOfSequence(this->Emitter, index, weights);
  const vtkShadowEmitter at = this->Emitter.PointAt(sample.U, sample.V, sample.Weight);
  if (this->Emitter.Directional)
  {
    return { -1.0 * at.Direction, sample.Weight };
  }
  return { at.Center, sample.Weight };
}

//------------------------------------------------------------------------------
float vtkTracedLight::GetSize() const
{
  return static_cast<float>(2.0 * std::min(this->Emitter.HalfSize[0], this->Emitter.HalfSize[1]));
}

//------------------------------------------------------------------------------
void vtkTracedLight::End(vtkTracedShaft& shaft, const vtkTracedScene& scene) const
{
  if (this->Emitter.Directional)
  {
    shaft.EndAlong(this->Bounds, scene.GetReach() + shaft.GetReach());
  }
  else
  {
    shaft.EndAt(this->Bounds);
  }
}

//------------------------------------------------------------------------------
bool vtkTracedLight::Reaches(const vtkTracedVector& point) const
{
  if (this->Emitter.Directional)
  {
    return true;
  }
  const vtkTracedVector p = point - this->Apex;
  const double length = vtkTraced::Length(p);
  const double doubt = InDoubt * length;
  const double z = vtkTraced::Dot(p, this->Emitter.Direction);
  if (this->FaceAxis >= 0)
  {
    return z + doubt >= std::abs(vtkTraced::Dot(p, this->Emitter.AxisU)) &&
      z + doubt >= std::abs(vtkTraced::Dot(p, this->Emitter.AxisV));
  }
  if (this->Emitter.HasExtent() && z <= -doubt)
  {
    return false;
  }
  return !this->Emitter.HasCone() || z >= this->CosineOfCone * length - doubt;
}
VTK_ABI_NAMESPACE_END
