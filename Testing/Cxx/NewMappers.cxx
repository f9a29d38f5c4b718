// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Mappers of VTK 9.2 and later, where there are such, and what older ones do differently there.
#include "Varieties.h"

#include "Props.h"

#include "vtkActor.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkOpenGLGlyph3DMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShadowCasters.h"
#include "vtkSphereSource.h"

#if __has_include("vtkOpenGLLowMemoryPolyDataMapper.h")
#include "vtkOpenGLLowMemoryPolyDataMapper.h"
#endif
#if __has_include("vtkCompositePolyDataMapperDelegator.h")
#include "vtkCompositePolyDataMapper.h"
#else
#include "vtkCompositePolyDataMapper2.h"
#endif
#ifdef SOFTSHADOWS_HAS_HYPER_TREE_GRIDS
#include "vtkHyperTreeGrid.h"
#include "vtkHyperTreeGridGeometry.h"
#include "vtkHyperTreeGridMapper.h"
#include "vtkRandomHyperTreeGridSource.h"
#endif

namespace SoftShadowsTesting
{
namespace
{

using Props = std::vector<vtkSmartPointer<vtkProp>>;

const double Places[][3] = { { -0.5, 0.0, 0.9 }, { 0.0, 0.3, 0.7 }, { 0.5, 0.0, 1.1 } };

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSphereSource> MakeBall(double radius, const double center[3])
{
  auto ball = vtkSmartPointer<vtkSphereSource>::New();
  ball->SetRadius(radius);
  ball->SetCenter(center[0], center[1], center[2]);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(24);
  return ball;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSphereSource> MakeLargeBall()
{
  const double center[3] = { 0.0, 0.0, 0.9 };
  return MakeBall(0.5, center);
}

//------------------------------------------------------------------------------
Props PlainBalls()
{
  Props props;
  for (const auto& place : Places)
  {
    props.push_back(MakeActor(MakeBall(0.25, place)));
  }
  return props;
}

//------------------------------------------------------------------------------
/// In VTK 9.1 one mapper per colour, later batches.
Props CompositeBalls()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const auto ball = MakeBall(0.25, Places[i]);
    ball->Update();
    blocks->SetBlock(i, ball->GetOutput());
  }
#if __has_include("vtkCompositePolyDataMapperDelegator.h")
  vtkNew<vtkCompositePolyDataMapper> mapper;
#else
  vtkNew<vtkCompositePolyDataMapper2> mapper;
#endif
  mapper->SetInputDataObject(blocks);
  mapper->SetCompositeDataDisplayAttributes(vtkNew<vtkCompositeDataDisplayAttributes>());
  const double red[3] = { 1.0, 0.0, 0.0 };
  mapper->SetBlockColor(1, red); // a batch of its own
  const vtkSmartPointer<vtkActor> actor = MakeActor(MakeLargeBall());
  actor->SetMapper(mapper);
  return { actor };
}

//------------------------------------------------------------------------------
/// Glyphs at a level of detail whose triangles are all of the source's.
Props GlyphsWithLevels()
{
  vtkNew<vtkPoints> points;
  for (const auto& place : Places)
  {
    points->InsertNextPoint(place);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  const double center[3] = { 0.0, 0.0, 0.0 };
  const auto ball = MakeBall(0.25, center);
  ball->Update();
  vtkNew<vtkOpenGLGlyph3DMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetSourceData(ball->GetOutput());
  mapper->ScalingOff();
  mapper->SetCullingAndLOD(true);
  mapper->SetNumberOfLOD(1);
  mapper->SetLODDistanceAndTargetReduction(0, 0.5F, 0.0F);
  const vtkSmartPointer<vtkActor> actor = MakeActor(MakeLargeBall());
  actor->SetMapper(mapper);
  return { actor };
}

#if __has_include("vtkOpenGLLowMemoryPolyDataMapper.h")
//------------------------------------------------------------------------------
/// A ball by a mapper, its property changed.
template <typename Mapper>
Props LargeBall(const std::function<void(vtkProperty*)>& change)
{
  vtkNew<Mapper> mapper;
  mapper->SetInputConnection(MakeLargeBall()->GetOutputPort());
  const vtkSmartPointer<vtkActor> actor = MakeActor(MakeLargeBall());
  actor->SetMapper(mapper);
  change(actor->GetProperty());
  return { actor };
}

//------------------------------------------------------------------------------
void PointSpheres(vtkProperty* property)
{
  property->SetRepresentationToPoints();
  property->RenderPointsAsSpheresOn();
  property->SetPointSize(5.0F);
}

//------------------------------------------------------------------------------
void VertexSpheres(vtkProperty* property)
{
  property->VertexVisibilityOn();
  property->RenderPointsAsSpheresOn();
  property->SetPointSize(5.0F);
}

//------------------------------------------------------------------------------
/// A ball with its vertices, which cast nothing: the surface casts alone.
Props BallAndPoints()
{
  Props props = LargeBall<vtkPolyDataMapper>([](vtkProperty*) {});
  Props points = LargeBall<vtkPolyDataMapper>(PointSpheres);
  vtkShadowCasters::SetCastsShadow(points[0], false);
  props.push_back(points[0]);
  return props;
}
#endif

#ifdef SOFTSHADOWS_HAS_HYPER_TREE_GRIDS
//------------------------------------------------------------------------------
vtkSmartPointer<vtkRandomHyperTreeGridSource> MakeTrees()
{
  auto trees = vtkSmartPointer<vtkRandomHyperTreeGridSource>::New();
  trees->SetDimensions(4, 4, 4);
  trees->SetOutputBounds(-0.5, 0.5, -0.5, 0.5, 0.4, 1.4);
  trees->SetSeed(3);
  trees->SetMaxDepth(3);
  trees->SetMaskedFraction(0.3);
  return trees;
}

//------------------------------------------------------------------------------
Props TreesOfPolygons()
{
  vtkNew<vtkHyperTreeGridGeometry> surface;
  surface->SetInputConnection(MakeTrees()->GetOutputPort());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(surface->GetOutputPort());
  mapper->ScalarVisibilityOff();
  const vtkSmartPointer<vtkActor> actor = MakeActor(MakeLargeBall());
  actor->SetMapper(mapper);
  return { actor };
}

//------------------------------------------------------------------------------
Props TreesOfMapper()
{
  const auto trees = MakeTrees();
  trees->Update();
  vtkNew<vtkHyperTreeGridMapper> mapper;
  mapper->SetInputDataObject(trees->GetOutputDataObject(0));
  mapper->ScalarVisibilityOff();
  const vtkSmartPointer<vtkActor> actor = MakeActor(MakeLargeBall());
  actor->SetMapper(mapper);
  return { actor };
}
#endif

}

//------------------------------------------------------------------------------
std::vector<Variety> NewMapperVarieties()
{
  std::vector<Variety> varieties = {
    // One prop's map is not that of three, so penumbrae differ by a step or two of 8 bits.
    { "CompositeWithColors", PlainBalls, CompositeBalls, 0.03, 0.008 },
    { "GlyphLevels", PlainBalls, GlyphsWithLevels, 0.03, 0.008 },
  };
#if __has_include("vtkOpenGLLowMemoryPolyDataMapper.h")
  using LowMemory = vtkOpenGLLowMemoryPolyDataMapper;
  const auto unchanged = [](vtkProperty*) {};
  // VTK 9.1 draws vertices flat and unlit.
  varieties.push_back({ "VertexSpheres", BallAndPoints,
    [] { return LargeBall<vtkPolyDataMapper>(VertexSpheres); }, 0.03 });
  varieties.push_back({ "LowMemory", [=] { return LargeBall<vtkPolyDataMapper>(unchanged); },
    [=] { return LargeBall<LowMemory>(unchanged); } });
  varieties.push_back(
    { "LowMemoryPoints", [] { return LargeBall<vtkPolyDataMapper>(PointSpheres); },
      [] { return LargeBall<LowMemory>(PointSpheres); } });
#endif
#ifdef SOFTSHADOWS_HAS_HYPER_TREE_GRIDS
  varieties.push_back({ "HyperTreeGrid", TreesOfPolygons, TreesOfMapper });
#endif
  return varieties;
}

}
