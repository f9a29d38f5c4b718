// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// A VTK or a mapper whose shaders lack what shadows are put in by: one warning names the mapper.
#include "Faults.h"
#include "Techniques.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

#include <string>

using namespace SoftShadowsTesting;

namespace
{

/// What a mapper's fragment shader is before and after the mapper's own replacements.
struct Text
{
  std::string Declarations = "//VTK::Light::Dec\n";
  std::string Lighting = "//VTK::Light::Impl\n";
  std::string Position = "in vec4 vertexVC;\n";
  std::string LightColor = "uniform vec3 lightColor0;\n";
  std::string Use = "color *= lightColor0;\n";
};

//------------------------------------------------------------------------------
std::string Prepare(vtkSoftShadowPass* pass, vtkPolyDataMapper* mapper, const Text& text)
{
  vtkNew<vtkActor> actor;
  std::string vertex;
  std::string geometry;
  std::string fragment = text.Position + text.Declarations + "void main()\n{\n" + text.Lighting +
    "//VTK::Picking::Impl\n}\n";
  pass->PreReplaceShaderValues(vertex, geometry, fragment, mapper, actor);
  const std::size_t place = fragment.find("void main()");
  fragment.insert(place, text.LightColor);
  fragment.insert(fragment.rfind('}'), text.Use);
  pass->PostReplaceShaderValues(vertex, geometry, fragment, mapper, actor);
  return fragment;
}

/// Whether shadows are in it.
bool HasShadows(const std::string& fragment)
{
  return fragment.find("#define lightColor0 shadowed0") != std::string::npos;
}

}

//------------------------------------------------------------------------------
TEST(MapperMarks, ThatAreThereGiveShadows)
{
  const auto pass = AllTechniques().front().Make(Effort::Quick, Weights::Mean);
  vtkNew<vtkPolyDataMapper> mapper;
  Messages messages;
  EXPECT_TRUE(HasShadows(Prepare(pass, mapper, Text())));
  EXPECT_EQ(messages.Get(), "");
}

//------------------------------------------------------------------------------
TEST(MapperMarks, ThatAreMissingAreToldOnce)
{
  Text texts[4];
  texts[0].Lighting = "//VTK::Lighting::Impl\n";
  texts[1].Declarations = "//VTK::Lighting::Dec\n";
  texts[2].LightColor = "uniform vec3 lightColors[6];\n";
  texts[2].Use = "color *= lightColors[0];\n";
  texts[3].Position = "in vec3 positionVC;\n";
  for (const Text& text : texts)
  {
    const auto pass = AllTechniques().front().Make(Effort::Quick, Weights::Mean);
    vtkNew<vtkPolyDataMapper> mapper;
    Messages messages;
    Prepare(pass, mapper, text);
    Prepare(pass, mapper, text);
    EXPECT_EQ(messages.Count("No shadow falls on what"), 1) << messages.Get();
    EXPECT_EQ(messages.Count(mapper->GetClassName()), 1) << messages.Get();
  }
}

//------------------------------------------------------------------------------
TEST(MapperMarks, AreNotMissedWhereNothingIsLit)
{
  const auto pass = AllTechniques().front().Make(Effort::Quick, Weights::Mean);
  vtkNew<vtkPolyDataMapper> mapper;
  Messages messages;
  Text unlit;
  unlit.LightColor = unlit.Use = "";
  Prepare(pass, mapper, unlit);
  unlit.Position = unlit.Lighting = unlit.Declarations = "";
  Prepare(pass, mapper, unlit);
  EXPECT_EQ(messages.Get(), "");
}
