// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedGlyphs.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkShadowCasterGeometry.h"
#include "vtkTracedDevice.h"
#include "vtkTracedMesh.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

// VTK's mapper tells of its arrays only to itself.
struct GlyphAccess : public vtkGlyph3DMapper
{
  static vtkDataArray* Orientations(vtkGlyph3DMapper* mapper, vtkDataSet* data)
  {
    return (mapper->*(&GlyphAccess::GetOrientationArray))(data);
  }
  static vtkDataArray* Scales(vtkGlyph3DMapper* mapper, vtkDataSet* data)
  {
    return (mapper->*(&GlyphAccess::GetScaleArray))(data);
  }
  static vtkDataArray* Masks(vtkGlyph3DMapper* mapper, vtkDataSet* data)
  {
    return (mapper->*(&GlyphAccess::GetMaskArray))(data);
  }
  static vtkDataArray* Indices(vtkGlyph3DMapper* mapper, vtkDataSet* data)
  {
    return (mapper->*(&GlyphAccess::GetSourceIndexArray))(data);
  }
};

double LengthOf(vtkDataArray* values, vtkIdType tuple)
{
  double squares = 0.0;
  for (int k = 0; k < values->GetNumberOfComponents(); ++k)
  {
    squares += values->GetComponent(tuple, k) * values->GetComponent(tuple, k);
  }
  return std::sqrt(squares);
}

// The arrays of a mapper, and what it makes of them: as vtkOpenGLGlyph3DMapper does.
class Placer
{
public:
  Placer(vtkGlyph3DMapper* mapper, vtkDataSet* data)
    : Mapper(mapper)
    , Data(data)
    , Orientations(mapper->GetOrient() ? GlyphAccess::Orientations(mapper, data) : nullptr)
    , Scales(mapper->GetScaling() ? GlyphAccess::Scales(mapper, data) : nullptr)
    , Masks(mapper->GetMasking() ? GlyphAccess::Masks(mapper, data) : nullptr)
    , Indices(mapper->GetSourceIndexing() ? GlyphAccess::Indices(mapper, data) : nullptr)
  {
  }

  bool IsShown(vtkIdType point) const
  {
    return !this->Masks || this->Masks->GetComponent(point, 0) != 0.0;
  }

  int GetSource(vtkIdType point, int count) const
  {
    if (!this->Indices)
    {
      return 0;
    }
    const double index = LengthOf(this->Indices, point);
    return static_cast<int>(std::min(std::max(index, 0.0), count - 1.0));
  }

  vtkTracedMap GetMap(vtkIdType point)
  {
    double place[3];
    this->Data->GetPoint(point, place);
    this->Transform->Identity();
    this->Transform->Translate(place);
    this->Orient(point);
    if (this->Mapper->GetScaling())
    {
      std::array<double, 3> scales = this->GetScales(point);
      for (double& scale : scales)
      {
        scale = scale == 0.0 ? 1e-10 : scale;
      }
      this->Transform->Scale(scales.data());
    }
    std::array<double, 16> matrix;
    std::copy_n(this->Transform->GetMatrix()->GetData(), 16, matrix.begin());
    return vtkTraced::MapOf(matrix);
  }

private:
  std::array<double, 3> GetScales(vtkIdType point) const
  {
    std::array<double, 3> scales{ { 1.0, 1.0, 1.0 } };
    if (this->Scales && this->Mapper->GetScaleMode() == vtkGlyph3DMapper::SCALE_BY_MAGNITUDE)
    {
      scales.fill(LengthOf(this->Scales, point));
    }
    else if (this->Scales && this->Mapper->GetScaleMode() == vtkGlyph3DMapper::SCALE_BY_COMPONENTS)
    {
      for (int k = 0; k < std::min(3, this->Scales->GetNumberOfComponents()); ++k)
      {
        scales[k] = this->Scales->GetComponent(point, k);
      }
    }
    const double* range = this->Mapper->GetRange();
    const double width = range[1] - range[0] == 0.0 ? 1.0 : range[1] - range[0];
    for (double& scale : scales)
    {
      if (this->Mapper->GetClamping() && this->Scales &&
        this->Mapper->GetScaleMode() != vtkGlyph3DMapper::NO_DATA_SCALING)
      {
        scale = (std::min(std::max(scale, range[0]), range[1]) - range[0]) / width;
      }
      scale *= this->Mapper->GetScaleFactor();
    }
    return scales;
  }

  void Orient(vtkIdType point)
  {
    if (!this->Orientations)
    {
      return;
    }
    double o[4] = { 0.0, 0.0, 0.0, 0.0 };
    for (int k = 0; k < std::min(4, this->Orientations->GetNumberOfComponents()); ++k)
    {
      o[k] = this->Orientations->GetComponent(point, k);
    }
    switch (this->Mapper->GetOrientationMode())
    {
      case vtkGlyph3DMapper::ROTATION:
        this->Transform->RotateZ(o[2]);
        this->Transform->RotateX(o[0]);
        this->Transform->RotateY(o[1]);
        break;
      case vtkGlyph3DMapper::DIRECTION:
        if (o[1] == 0.0 && o[2] == 0.0)
        {
          if (o[0] < 0.0)
          {
            this->Transform->RotateY(180.0);
          }
        }
        else
        {
          const double length = vtkMath::Norm(o);
          this->Transform->RotateWXYZ(180.0, 0.5 * (o[0] + length), 0.5 * o[1], 0.5 * o[2]);
        }
        break;
      case vtkGlyph3DMapper::QUATERNION:
      {
        const double sine = std::sqrt(o[1] * o[1] + o[2] * o[2] + o[3] * o[3]);
        this->Transform->RotateWXYZ(
          vtkMath::DegreesFromRadians(2.0 * std::atan2(sine, o[0])), o[1], o[2], o[3]);
        break;
      }
      default:
        break;
    }
  }

  vtkGlyph3DMapper* Mapper;
  vtkDataSet* Data;
  vtkDataArray* Orientations;
  vtkDataArray* Scales;
  vtkDataArray* Masks;
  vtkDataArray* Indices;
  vtkNew<vtkTransform> Transform;
};

} // namespace

//------------------------------------------------------------------------------
bool vtkTracedGlyphs::Find(vtkGlyph3DMapper* mapper, const std::shared_ptr<vtkTracedDevice>& device,
  std::vector<std::shared_ptr<vtkTracedMesh>>& sources, std::vector<vtkTracedPlacement>& glyphs)
{
  auto* data = vtkDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0));
  const int count = mapper->GetNumberOfInputConnections(1);
  if (!data || count == 0 || mapper->GetUseSourceTableTree())
  {
    return false;
  }
  std::vector<std::shared_ptr<vtkTracedMesh>> meshes;
  for (int i = 0; i < count; ++i)
  {
    auto* source = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(1, i));
    if (!source || source->GetNumberOfVerts() > 0 || source->GetNumberOfLines() > 0)
    {
      return false;
    }
    vtkShadowCasterGeometry triangles;
    triangles.Build({ source });
    meshes.push_back(std::make_shared<vtkTracedMesh>(device));
    meshes.back()->Take(triangles, nullptr);
  }
  Placer placer(mapper, data);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    if (placer.IsShown(i))
    {
      glyphs.push_back(
        { meshes[static_cast<std::size_t>(placer.GetSource(i, count))], placer.GetMap(i) });
    }
  }
  sources = std::move(meshes);
  return true;
}
VTK_ABI_NAMESPACE_END
