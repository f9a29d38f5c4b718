// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowLightMaps.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowCasters.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowDepthPyramid.h"
#include "vtkShadowMapFitter.h"
#include "vtkShadowTextureArray.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkSoftShadowLightMaps::vtkSoftShadowLightMaps() = default;

//------------------------------------------------------------------------------
vtkSoftShadowLightMaps::~vtkSoftShadowLightMaps() = default;

//------------------------------------------------------------------------------
void vtkSoftShadowLightMaps::Fit(const vtkShadowEmitter& emitter, const vtkShadowMapFitter& fitter,
  vtkMTimeType castersTime, int split, bool gaussian)
{
  if (this->Emitter == emitter && this->CastersTime == castersTime && this->Split == split &&
    this->Gaussian == gaussian && !this->Faces.empty())
  {
    return;
  }
  this->Emitter = emitter;
  this->CastersTime = castersTime;
  this->Split = split;
  this->Gaussian = gaussian;
  this->Faces.clear();
  this->NumberTooNear = 0;
  int layer = 0;
  for (const vtkShadowEmitter& faceEmitter : emitter.Faces())
  {
    Face face;
    face.Emitter = faceEmitter;
    // Faces() goes through the axes two at a time.
    face.Axis = faceEmitter.Face ? static_cast<int>(this->Faces.size() / 2) : -1;
    face.HasCasters = fitter.Fit(faceEmitter, face.View);
    this->NumberTooNear += face.HasCasters ? fitter.CountTooNear(face.View) : 0;
    face.Layer = layer;
    if (face.HasCasters)
    {
      ++layer;
      for (const vtkShadowEmitter& partEmitter : faceEmitter.Split(split, split, gaussian))
      {
        Part part;
        part.Emitter = partEmitter;
        part.HasCasters = fitter.Fit(partEmitter, part.View);
        face.Parts.push_back(part);
      }
    }
    this->Faces.push_back(face);
  }
}

//------------------------------------------------------------------------------
int vtkSoftShadowLightMaps::BakeFaces(
  vtkRenderer* renderer, vtkShadowCasters* casters, int mapSize, bool conservative, bool pyramid)
{
  std::vector<vtkShadowMapView> views;
  for (const Face& face : this->Faces)
  {
    if (face.HasCasters)
    {
      views.push_back(face.View);
    }
  }
  if (views.empty())
  {
    return 0;
  }
  const int baked = this->FaceMaps->Bake(renderer, casters, views, mapSize, conservative);
  if (pyramid && baked >= 0)
  {
    this->FacePyramid->Update(
      static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()), this->FaceMaps);
  }
  return std::max(baked, 0);
}

//------------------------------------------------------------------------------
int vtkSoftShadowLightMaps::BakePart(vtkRenderer* renderer, vtkShadowCasters* casters, size_t face,
  size_t part, int mapSize, bool conservative, size_t count, bool pyramid, int& baked)
{
  // Parts are numbered over all faces; a batch is count of them in a row.
  std::vector<vtkShadowMapView> views;
  size_t index = 0;
  size_t wanted = 0;
  for (size_t f = 0; f < this->Faces.size(); ++f)
  {
    for (size_t p = 0; p < this->Faces[f].Parts.size(); ++p)
    {
      const Part& candidate = this->Faces[f].Parts[p];
      if (!candidate.HasCasters)
      {
        continue;
      }
      if (f == face && p == part)
      {
        wanted = index;
      }
      views.push_back(candidate.View);
      ++index;
    }
  }
  const size_t first = wanted / count * count;
  const size_t last = std::min(first + count, views.size());
  const std::vector<vtkShadowMapView> batch(views.begin() + first, views.begin() + last);
  const int drawn = this->PartMaps->Bake(renderer, casters, batch, mapSize, conservative);
  if (drawn < 0)
  {
    return -1;
  }
  baked += drawn;
  if (pyramid)
  {
    this->PartPyramid->Update(
      static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()), this->PartMaps);
  }
  return static_cast<int>(wanted - first);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkSoftShadowLightMaps::GetBytes()
{
  return this->FaceMaps->GetTexture()->GetBytes() + this->PartMaps->GetTexture()->GetBytes() +
    this->FacePyramid->GetTexture()->GetBytes() + this->PartPyramid->GetTexture()->GetBytes();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkSoftShadowLightMaps::GetNumberOfDrawCalls()
{
  return this->FaceMaps->GetNumberOfDrawCalls() + this->PartMaps->GetNumberOfDrawCalls();
}

//------------------------------------------------------------------------------
void vtkSoftShadowLightMaps::ReleaseGraphicsResources(vtkWindow* window)
{
  this->FaceMaps->ReleaseGraphicsResources(window);
  this->PartMaps->ReleaseGraphicsResources(window);
  this->FacePyramid->ReleaseGraphicsResources(window);
  this->PartPyramid->ReleaseGraphicsResources(window);
}
VTK_ABI_NAMESPACE_END
