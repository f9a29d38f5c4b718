// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCasterSignature.h"

#include "vtkAbstractMapper.h"
#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkUniforms.h"

#include <cstring>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// From VTK 9.6 on: how flat points look and how thick lines join.
template <typename Property>
auto GetNewerState(Property* property, int)
  -> decltype(property->GetPoint2DShape(), property->GetLineJoin(), std::uint64_t())
{
  return 16 * static_cast<std::uint64_t>(property->GetPoint2DShape()) +
    static_cast<std::uint64_t>(property->GetLineJoin());
}

template <typename Property>
std::uint64_t GetNewerState(Property*, long)
{
  return 0;
}
}

//------------------------------------------------------------------------------
void vtkShadowCasterSignature::Add(std::uint64_t value)
{
  // Finaliser of SplitMix64: every bit of the value reaches every bit of the sum.
  value += 0x9e3779b97f4a7c15ULL + this->Value;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
  this->Value = value ^ (value >> 31);
}

//------------------------------------------------------------------------------
void vtkShadowCasterSignature::Add(double value)
{
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  this->Add(bits);
}

//------------------------------------------------------------------------------
void vtkShadowCasterSignature::AddObject(vtkObject* object)
{
  this->Add(static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(object)));
  this->Add(object ? static_cast<std::uint64_t>(object->GetMTime()) : 0);
}

//------------------------------------------------------------------------------
void vtkShadowCasterSignature::AddData(vtkDataObject* data)
{
  this->AddObject(data);
  if (auto* piece = vtkPolyData::SafeDownCast(data))
  {
    for (vtkCellArray* cells :
      { piece->GetVerts(), piece->GetLines(), piece->GetPolys(), piece->GetStrips() })
    {
      this->AddObject(cells);
      this->AddObject(cells->GetOffsetsArray());
      this->AddObject(cells->GetConnectivityArray());
    }
  }
  else if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
    {
      this->AddData(blocks->GetBlock(i));
    }
  }
  else if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
    {
      this->AddData(collection->GetPartitionedDataSet(i));
    }
  }
  else if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(data))
  {
    for (unsigned int i = 0; i < partitions->GetNumberOfPartitions(); ++i)
    {
      this->AddData(partitions->GetPartitionAsDataObject(i));
    }
  }
}

//------------------------------------------------------------------------------
void vtkShadowCasterSignature::AddInputs(vtkAlgorithm* algorithm, int firstPort)
{
  for (int port = firstPort; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      int outputPort = 0;
      if (vtkAlgorithm* input = algorithm->GetInputAlgorithm(port, i, outputPort))
      {
        input->Update(outputPort);
      }
      this->AddData(algorithm->GetInputDataObject(port, i));
    }
  }
}

//------------------------------------------------------------------------------
void vtkShadowCasterSignature::AddClippingPlanes(vtkAbstractMapper* mapper)
{
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  if (!planes)
  {
    return;
  }
  this->AddObject(planes);
  vtkCollectionSimpleIterator iterator;
  planes->InitTraversal(iterator);
  while (vtkObject* plane = planes->GetNextItemAsObject(iterator))
  {
    this->AddObject(plane);
  }
}

//------------------------------------------------------------------------------
void vtkShadowCasterSignature::AddTexture(vtkTexture* texture)
{
  this->AddObject(texture);
  if (texture)
  {
    this->AddObject(texture->GetTransform());
    this->AddObject(texture->GetLookupTable());
    this->AddInputs(texture, 0);
  }
}

//------------------------------------------------------------------------------
void vtkShadowCasterSignature::AddProperty(vtkProperty* property)
{
  const bool flags[] = { property->GetEdgeVisibility() != 0, property->GetVertexVisibility() != 0,
    property->GetBackfaceCulling() != 0, property->GetFrontfaceCulling() != 0,
    property->GetRenderPointsAsSpheres(), property->GetRenderLinesAsTubes(),
    property->GetLighting() };
  std::uint64_t word = 0;
  for (const bool flag : flags)
  {
    word = 2 * word + (flag ? 1 : 0);
  }
  this->Add(16 * word + static_cast<std::uint64_t>(property->GetRepresentation()));
  this->Add(GetNewerState(property, 0));
  this->Add(static_cast<double>(property->GetPointSize()));
  this->Add(static_cast<double>(property->GetLineWidth()));
  this->Add(property->GetOpacity());
}

//------------------------------------------------------------------------------
void vtkShadowCasterSignature::AddShaders(vtkActor* actor)
{
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  this->AddObject(shaders);
  this->Add(static_cast<std::uint64_t>(shaders->GetShaderMTime()));
  this->AddObject(shaders->GetVertexCustomUniforms());
  this->AddObject(shaders->GetGeometryCustomUniforms());
  this->AddObject(shaders->GetFragmentCustomUniforms());
}

//------------------------------------------------------------------------------
void vtkShadowCasterSignature::AddActor(vtkActor* actor, vtkMapper* mapper)
{
  this->AddObject(mapper);
  this->AddClippingPlanes(mapper);
  this->AddProperty(actor->GetProperty());
  this->AddTexture(actor->GetTexture());
  for (const auto& texture : actor->GetProperty()->GetAllTextures())
  {
    this->AddTexture(texture.second);
  }
  this->AddShaders(actor);
  if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    this->AddObject(glyphs->GetBlockAttributes());
  }
  this->AddInputs(mapper, 1); // the shapes of glyphs
}

VTK_ABI_NAMESPACE_END
