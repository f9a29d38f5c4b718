// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowLightFit.h"

#include "vtkShadowMapFitter.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkSoftShadowLightFit::Fit(const vtkShadowEmitter& emitter, const vtkShadowMapFitter& fitter,
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
std::vector<vtkShadowMapView> vtkSoftShadowLightFit::GetFaceViews() const
{
  std::vector<vtkShadowMapView> views;
  for (const Face& face : this->Faces)
  {
    if (face.HasCasters)
    {
      views.push_back(face.View);
    }
  }
  return views;
}

//------------------------------------------------------------------------------
size_t vtkSoftShadowLightFit::GetNumberOfParts() const
{
  size_t parts = 0;
  for (const Face& face : this->Faces)
  {
    parts += std::count_if(
      face.Parts.begin(), face.Parts.end(), [](const Part& part) { return part.HasCasters; });
  }
  return parts;
}

//------------------------------------------------------------------------------
std::vector<vtkShadowMapView> vtkSoftShadowLightFit::GetBatch(
  size_t face, size_t part, size_t count, size_t& layer) const
{
  // Parts are numbered over all faces; a batch is count of them in a row.
  std::vector<vtkShadowMapView> views;
  size_t wanted = 0;
  for (size_t f = 0; f < this->Faces.size(); ++f)
  {
    for (size_t p = 0; p < this->Faces[f].Parts.size(); ++p)
    {
      const Part& candidate = this->Faces[f].Parts[p];
      wanted = f == face && p == part ? views.size() : wanted;
      if (candidate.HasCasters)
      {
        views.push_back(candidate.View);
      }
    }
  }
  const size_t first = wanted / count * count;
  const size_t last = std::min(first + count, views.size());
  layer = wanted - first;
  return { views.begin() + first, views.begin() + last };
}
VTK_ABI_NAMESPACE_END
