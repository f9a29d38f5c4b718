// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedSurface.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkShadowCasterGeometry.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

int Wrap(int texel, int size, bool repeats)
{
  return repeats ? ((texel % size) + size) % size : std::min(std::max(texel, 0), size - 1);
}

} // namespace

//------------------------------------------------------------------------------
std::unique_ptr<const vtkTracedSurface> vtkTracedSurface::Of(
  vtkActor* actor, const vtkShadowCasterGeometry& triangles)
{
  auto surface = std::make_unique<vtkTracedSurface>();
  if (vtkPlaneCollection* planes = actor->GetMapper()->GetClippingPlanes())
  {
    vtkCollectionSimpleIterator iterator;
    planes->InitTraversal(iterator);
    while (auto* plane = vtkPlane::SafeDownCast(planes->GetNextItemAsObject(iterator)))
    {
      const double* n = plane->GetNormal();
      const double* o = plane->GetOrigin();
      surface->Planes.push_back(
        { { n[0], n[1], n[2], -(n[0] * o[0] + n[1] * o[1] + n[2] * o[2]) } });
    }
  }
  const auto& textures = actor->GetProperty()->GetAllTextures();
  const auto albedo = textures.find("albedoTex");
  const bool has = surface->TakeTexture(actor->GetTexture(), triangles) ||
    (albedo != textures.end() && surface->TakeTexture(albedo->second, triangles));
  return has || !surface->Planes.empty() ? std::move(surface) : nullptr;
}

//------------------------------------------------------------------------------
bool vtkTracedSurface::TakeTexture(vtkTexture* texture, const vtkShadowCasterGeometry& triangles)
{
  vtkImageData* image = texture ? texture->GetInput() : nullptr;
  vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!scalars || scalars->GetNumberOfComponents() % 2 != 0)
  {
    return false;
  }
  const int* size = image->GetDimensions();
  this->Width = size[0];
  this->Height = size[1];
  const int alpha = scalars->GetNumberOfComponents() - 1;
  this->Alphas.resize(static_cast<std::size_t>(scalars->GetNumberOfTuples()));
  for (std::size_t i = 0; i < this->Alphas.size(); ++i)
  {
    this->Alphas[i] = static_cast<float>(scalars->GetComponent(static_cast<vtkIdType>(i), alpha));
  }
  this->Repeats = texture->GetRepeat() != 0;
  this->Interpolates = texture->GetInterpolate() != 0;
  this->Coordinates = triangles.GatherTextureCoordinates();
  return this->Width > 0 && this->Height > 0;
}

//------------------------------------------------------------------------------
float vtkTracedSurface::GetAlpha(int column, int row) const
{
  return this
    ->Alphas[static_cast<std::size_t>(Wrap(row, this->Height, this->Repeats)) * this->Width +
      Wrap(column, this->Width, this->Repeats)];
}

//------------------------------------------------------------------------------
// VTK's mapper draws no fragment without any alpha. Between texels it is interpolated: then there is some
// where any of the four neighbours has some.
bool vtkTracedSurface::HasAlpha(double s, double t) const
{
  const double x = s * this->Width;
  const double y = t * this->Height;
  if (!std::isfinite(x + y))
  {
    return true;
  }
  if (!this->Interpolates)
  {
    return this->GetAlpha(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y))) > 0.0f;
  }
  const int column = static_cast<int>(std::floor(x - 0.5));
  const int row = static_cast<int>(std::floor(y - 0.5));
  return this->GetAlpha(column, row) > 0.0f || this->GetAlpha(column + 1, row) > 0.0f ||
    this->GetAlpha(column, row + 1) > 0.0f || this->GetAlpha(column + 1, row + 1) > 0.0f;
}

//------------------------------------------------------------------------------
bool vtkTracedSurface::IsThere(
  const vtkTracedVector& world, const std::uint32_t* vertices, double u, double v) const
{
  const bool cut = std::any_of(this->Planes.begin(), this->Planes.end(),
    [&world](const std::array<double, 4>& p)
    { return p[0] * world[0] + p[1] * world[1] + p[2] * world[2] + p[3] < 0.0; });
  if (cut)
  {
    return false;
  }
  if (this->Alphas.empty())
  {
    return true;
  }
  const double weights[3] = { 1.0 - u - v, u, v };
  double place[2] = { 0.0, 0.0 };
  for (int corner = 0; corner < 3; ++corner)
  {
    for (int k = 0; k < 2; ++k)
    {
      place[k] +=
        weights[corner] * this->Coordinates[2 * static_cast<std::size_t>(vertices[corner]) + k];
    }
  }
  return this->HasAlpha(place[0], place[1]);
}
VTK_ABI_NAMESPACE_END
