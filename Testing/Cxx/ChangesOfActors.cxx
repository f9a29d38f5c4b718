// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChangesInPlace.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkAssembly.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkImageFlip.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropAssembly.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkShadowCasters.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkUniforms.h"

#include <algorithm>

namespace SoftShadowsTesting
{
namespace
{

using Change = std::function<void()>;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> AddBall(BallScene& scene)
{
  auto ball = MakeSphereActor({ { 0.0, 0.0, 0.9 } }, 0.5, 24);
  scene.Renderer->AddActor(ball);
  return ball;
}

//------------------------------------------------------------------------------
template <typename Functor>
SceneChange OfBall(Functor change)
{
  return [change](BallScene& scene) -> Change
  {
    const auto ball = AddBall(scene);
    return [=] { change(ball.Get()); };
  };
}

//------------------------------------------------------------------------------
/// A change of the property of a ball that is in a state of its own before.
template <typename Before, typename Functor>
SceneChange OfProperty(Before before, Functor change)
{
  return [=](BallScene& scene) -> Change
  {
    const auto ball = AddBall(scene);
    before(ball->GetProperty());
    return [=] { change(ball->GetProperty()); };
  };
}

void Nothing(vtkProperty*) {}

//------------------------------------------------------------------------------
/// Two by two texels; the first one is a hole.
vtkSmartPointer<vtkImageData> MakeImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  std::fill_n(values, 16, static_cast<unsigned char>(255));
  values[3] = 0;
  return image;
}

//------------------------------------------------------------------------------
void MoveHole(vtkImageData* image)
{
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  values[3] = 255;
  values[15] = 0;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> AddSheet(BallScene& scene, vtkTexture* texture)
{
  vtkNew<vtkPlaneSource> sheet;
  sheet->SetOrigin(-0.7, -0.5, 0.8);
  sheet->SetPoint1(0.7, -0.5, 0.8);
  sheet->SetPoint2(-0.7, 0.5, 0.8);
  texture->InterpolateOff();
  auto actor = MakeActor(sheet);
  actor->SetTexture(texture);
  scene.Renderer->AddActor(actor);
  return actor;
}

//------------------------------------------------------------------------------
template <typename Functor>
SceneChange OfTexture(Functor change)
{
  return [change](BallScene& scene) -> Change
  {
    const auto image = MakeImage();
    auto texture = vtkSmartPointer<vtkTexture>::New();
    texture->SetInputData(image);
    auto transform = vtkSmartPointer<vtkTransform>::New();
    texture->SetTransform(transform);
    AddSheet(scene, texture);
    return [=] { change(image.Get(), transform.Get()); };
  };
}

//------------------------------------------------------------------------------
Change TexturePipeline(BallScene& scene)
{
  auto flip = vtkSmartPointer<vtkImageFlip>::New();
  flip->SetInputData(MakeImage());
  flip->SetFilteredAxis(0);
  vtkNew<vtkTexture> texture;
  texture->SetInputConnection(flip->GetOutputPort());
  AddSheet(scene, texture);
  return [=] { flip->SetFilteredAxis(1); };
}

//------------------------------------------------------------------------------
/// The texture of a physically based material, which a property holds.
Change PropertyTexture(BallScene& scene)
{
  const auto image = MakeImage();
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->UseSRGBColorSpaceOn();
  const auto actor = AddSheet(scene, texture);
  actor->SetTexture(nullptr);
  actor->GetProperty()->SetInterpolationToPBR();
  actor->GetProperty()->SetBaseColorTexture(texture);
  return [=]
  {
    MoveHole(image);
    image->Modified();
  };
}

//------------------------------------------------------------------------------
Change TextureTable(BallScene& scene)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 1, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  values[0] = 0;
  values[1] = 1;
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(2);
  table->SetRange(0.0, 1.0);
  table->SetTableValue(0, 1.0, 1.0, 1.0, 0.0);
  table->SetTableValue(1, 1.0, 1.0, 1.0, 1.0);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->SetLookupTable(table);
  texture->SetColorModeToMapScalars();
  AddSheet(scene, texture);
  return [=]
  {
    table->SetTableValue(0, 1.0, 1.0, 1.0, 1.0);
    table->SetTableValue(1, 1.0, 1.0, 1.0, 0.0);
  };
}

//------------------------------------------------------------------------------
Change ShaderValue(BallScene& scene)
{
  const auto ball = AddBall(scene);
  vtkShaderProperty* shaders = ball->GetShaderProperty();
  shaders->AddFragmentShaderReplacement(
    "//VTK::Clip::Impl", true, "//VTK::Clip::Impl\n  if (gl_FragCoord.x < cut) discard;\n", false);
  shaders->GetFragmentCustomUniforms()->SetUniformf("cut", 0.0f);
  return [=] { ball->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformf("cut", 52.0f); };
}

//------------------------------------------------------------------------------
/// The transform of an actor, at the end of a pipeline of transforms.
Change TransformPipeline(BallScene& scene)
{
  auto first = vtkSmartPointer<vtkTransform>::New();
  vtkNew<vtkTransform> second;
  second->Scale(1.0, 1.0, 1.1);
  second->SetInput(first);
  AddBall(scene)->SetUserTransform(second);
  return [=] { first->Translate(0.4, 0.0, 0.0); };
}

//------------------------------------------------------------------------------
Change UserMatrix(BallScene& scene)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  AddBall(scene)->SetUserMatrix(matrix);
  return [=] { matrix->SetElement(0, 3, 0.4); };
}

//------------------------------------------------------------------------------
Change LightTransform(BallScene& scene)
{
  AddBall(scene);
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  scene.Lamp->SetTransformMatrix(matrix);
  vtkAreaLight* lamp = scene.Lamp;
  return [=]
  {
    matrix->SetElement(0, 3, -2.0);
    lamp->Modified(); // visibility needs it not, but VTK's own lighting knows no matrix
  };
}

//------------------------------------------------------------------------------
/// A ball two assemblies deep.
template <typename Functor>
SceneChange OfPart(Functor change)
{
  return [change](BallScene& scene) -> Change
  {
    const auto ball = AddBall(scene);
    scene.Renderer->RemoveActor(ball);
    auto inner = vtkSmartPointer<vtkAssembly>::New();
    inner->AddPart(ball);
    vtkNew<vtkAssembly> outer;
    outer->AddPart(inner);
    scene.Renderer->AddViewProp(outer);
    return [=] { change(ball.Get(), inner.Get()); };
  };
}

//------------------------------------------------------------------------------
/// The plane that cuts a part of an assembly.
Change PlaneOfPart(BallScene& scene)
{
  const auto ball = AddBall(scene);
  scene.Renderer->RemoveActor(ball);
  vtkNew<vtkPropAssembly> assembly;
  assembly->AddPart(ball);
  scene.Renderer->AddViewProp(assembly);
  auto plane = vtkSmartPointer<vtkPlane>::New();
  plane->SetOrigin(0.0, 0.0, 0.9);
  plane->SetNormal(-1.0, 0.0, 0.2);
  ball->GetMapper()->AddClippingPlane(plane);
  return [=] { plane->SetOrigin(0.3, 0.0, 0.9); };
}

//------------------------------------------------------------------------------
/// A key that is set where there are keys already.
SceneChange OfKey(vtkInformationIntegerKey* key)
{
  return [key](BallScene& scene) -> Change
  {
    const auto ball = AddBall(scene);
    vtkShadowCasters::SetCastsShadow(ball, true);
    return [=] { ball->GetPropertyKeys()->Set(key, 0); };
  };
}

//------------------------------------------------------------------------------
std::vector<ChangeInPlace> ChangesOfProperties()
{
  const auto wires = [](vtkProperty* property)
  {
    property->SetRepresentationToWireframe();
    property->SetLineWidth(3.0f);
  };
  const auto dots = [](vtkProperty* property)
  {
    property->SetRepresentationToPoints();
    property->SetPointSize(6.0f);
  };
  return {
    { "FrontfaceCulling", OfProperty(Nothing, [](vtkProperty* p) { p->FrontfaceCullingOn(); }) },
    { "Representation",
      OfProperty(Nothing, [](vtkProperty* p) { p->SetRepresentationToPoints(); }) },
    { "LineWidth", OfProperty(wires, [](vtkProperty* p) { p->SetLineWidth(6.0f); }) },
    { "Tubes", OfProperty(wires, [](vtkProperty* p) { p->RenderLinesAsTubesOn(); }) },
    { "PointSize", OfProperty(dots, [](vtkProperty* p) { p->SetPointSize(10.0f); }) },
    { "Spheres", OfProperty(dots, [](vtkProperty* p) { p->RenderPointsAsSpheresOn(); }) },
    { "Vertices",
      OfProperty([](vtkProperty* p) { p->SetPointSize(8.0f); },
        [](vtkProperty* p)
        {
          p->EdgeVisibilityOn();
          p->VertexVisibilityOn();
        }) },
    { "Opacity", OfProperty(Nothing, [](vtkProperty* p) { p->SetOpacity(0.5); }) },
    { "Lighting", OfProperty(Nothing, [](vtkProperty* p) { p->LightingOff(); }) },
  };
}

}

//------------------------------------------------------------------------------
std::vector<ChangeInPlace> ChangesOfActors()
{
  std::vector<ChangeInPlace> changes = {
    { "TexturePixels",
      OfTexture(
        [](vtkImageData* image, vtkTransform*)
        {
          MoveHole(image);
          image->GetPointData()->GetScalars()->Modified();
          image->Modified();
        }) },
    { "TextureArray",
      OfTexture(
        [](vtkImageData* image, vtkTransform*)
        {
          MoveHole(image);
          image->GetPointData()->GetScalars()->Modified();
        }) },
    { "TextureTransform",
      OfTexture(
        [](vtkImageData*, vtkTransform* transform) { transform->Translate(0.5, 0.0, 0.0); }) },
    { "TexturePipeline", TexturePipeline },
    { "TextureTable", TextureTable },
    { "PropertyTexture", PropertyTexture },
    { "ShaderCode",
      OfBall(
        [](vtkActor* ball)
        {
          ball->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Clip::Impl", true,
            "//VTK::Clip::Impl\n  if (gl_FragCoord.x < 52.0) discard;\n", false);
        }) },
    { "ShaderValue", ShaderValue },
    { "TransformPipeline", TransformPipeline },
    { "UserMatrix", UserMatrix },
    { "LightTransform", LightTransform },
    { "PartMoved", OfPart([](vtkActor* ball, vtkAssembly*) { ball->AddPosition(0.4, 0.0, 0.0); }) },
    { "PartHidden", OfPart([](vtkActor* ball, vtkAssembly*) { ball->VisibilityOff(); }) },
    { "PartCulled",
      OfPart([](vtkActor* ball, vtkAssembly*) { ball->GetProperty()->FrontfaceCullingOn(); }) },
    { "PartInput",
      OfPart(
        [](vtkActor* ball, vtkAssembly*) {
          vtkSphereSource::SafeDownCast(ball->GetMapper()->GetInputAlgorithm())->SetRadius(0.3);
        }) },
    { "AssemblyTurned",
      OfPart([](vtkActor*, vtkAssembly* inner) { inner->AddPosition(0.4, 0.0, 0.0); }) },
    { "PartRemoved", OfPart([](vtkActor* ball, vtkAssembly* inner) { inner->RemovePart(ball); }) },
    { "PartPlane", PlaneOfPart },
    { "CastsKey", OfKey(vtkShadowCasters::CASTS_SHADOW()) },
    { "ReceivesKey", OfKey(vtkShadowCasters::RECEIVES_SHADOW()) },
  };
  const std::vector<ChangeInPlace> properties = ChangesOfProperties();
  changes.insert(changes.end(), properties.begin(), properties.end());
  return changes;
}

//------------------------------------------------------------------------------
const std::vector<ChangeInPlace>& AllChangesOfColors()
{
  static const auto red = [](vtkProperty* property) { property->SetColor(1.0, 0.0, 0.0); };
  static const std::vector<ChangeInPlace> changes = {
    { "Surface", OfProperty(Nothing, red) },
    { "Wires", OfProperty([](vtkProperty* p) { p->SetRepresentationToWireframe(); }, red) },
    { "Specular", OfProperty(Nothing, [](vtkProperty* p) { p->SetSpecular(0.5); }) },
    { "Part", OfPart([](vtkActor* ball, vtkAssembly*) { red(ball->GetProperty()); }) },
    { "Scalars",
      OfBall(
        [](vtkActor* ball)
        {
          ball->GetMapper()->Update();
          auto* data = vtkPolyData::SafeDownCast(ball->GetMapper()->GetInputDataObject(0, 0));
          vtkNew<vtkFloatArray> scalars;
          scalars->SetNumberOfTuples(data->GetNumberOfPoints());
          scalars->FillComponent(0, 0.5);
          data->GetPointData()->SetScalars(scalars);
        }) },
  };
  return changes;
}

}
