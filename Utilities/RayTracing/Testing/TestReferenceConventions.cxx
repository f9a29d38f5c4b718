// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What the ray tracer's images mean: where a value is missing, what blocks, what is seen.
#include "ReferenceHash.h"
#include "ReferenceTracer.h"
#include "Scenes.h"

#include "vtkAreaLight.h"
#include "vtkShadowCasters.h"

#include <vtkActor.h>
#include <vtkAssembly.h>
#include <vtkCamera.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkCubeSource.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkVersionMacros.h>

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0)
#include <vtkCompositePolyDataMapper2.h>
using CompositeMapper = vtkCompositePolyDataMapper2;
#else
#include <vtkCompositePolyDataMapper.h>
using CompositeMapper = vtkCompositePolyDataMapper;
#endif

#include <gtest/gtest.h>

#include <cmath>

using softshadows::ReferenceVisibility;
using SoftShadowsTesting::MakeQuadActor;

namespace
{

constexpr int Width = 32;
constexpr int Height = 16;

//--------------------------------------------------------------------------------------------------
// A square lamp of 0.2 at (0, 0, 4) over a square floor of 4 in the plane z = 0. The camera looks
// straight down from z = 10 in parallel projection and sees 8 x 4: x from -4 to 4, and y.
class ReferenceConventions : public testing::Test
{
protected:
  ReferenceConventions()
  {
    this->Floor =
      MakeQuadActor({ { { { -2.0, -2.0, 0.0 } }, { { 4.0, 0.0, 0.0 } }, { { 0.0, 4.0, 0.0 } } } });
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->AddActor(this->Floor);
    this->Lamp->SetPosition(0.0, 0.0, 4.0);
    this->Lamp->SetFocalPoint(0.0, 0.0, 0.0);
    this->Lamp->SetSize(0.2, 0.2);
    this->Renderer->AddLight(this->Lamp);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 10.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(2.0);
  }

  ReferenceVisibility Trace(int perAxis = 4)
  {
    return softshadows::Trace(this->Renderer, Width, Height, perAxis);
  }

  /// The pixel that shows a point of a plane parallel to the floor.
  static size_t At(double x, double y)
  {
    const int column = static_cast<int>(std::floor((x + 4.0) / 8.0 * Width));
    const int row = static_cast<int>(std::floor((2.0 - y) / 4.0 * Height));
    return static_cast<size_t>(row) * Width + column;
  }

  /// A square of 1 at height 2, centred over (x, 0). Its shadow is about 2 wide, centred at 2 x.
  static vtkSmartPointer<vtkActor> MakeBlocker(double x)
  {
    return MakeQuadActor(
      { { { { x - 0.5, -0.5, 2.0 } }, { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } } } });
  }

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkAreaLight> Lamp;
  vtkSmartPointer<vtkActor> Floor;
};

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceConventions, ASheetBlocksWhatShinesOnItsOtherSide)
{
  this->Lamp->SetPosition(0.0, 0.0, -4.0);
  EXPECT_EQ(this->Trace().Visibility[0][At(0.1, 0.1)], 0.0F);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceConventions, NothingIsSeenBesideTheFloor)
{
  const ReferenceVisibility result = this->Trace();
  EXPECT_EQ(result.Visibility[0][At(0.1, 0.1)], 1.0F);
  EXPECT_FLOAT_EQ(result.Depth[At(0.1, 0.1)], 10.0F);
  EXPECT_EQ(result.Normal[At(0.1, 0.1)][2], 1.0F);
  EXPECT_EQ(result.Object[At(0.1, 0.1)], 0);
  EXPECT_EQ(result.Props[0], this->Floor.Get());
  EXPECT_TRUE(std::isnan(result.Visibility[0][At(3.0, 0.1)]));
  EXPECT_TRUE(std::isnan(result.Depth[At(3.0, 0.1)]));
  EXPECT_EQ(result.Object[At(3.0, 0.1)], -1);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceConventions, FirstRowIsTheTop)
{
  vtkSmartPointer<vtkActor> blocker = MakeBlocker(0.0);
  blocker->SetPosition(0.0, 0.5, 0.0); // shadow from y = 0 to 2
  this->Renderer->AddActor(blocker);
  const ReferenceVisibility result = this->Trace();
  EXPECT_EQ(result.Visibility[0][At(0.1, 1.6)], 0.0F);
  EXPECT_EQ(result.Visibility[0][At(0.1, -1.6)], 1.0F);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceConventions, KeysSwitchCastingAndReceiving)
{
  vtkSmartPointer<vtkActor> blocker = MakeBlocker(-0.6); // shadow around x = -1.2
  this->Renderer->AddActor(blocker);
  EXPECT_EQ(this->Trace().Visibility[0][At(-1.6, 0.1)], 0.0F);
  vtkShadowCasters::SetCastsShadow(blocker, false);
  EXPECT_EQ(this->Trace().Visibility[0][At(-1.6, 0.1)], 1.0F);
  vtkShadowCasters::SetReceivesShadow(blocker, false);
  EXPECT_TRUE(std::isnan(this->Trace().Visibility[0][At(-0.6, 0.1)])) << "the blocker itself";
  EXPECT_FLOAT_EQ(this->Trace().Depth[At(-0.6, 0.1)], 8.0F);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceConventions, KeysOfVTKCountWhereThereIsNoneOfOurs)
{
  vtkSmartPointer<vtkActor> blocker = MakeBlocker(-0.6); // shadow around x = -1.2
  this->Renderer->AddActor(blocker);
  vtkNew<vtkInformation> keys;
  blocker->SetPropertyKeys(keys);
  keys->Set(vtkInformationIntegerKey::MakeKey("RECEIVER", "vtkShadowMapBakerPass"), 1);
  EXPECT_EQ(this->Trace().Visibility[0][At(-1.6, 0.1)], 1.0F) << "a receiver is no occluder";
  keys->Set(vtkShadowCasters::CASTS_SHADOW(), 1);
  EXPECT_EQ(this->Trace().Visibility[0][At(-1.6, 0.1)], 0.0F) << "ours first";
  keys->Clear();
  keys->Set(vtkInformationIntegerKey::MakeKey("OCCLUDER", "vtkShadowMapBakerPass"), 1);
  const ReferenceVisibility result = this->Trace();
  EXPECT_EQ(result.Visibility[0][At(-1.6, 0.1)], 0.0F) << "an occluder";
  EXPECT_TRUE(std::isnan(result.Visibility[0][At(-0.6, 0.1)])) << "is no receiver";
}

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceConventions, NothingIsKnownOutsideTheConeAndBehindTheLight)
{
  this->Lamp->SetConeAngle(15.0); // radius 1.07 on the floor
  ReferenceVisibility result = this->Trace();
  EXPECT_EQ(result.Visibility[0][At(0.8, 0.1)], 1.0F);
  EXPECT_TRUE(std::isnan(result.Visibility[0][At(1.4, 0.1)]));
  this->Lamp->SetFocalPoint(0.0, 0.0, 5.0);
  EXPECT_TRUE(std::isnan(this->Trace().Visibility[0][At(0.8, 0.1)]));
  this->Lamp->SetConeAngle(90.0);
  this->Lamp->SetShapeToPoint();
  EXPECT_EQ(this->Trace().Visibility[0][At(0.8, 0.1)], 1.0F) << "a point shines to all sides";
}

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceConventions, LightsThatAreOffAreLeftOut)
{
  vtkNew<vtkAreaLight> off;
  off->SwitchOff();
  vtkNew<vtkAreaLight> sun;
  sun->SetPosition(1.0, 0.0, 1.0);
  sun->SetAngularDiameter(0.5);
  this->Renderer->AddLight(off);
  this->Renderer->AddLight(sun);
  this->Renderer->AddActor(MakeBlocker(0.0));
  const ReferenceVisibility result = this->Trace();
  ASSERT_EQ(result.Visibility.size(), 2U);
  // At a slope of 45 degrees the sun moves the shadow by the blocker's height.
  EXPECT_EQ(result.Visibility[1][At(-1.9, 0.1)], 0.0F);
  EXPECT_EQ(result.Visibility[0][At(-1.9, 0.1)], 1.0F);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceConventions, PlainLightsCastHardShadows)
{
  vtkNew<vtkLight> plain;
  plain->PositionalOn();
  plain->SetPosition(0.0, 0.0, 4.0);
  plain->SetConeAngle(60.0);
  this->Renderer->RemoveAllLights();
  this->Renderer->AddLight(plain);
  this->Renderer->AddActor(MakeBlocker(0.0));
  const ReferenceVisibility result = this->Trace();
  for (float value : result.Visibility[0])
  {
    EXPECT_TRUE(std::isnan(value) || value == 0.0F || value == 1.0F) << value;
  }
  EXPECT_EQ(result.Visibility[0][At(0.9, 0.1)], 0.0F);
  EXPECT_EQ(result.Visibility[0][At(1.1, 0.1)], 1.0F);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceConventions, InvisibleAndTranslucentPropsAreNotThere)
{
  vtkSmartPointer<vtkActor> blocker = MakeBlocker(0.0);
  this->Renderer->AddActor(blocker);
  EXPECT_EQ(this->Trace().Visibility[0][At(0.9, 0.1)], 0.0F);
  blocker->VisibilityOff();
  EXPECT_EQ(this->Trace().Visibility[0][At(0.9, 0.1)], 1.0F);
  blocker->VisibilityOn();
  blocker->GetProperty()->SetOpacity(0.5);
  EXPECT_EQ(this->Trace().Visibility[0][At(0.9, 0.1)], 1.0F);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceConventions, UnlitSurfacesReceiveNothingButCast)
{
  vtkSmartPointer<vtkActor> blocker = MakeBlocker(-0.6);
  blocker->GetProperty()->LightingOff();
  this->Renderer->AddActor(blocker);
  const ReferenceVisibility result = this->Trace();
  EXPECT_EQ(result.Visibility[0][At(-1.6, 0.1)], 0.0F);
  EXPECT_TRUE(std::isnan(result.Visibility[0][At(-0.6, 0.1)]));
}

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceConventions, AssembliesMoveTheirParts)
{
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(MakeBlocker(0.0));
  assembly->AddPart(MakeBlocker(0.0));
  assembly->SetPosition(-0.6, 0.0, 0.0);
  this->Renderer->AddActor(assembly);
  const ReferenceVisibility result = this->Trace();
  EXPECT_EQ(result.Visibility[0][At(-1.6, 0.1)], 0.0F);
  EXPECT_EQ(result.Visibility[0][At(0.9, 0.1)], 1.0F);
  ASSERT_EQ(result.Props.size(), 3U);
  EXPECT_EQ(result.Props[2], assembly.Get());
}

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceConventions, BlocksHaveTheirOwnVisibility)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkMultiBlockDataSet> group;
  vtkSmartPointer<vtkActor> left = MakeBlocker(-0.75);
  vtkSmartPointer<vtkActor> right = MakeBlocker(0.75);
  group->SetBlock(0, left->GetMapper()->GetInputDataObject(0, 0));
  blocks->SetBlock(0, group);
  blocks->SetBlock(1, right->GetMapper()->GetInputDataObject(0, 0));
  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Renderer->AddActor(actor);

  ReferenceVisibility result = this->Trace();
  EXPECT_EQ(result.Visibility[0][At(-1.6, 0.1)], 0.0F);
  EXPECT_EQ(result.Visibility[0][At(1.6, 0.1)], 0.0F);
  attributes->SetBlockVisibility(group, false);
  result = this->Trace();
  EXPECT_EQ(result.Visibility[0][At(-1.6, 0.1)], 1.0F) << "hidden with its group";
  EXPECT_EQ(result.Visibility[0][At(1.6, 0.1)], 0.0F);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceConventions, ContactIsDarkUpToTheEdge)
{
  // A box on the floor, the lamp low at its left: the floor right of the box is in the umbra from
  // the first pixel on, and no face of the box shadows itself.
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(-0.5, 0.5, -1.9, 1.9, 0.0, 0.2);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkActor> box;
  box->SetMapper(mapper);
  this->Renderer->AddActor(box);
  this->Lamp->SetPosition(-3.0, 0.0, 0.4);
  this->Lamp->SetFocalPoint(0.0, 0.0, 0.3);
  this->Renderer->GetActiveCamera()->SetParallelScale(0.01); // pixels of 0.02
  const ReferenceVisibility result = softshadows::Trace(this->Renderer, 200, 1, 4);
  int top = 0;
  int dark = 0;
  for (int column = 0; column < 200; ++column)
  {
    const double x = 0.02 * (column + 0.5 - 100.0);
    const float value = result.Visibility[0][column];
    if (std::abs(x) < 0.5)
    {
      EXPECT_EQ(value, 1.0F) << "on the box, x = " << x;
      ++top;
    }
    else if (x > 0.5 && x < 1.2)
    {
      EXPECT_EQ(value, 0.0F) << "behind the box, x = " << x;
      ++dark;
    }
  }
  EXPECT_EQ(top, 50);
  EXPECT_EQ(dark, 35);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceConventions, WhatLiesInTheLightsPlaneDoesNotBlockIt)
{
  this->Renderer->AddActor(
    MakeQuadActor({ { { { -0.3, -0.3, 4.0 } }, { { 0.6, 0.0, 0.0 } }, { { 0.0, 0.6, 0.0 } } } }));
  EXPECT_EQ(this->Trace().Visibility[0][At(0.9, 0.1)], 1.0F);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceConventions, AnEmptySceneIsAllNaN)
{
  this->Renderer->RemoveAllViewProps();
  const ReferenceVisibility result = this->Trace();
  for (float value : result.Visibility[0])
  {
    EXPECT_TRUE(std::isnan(value));
  }
}

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceConventions, HashFollowsWhatTheImageDependsOn)
{
  vtkSmartPointer<vtkActor> blocker = MakeBlocker(0.0);
  this->Renderer->AddActor(blocker);
  const std::string hash = softshadows::HashScene(this->Renderer);
  EXPECT_EQ(hash.size(), 32U);
  EXPECT_EQ(softshadows::HashScene(this->Renderer), hash);
  blocker->SetPosition(0.0, 0.0, 0.001);
  const std::string moved = softshadows::HashScene(this->Renderer);
  EXPECT_NE(moved, hash);
  this->Lamp->SetSize(0.2, 0.3);
  const std::string larger = softshadows::HashScene(this->Renderer);
  EXPECT_NE(larger, moved);
  this->Renderer->GetActiveCamera()->Elevation(1.0);
  const std::string raised = softshadows::HashScene(this->Renderer);
  EXPECT_NE(raised, larger);
  vtkShadowCasters::SetCastsShadow(blocker, false);
  EXPECT_NE(softshadows::HashScene(this->Renderer), raised);
}

}
