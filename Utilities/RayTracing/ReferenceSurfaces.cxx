// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceSurfaces.h"

#include <vtkActor.h>
#include <vtkAssemblyNode.h>
#include <vtkAssemblyPath.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkCompositeDataIterator.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTriangleFilter.h>
#include <vtkVersionMacros.h>

// The mapper that knows block visibility: one class up to VTK 9.2, another from 9.3 on.
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0)
#include <vtkCompositePolyDataMapper2.h>
using CompositeMapper = vtkCompositePolyDataMapper2;
#else
#include <vtkCompositePolyDataMapper.h>
using CompositeMapper = vtkCompositePolyDataMapper;
#endif

#include <algorithm> // For the copy of the matrix

namespace softshadows
{
namespace
{

using PolyDataList = std::vector<vtkPolyData*>;

//--------------------------------------------------------------------------------------------------
// What a block is told holds for its children, unless they are told otherwise.
void CollectBlocks(vtkDataObject* block, vtkCompositeDataDisplayAttributes* attributes, bool drawn,
  PolyDataList& found)
{
  if (!block)
  {
    return;
  }
  if (attributes && attributes->HasBlockVisibility(block))
  {
    drawn = attributes->GetBlockVisibility(block);
  }
  if (attributes && attributes->HasBlockOpacity(block) && attributes->GetBlockOpacity(block) < 1.0)
  {
    return;
  }
  if (auto* data = vtkPolyData::SafeDownCast(block))
  {
    if (drawn)
    {
      found.push_back(data);
    }
    return;
  }
  auto* tree = vtkDataObjectTree::SafeDownCast(block);
  if (!tree)
  {
    return;
  }
  vtkSmartPointer<vtkDataObjectTreeIterator> children;
  children.TakeReference(tree->NewTreeIterator());
  children->VisitOnlyLeavesOff();
  children->TraverseSubTreeOff();
  for (children->InitTraversal(); !children->IsDoneWithTraversal(); children->GoToNextItem())
  {
    CollectBlocks(children->GetCurrentDataObject(), attributes, drawn, found);
  }
}

//--------------------------------------------------------------------------------------------------
PolyDataList CollectInputs(vtkMapper* mapper)
{
  vtkCompositeDataDisplayAttributes* attributes = nullptr;
  if (auto* composite = CompositeMapper::SafeDownCast(mapper))
  {
    attributes = composite->GetCompositeDataDisplayAttributes();
  }
  PolyDataList found;
  CollectBlocks(mapper->GetInputDataObject(0, 0), attributes, true, found);
  return found;
}

//--------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Triangulate(vtkPolyData* data)
{
  vtkNew<vtkTriangleFilter> filter;
  filter->PassLinesOff();
  filter->PassVertsOff();
  filter->SetInputData(data);
  filter->Update();
  return filter->GetOutput();
}

//--------------------------------------------------------------------------------------------------
bool DrawsSurface(vtkActor* actor)
{
  return actor->GetVisibility() && actor->GetMapper() &&
    actor->GetMapper()->GetNumberOfInputConnections(0) > 0 &&
    actor->GetProperty()->GetRepresentation() == VTK_SURFACE;
}

//--------------------------------------------------------------------------------------------------
void AppendActor(vtkActor* actor, vtkMatrix4x4* matrix, ReferenceSurface surface,
  std::vector<ReferenceSurface>& all)
{
  actor->GetMapper()->Update();
  if (!actor->HasOpaqueGeometry())
  {
    return;
  }
  std::copy_n(matrix->GetData(), 16, surface.ToWorld.begin());
  for (vtkPolyData* data : CollectInputs(actor->GetMapper()))
  {
    surface.Triangles = Triangulate(data);
    if (surface.Triangles->GetNumberOfPolys() > 0)
    {
      all.push_back(surface);
    }
  }
}

}

//--------------------------------------------------------------------------------------------------
std::vector<ReferenceSurface> CollectSurfaces(vtkRenderer* renderer)
{
  std::vector<ReferenceSurface> surfaces;
  unsigned int object = 0;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (!prop->GetVisibility())
    {
      continue;
    }
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      // As an assembly draws its parts: only the last node's own visibility counts.
      vtkAssemblyNode* node = path->GetLastNode();
      auto* actor = vtkActor::SafeDownCast(node->GetViewProp());
      if (!actor || !DrawsSurface(actor))
      {
        continue;
      }
      ReferenceSurface surface;
      surface.Prop = prop;
      surface.Lit = actor->GetProperty()->GetLighting();
      surface.Object = object++;
      AppendActor(actor, node->GetMatrix(), surface, surfaces);
    }
  }
  return surfaces;
}

}
