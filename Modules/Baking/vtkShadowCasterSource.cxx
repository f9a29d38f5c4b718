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
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProperty.h"
#include "vtkShadowCasterSignature.h"
#include "vtkShadowImposters.h"
#include "vtkShadowStrokes.h"
#include "vtkSkybox.h"
#include "vtkTexture.h"
#include "vtkVolume.h"

#if __has_include("vtkCompositePolyDataMapper2.h")
#include "vtkCompositePolyDataMapper2.h"
#define SOFTSHADOWS_HAS_COMPOSITE_MAPPER_2
#endif
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <cstring>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
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
    "vtkDataSetMapper", "vtkSurfaceLICMapper" };
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
  LeafCollector(vtkCompositeDataDisplayAttributes* attributes, std::vector<vtkPolyData*>& pieces)
    : Attributes(attributes)
    , Pieces(pieces)
  {
  }

  bool OnlyPolyData = true;
  bool OnlyPolygons = true;
  vtkShadowCasterSignature Signature; // of all that is visible

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
    this->Signature.AddData(piece);
    this->Pieces.push_back(piece);
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
      this->OnlyPolyData = false; // a tree or a grid this class does not know
      this->OnlyPolygons = false;
      this->Signature.AddData(data);
    }
  }

  vtkCompositeDataDisplayAttributes* Attributes;
  std::vector<vtkPolyData*>& Pieces;
};

// Imposters are larger than the points they stand for; VTK's bounds are the points', if even that.
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
    const char* sizes = vtkShadowStickImposters::Sizes(stick);
    const char* axes = vtkShadowStickImposters::Axes(stick);
    return GetStickReach(
      sizes ? points->GetArray(sizes) : nullptr, axes ? points->GetArray(axes) : nullptr);
  }
  const char* name = vtkShadowSphereImposters::Radii(sphere);
  vtkDataArray* radii = name ? points->GetArray(name) : nullptr;
  return radii ? GetLargest(radii, 0) : sphere->GetRadius();
}
}

//------------------------------------------------------------------------------
void vtkShadowCasterSource::Inspect(vtkProp3D* prop)
{
  this->Route = NONE;
  this->Pieces.clear();
  this->IsHull = false;
  this->IsKnown = false;
  this->HasStrokes = false;
  this->Signature = 0;
  this->Look = 0;

  const vtkMTimeType redraw = prop->GetRedrawMTime(); // brings the pipeline up to date
  if (vtkSkybox::SafeDownCast(prop) || vtkVolume::SafeDownCast(prop))
  {
    return;
  }
  if (auto* actor = vtkActor::SafeDownCast(prop))
  {
    this->InspectActor(actor);
    return;
  }
  vtkShadowCasterSignature signature;
  signature.Add(static_cast<std::uint64_t>(redraw));
  this->AddParts(prop, signature);
  this->Route = prop->HasOpaqueGeometry() ? MAPPER : NONE;
  this->Signature = signature.Value;
  this->Look = signature.Value;
}

//------------------------------------------------------------------------------
// Props that draw actors of their own, as one of several levels of detail, do not tell of their changes.
void vtkShadowCasterSource::AddParts(vtkProp3D* prop, vtkShadowCasterSignature& signature)
{
  this->Actors->RemoveAllItems();
  prop->GetActors(this->Actors);
  vtkCollectionSimpleIterator iterator;
  this->Actors->InitTraversal(iterator);
  while (vtkProp* part = this->Actors->GetNextProp(iterator))
  {
    auto* actor = vtkActor::SafeDownCast(part);
    if (actor && actor->GetMapper())
    {
      signature.Add(static_cast<std::uint64_t>(actor->GetVisibility()));
      signature.AddActor(actor, actor->GetMapper());
      signature.AddInputs(actor->GetMapper(), 0);
    }
  }
  this->Actors->RemoveAllItems(); // holds nothing alive
}

//------------------------------------------------------------------------------
void vtkShadowCasterSource::InspectActor(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
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
  LeafCollector collector(GetAttributes(mapper), this->Pieces);
  collector.Add(mapper->GetInputDataObject(0, 0), true);
  const bool known =
    DrawsPolygonsAsTheyAre(mapper) && collector.OnlyPolyData && !HasReplacedShader(actor);
  this->IsKnown = known;
  const bool whole = known && mapper->GetNumberOfClippingPlanes() == 0 && !HasAlpha(actor);
  const bool surface = property->GetRepresentation() == VTK_SURFACE;
  this->HasStrokes = whole && vtkShadowStrokes::AreWide(this->Pieces, property);
  this->IsHull = surface &&
    (this->HasStrokes || (known && collector.OnlyPolygons && !property->GetVertexVisibility()));
  const bool plain = this->HasStrokes || (this->IsHull && whole);
  this->Route = plain ? BUFFER : MAPPER;

  vtkShadowCasterSignature look = collector.Signature;
  look.Add(static_cast<std::uint64_t>(this->Route));
  this->Signature = look.Value;
  look.AddActor(actor, mapper);
  this->Look = look.Value;
  if (!plain || this->HasStrokes)
  {
    this->Signature = look.Value;
  }
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
