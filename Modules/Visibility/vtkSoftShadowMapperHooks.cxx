// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowMapperHooks.h"

#include "vtkActor.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasters.h"
#include "vtkShadowShader.h"

#include "vtkSoftShadowMapperDec.h"
#include "vtkSoftShadowMapperReceive.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
const char* const ReceiveMark = "//SoftShadows::Receive\n";
const char* const ShadeMark = "//SoftShadows::Shade\n";

// Textures may discard fragments, behind the lights.
bool HasTextures(vtkProp* prop)
{
  vtkActor* actor = vtkActor::SafeDownCast(prop);
  return actor && (actor->GetTexture() || actor->GetProperty()->GetNumberOfTextures() > 0);
}

std::string ShadeLights(const std::string& fragmentShader)
{
  std::string code;
  for (int light = 0;; ++light)
  {
    const std::string number = std::to_string(light);
    const std::string color = "lightColor" + number;
    if (fragmentShader.find("uniform vec3 " + color + ";") == std::string::npos)
    {
      return code;
    }
    code.append("  vec3 shadowed").append(number).append(" = ").append(color);
    code.append(" * softShadowFactor(").append(number).append(");\n");
    code.append("#define ").append(color).append(" shadowed").append(number).append("\n");
  }
}
} // namespace

//------------------------------------------------------------------------------
void vtkSoftShadowMapperHooks::PreReplace(std::string& fragmentShader, vtkProp* prop) const
{
  const size_t lights = std::max<size_t>(this->Layers.size(), 1);
  std::string declarations;
  for (const auto& definition : vtkShadowShader::CommonDefinitions())
  {
    declarations += "#define " + definition.first + " " + definition.second + "\n";
  }
  declarations += "#define SOFT_SHADOW_LIGHTS " + std::to_string(lights) + "\n";
  declarations += vtkSoftShadowMapperDec;
  const std::string light = "//VTK::Light::Impl";
  const std::string picking = "//VTK::Picking::Impl";
  const bool late = HasTextures(prop);
  vtkShaderProgram::Substitute(
    fragmentShader, "//VTK::Light::Dec", declarations + "//VTK::Light::Dec", false);
  vtkShaderProgram::Substitute(
    fragmentShader, light, (late ? "" : ReceiveMark) + std::string(ShadeMark) + light, false);
  if (late)
  {
    vtkShaderProgram::Substitute(fragmentShader, picking, picking + "\n" + ReceiveMark, false);
  }
}

//------------------------------------------------------------------------------
std::string vtkSoftShadowMapperHooks::PostReplace(std::string& fragmentShader)
{
  // Surfaces that are not lit need no shadows.
  const bool usesLights = fragmentShader.find("lightColor") != std::string::npos;
  const bool isDeclared = fragmentShader.find("softShadowFactor(") != std::string::npos;
  const bool hasPosition = fragmentShader.find("vec4 vertexVC") != std::string::npos;
  const std::string lights = isDeclared ? ShadeLights(fragmentShader) : std::string();
  const bool receives = vtkShaderProgram::Substitute(fragmentShader, ReceiveMark,
    isDeclared && hasPosition ? vtkSoftShadowMapperReceive : "", false);
  const bool shades = vtkShaderProgram::Substitute(fragmentShader, ShadeMark, lights, false);
  if (!usesLights || (isDeclared && shades && receives && hasPosition && !lights.empty()))
  {
    return "";
  }
  return !isDeclared || !shades || !receives
    ? "one of VTK's marks for lights is missing in its program"
    : "its program has no lightColor0 or no vertexVC, as VTK's have";
}

//------------------------------------------------------------------------------
void vtkSoftShadowMapperHooks::SetUniforms(vtkShaderProgram* program, vtkProp* prop) const
{
  if (!program->IsUniformUsed("softShadowStage"))
  {
    return;
  }
  const bool receives = vtkShadowCasters::GetReceivesShadow(prop);
  program->SetUniformi("softShadowStage", this->Stage);
  program->SetUniformf("softShadowReceives",
    static_cast<float>(receives ? VTK_SOFT_SHADOW_RECEIVES : VTK_SOFT_SHADOW_SURFACE));
  if (program->IsUniformUsed("softShadowVisibility"))
  {
    program->SetUniform2i("softShadowOrigin", this->Origin);
    program->SetUniformi("softShadowVisibility", this->VisibilityUnit);
    program->SetUniform1iv(
      "softShadowLayers", static_cast<int>(this->Layers.size()), this->Layers.data());
    program->SetUniform1fv("softShadowAttenuations", static_cast<int>(this->Attenuations.size()),
      this->Attenuations.data());
  }
}
VTK_ABI_NAMESPACE_END
