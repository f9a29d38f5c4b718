// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

// vtkCompositePolyDataMapper2 is deprecated from VTK 9.3 on, but applications may still have it.
#define VTK_DEPRECATION_LEVEL 0

#include "vtkShadowCasterSource.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkDataSetMapper.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProperty.h"
#include "vtkSkybox.h"
#include "vtkTexture.h"
#include "vtkVolume.h"

#if __has_include("vtkCompositePolyDataMapper2.h")
#include "vtkCompositePolyDataMapper2.h"
#define SOFTSHADOWS_HAS_COMPOSITE_MAPPER_2
#endif
#include "vtkOpenGLSphereMapper.h"
#include "vtkOpenGLStickMapper.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <cstring>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
void Mix(std::uint64_t& signature, std::uint64_t value)
{
  // Finaliser of SplitMix64: every bit of the value reaches every bit of the sum.
  value += 0x9e3779b97f4a7c15ULL + signature;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
  signature = value ^ (value >> 31);
}

void Mix(std::uint64_t& signature, vtkObject* object)
{
  Mix(signature, static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(object)));
  Mix(signature, object ? static_cast<std::uint64_t>(object->GetMTime()) : 0);
}

// Up to VTK 9.2 the composite mapper of RenderingCore has no attributes of blocks.
template <typename Mapper>
auto AttributesOf(Mapper* mapper, int) -> decltype(mapper->GetCompositeDataDisplayAttributes())
{
  return mapper->GetCompositeDataDisplayAttributes();
}

template <typename Mapper>
vtkCompositeDataDisplayAttributes* AttributesOf(Mapper*, long)
{
  return nullptr;
}

vtkCompositeDataDisplayAttributes* GetAttributes(vtkMapper* mapper)
{
#ifdef SOFTSHADOWS_HAS_COMPOSITE_MAPPER_2
  if (auto* second = vtkCompositePolyDataMapper2::SafeDownCast(mapper))
  {
    return AttributesOf(second, 0);
  }
#endif
  auto* composite = vtkCompositePolyDataMapper::SafeDownCast(mapper);
  return composite ? AttributesOf(composite, 0) : nullptr;
}

// By name, not by type: a subclass may draw anything.
bool DrawsPolygonsAsTheyAre(vtkMapper* mapper)
{
  static const char* const names[] = { "vtkOpenGLPolyDataMapper", "vtkCompositePolyDataMapper2",
    "vtkCompositePolyDataMapper", "vtkOpenGLLowMemoryPolyDataMapper", "vtkPolyDataMapper",
    "vtkDataSetMapper" };
  const char* name = mapper->GetClassName();
  return std::any_of(std::begin(names), std::end(names),
    [name](const char* known) { return std::strcmp(name, known) == 0; });
}

bool HasAlpha(vtkTexture* texture)
{
  if (!texture)
  {
    return false;
  }
  vtkImageData* image = texture->GetInput();
  vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!scalars)
  {
    return true; // a cube map, a texture object: only the mapper knows
  }
  vtkScalarsToColors* table = texture->GetLookupTable();
  const bool mapped = texture->GetColorMode() == VTK_COLOR_MODE_MAP_SCALARS ||
    scalars->GetDataType() != VTK_UNSIGNED_CHAR;
  return scalars->GetNumberOfComponents() % 2 == 0 || (mapped && table && !table->IsOpaque());
}

bool HasAlpha(vtkActor* actor)
{
  if (HasAlpha(actor->GetTexture()))
  {
    return true;
  }
  const auto& textures = actor->GetProperty()->GetAllTextures();
  const auto albedo = textures.find("albedoTex");
  return albedo != textures.end() && HasAlpha(albedo->second);
}

bool HasReplacedShader(vtkActor* actor)
{
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  return shaders->GetNumberOfShaderReplacements() > 0 || shaders->HasVertexShaderCode() ||
    shaders->HasFragmentShaderCode() || shaders->HasGeometryShaderCode();
}

// Gathers the visible polygonal leaves of a data set the way the composite mapper draws them: what a
// block says of itself holds for its children until they say otherwise.
class LeafCollector
{
public:
  LeafCollector(vtkCompositeDataDisplayAttributes* attributes, vtkShadowCasterSource& source)
    : Attributes(attributes)
    , Source(source)
  {
  }

  bool OnlyPolygons = true;

  void Add(vtkDataObject* data, bool visible)
  {
    if (!data)
    {
      return;
    }
    if (this->Attributes && this->Attributes->HasBlockVisibility(data))
    {
      visible = this->Attributes->GetBlockVisibility(data);
    }
    if (this->Attributes && this->Attributes->HasBlockOpacity(data))
    {
      visible = visible && this->Attributes->GetBlockOpacity(data) >= 1.0;
    }
    if (auto* piece = vtkPolyData::SafeDownCast(data))
    {
      this->AddPiece(piece, visible);
    }
    else
    {
      this->AddChildren(data, visible);
    }
  }

private:
  void AddPiece(vtkPolyData* piece, bool visible)
  {
    if (!visible)
    {
      return;
    }
    Mix(this->Source.Signature, piece);
    this->Source.Pieces.push_back(piece);
    this->OnlyPolygons =
      this->OnlyPolygons && piece->GetNumberOfVerts() == 0 && piece->GetNumberOfLines() == 0;
  }

  void AddChildren(vtkDataObject* data, bool visible)
  {
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
    {
      for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
      {
        this->Add(blocks->GetBlock(i), visible);
      }
    }
    else if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
    {
      for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
      {
        this->Add(collection->GetPartitionedDataSet(i), visible);
      }
    }
    else if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(data))
    {
      for (unsigned int i = 0; i < partitions->GetNumberOfPartitions(); ++i)
      {
        this->Add(partitions->GetPartitionAsDataObject(i), visible);
      }
    }
    else
    {
      this->OnlyPolygons = false; // a tree or a grid this class does not know
      Mix(this->Source.Signature, data);
    }
  }

  vtkCompositeDataDisplayAttributes* Attributes;
  vtkShadowCasterSource& Source;
};

// Imposters are larger than the points they stand for; VTK's bounds are the points', if even that.
struct SphereAccess : public vtkOpenGLSphereMapper
{
  static const char* Scales(vtkOpenGLSphereMapper* mapper)
  {
    return mapper->*(&SphereAccess::ScaleArray);
  }
};

struct StickAccess : public vtkOpenGLStickMapper
{
  static const char* Scales(vtkOpenGLStickMapper* mapper)
  {
    return mapper->*(&StickAccess::ScaleArray);
  }
  static const char* Axes(vtkOpenGLStickMapper* mapper)
  {
    return mapper->*(&StickAccess::OrientationArray);
  }
};

double GetLargest(vtkDataArray* values, int component) // -1: the tuples' length
{
  double range[2];
  values->GetRange(range, component);
  return std::max(std::abs(range[0]), std::abs(range[1]));
}

// From a stick's middle to the rim of its ends: sizes are length and radius, axes of any length.
double GetStickReach(vtkDataArray* sizes, vtkDataArray* axes)
{
  if (!sizes || sizes->GetNumberOfComponents() < 2)
  {
    return 1.0;
  }
  const double stretch = axes ? GetLargest(axes, -1) : 1.0;
  return std::hypot(0.5 * stretch * GetLargest(sizes, 0), GetLargest(sizes, 1));
}

// The largest reach of an imposter around its point, 0 for mappers that draw no imposters.
double GetImposterReach(vtkMapper* mapper, vtkPolyData* data)
{
  auto* sphere = vtkOpenGLSphereMapper::SafeDownCast(mapper);
  auto* stick = vtkOpenGLStickMapper::SafeDownCast(mapper);
  if (!sphere && !stick)
  {
    return 0.0;
  }
  vtkPointData* points = data->GetPointData();
  if (stick)
  {
    const char* sizes = StickAccess::Scales(stick);
    const char* axes = StickAccess::Axes(stick);
    return GetStickReach(
      sizes ? points->GetArray(sizes) : nullptr, axes ? points->GetArray(axes) : nullptr);
  }
  const char* name = SphereAccess::Scales(sphere);
  vtkDataArray* radii = name ? points->GetArray(name) : nullptr;
  return radii ? GetLargest(radii, 0) : sphere->GetRadius();
}

void MixLook(std::uint64_t& signature, vtkActor* actor)
{
  Mix(signature, actor->GetMapper());
  Mix(signature, actor->GetProperty());
  Mix(signature, actor->GetTexture());
  Mix(signature, actor->GetShaderProperty());
  Mix(signature, static_cast<std::uint64_t>(actor->GetShaderProperty()->GetShaderMTime()));
}
}

//------------------------------------------------------------------------------
void vtkShadowCasterSource::Inspect(vtkProp3D* prop)
{
  this->Route = NONE;
  this->Pieces.clear();
  this->IsHull = false;
  this->Signature = 0;

  const vtkMTimeType redraw = prop->GetRedrawMTime(); // brings the pipeline up to date
  if (vtkSkybox::SafeDownCast(prop) || vtkVolume::SafeDownCast(prop))
  {
    return;
  }
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  if (!actor)
  {
    this->Route = prop->HasOpaqueGeometry() ? MAPPER : NONE;
    this->Signature = redraw;
    return;
  }
  if (!mapper || mapper->GetNumberOfInputPorts() == 0 ||
    mapper->GetNumberOfInputConnections(0) == 0)
  {
    return;
  }
  // GetRedrawMTime leaves out composite data sets.
  mapper->GetInputAlgorithm()->Update();
  if (!actor->HasOpaqueGeometry())
  {
    return;
  }

  vtkProperty* property = actor->GetProperty();
  vtkCompositeDataDisplayAttributes* attributes = GetAttributes(mapper);
  LeafCollector collector(attributes, *this);
  collector.Add(mapper->GetInputDataObject(0, 0), true);
  const bool known = DrawsPolygonsAsTheyAre(mapper) && collector.OnlyPolygons;
  const bool replaced = HasReplacedShader(actor);
  this->IsHull = known && !replaced && property->GetRepresentation() == VTK_SURFACE &&
    !property->GetVertexVisibility();
  const bool plain = this->IsHull && mapper->GetNumberOfClippingPlanes() == 0 && !HasAlpha(actor);
  this->Route = plain ? BUFFER : MAPPER;
  if (!plain)
  {
    MixLook(this->Signature, actor);
    for (int port = 1; port < mapper->GetNumberOfInputPorts(); ++port)
    {
      for (int i = 0; i < mapper->GetNumberOfInputConnections(port); ++i)
      {
        Mix(this->Signature, mapper->GetInputDataObject(port, i)); // the shapes of glyphs
      }
    }
  }
  Mix(this->Signature, static_cast<std::uint64_t>(this->Route));
}

//------------------------------------------------------------------------------
bool vtkShadowCasterSource::GetModelBounds(vtkProp3D* prop, double bounds[6])
{
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  if (!mapper)
  {
    return false;
  }
  auto* data = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  const double reach = data ? GetImposterReach(mapper, data) : 0.0;
  if (reach > 0.0 && data->GetPoints())
  {
    data->GetPoints()->GetBounds(bounds);
    for (int i = 0; i < 6; ++i)
    {
      bounds[i] += i % 2 == 0 ? -reach : reach;
    }
  }
  else
  {
    const double* found = mapper->GetBounds();
    if (!found)
    {
      return false;
    }
    std::copy_n(found, 6, bounds);
  }
  return vtkMath::AreBoundsInitialized(bounds) &&
    std::all_of(bounds, bounds + 6, [](double b) { return std::isfinite(b); });
}

VTK_ABI_NAMESPACE_END
