// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowMapperHooks.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasters.h"
#include "vtkShadowShader.h"
#include "vtkSoftShadowLights.h"

#include "vtkSoftShadowMapperBend.h"
#include "vtkSoftShadowMapperDec.h"
#include "vtkSoftShadowMapperReceive.h"
#include "vtkSoftShadowMapperSmooth.h"
#include "vtkSoftShadowMapperSteps.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
const char* const BendMark = "//SoftShadows::Bend\n";
const char* const SmoothMark = "//SoftShadows::Smooth\n";
const char* const StepsMark = "//SoftShadows::Steps\n";
const char* const ReceiveMark = "//SoftShadows::Receive\n";
const char* const ShadeMark = "//SoftShadows::Shade\n";

bool Contains(const std::string& text, const char* part)
{
  return text.find(part) != std::string::npos;
}

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
// What smooth receivers need, where vertices have normals.
void PutBend(
  std::string& vertexShader, const std::string& geometryShader, std::string& fragmentShader)
{
  // A geometry shader would have to hand it on.
  const std::string normal = "out vec3 normalVCVSOutput;";
  const bool bends = geometryShader.empty() && Contains(fragmentShader, SmoothMark) &&
    Contains(vertexShader, BendMark) && Contains(vertexShader, normal.c_str()) &&
    Contains(vertexShader, "out vec4 vertexVCVSOutput;");
  vtkShaderProgram::Substitute(vertexShader, BendMark, bends ? vtkSoftShadowMapperBend : "", false);
  vtkShaderProgram::Substitute(
    fragmentShader, SmoothMark, bends ? vtkSoftShadowMapperSmooth : "", false);
  if (bends)
  {
    vtkShaderProgram::Substitute(
      vertexShader, normal, normal + "\nout vec4 softShadowBend;", false);
  }
}

// Whether the position is not that of the triangle, as in VTK's sphere and stick mappers.
bool MovesPosition(const std::string& fragmentShader)
{
  return Contains(fragmentShader, "vertexVC.xyz =");
}

// Whether some fragment's depth is neither that of its triangle nor that of vertexVC. Offsets for
// coincident topology settle which of two surfaces is seen and move neither of them.
bool MovesDepth(const std::string& fragmentShader)
{
  if (MovesPosition(fragmentShader))
  {
    return false; // which keep both together
  }
  const std::string assignment = "gl_FragDepth =";
  for (size_t at = fragmentShader.find(assignment); at != std::string::npos;
       at = fragmentShader.find(assignment, at + 1))
  {
    const std::string statement = fragmentShader.substr(at, fragmentShader.find(';', at) - at);
    if (!Contains(statement, "cOffset"))
    {
      return true;
    }
  }
  return false;
}

// What the receivers' code has to know of the fragment it is in.
std::string ReceiveDefinitions(const std::string& fragmentShader)
{
  // VTK throws fragments away behind the lights.
  const std::string definitions =
    Contains(fragmentShader, "float opacity =") ? "#define SOFT_SHADOW_OPACITY opacity\n" : "";
  const std::string depth = MovesDepth(fragmentShader) ? "#define SOFT_SHADOW_MOVED_DEPTH\n" : "";
  if (Contains(fragmentShader, "primitiveSize == 1"))
  {
    // One program for surfaces, points and lines, which uniforms tell apart.
    return definitions + depth +
      "#define SOFT_SHADOW_SPHERE (renderPointsAsSpheres == 1 && primitiveSize == 1)\n";
  }
  if (Contains(fragmentShader, "uniform float ZCalcR;") &&
    Contains(fragmentShader, "vec3 normalVCVSOutput"))
  {
    // VTK's lines as tubes and points as spheres.
    return definitions +
      (Contains(fragmentShader, "in vec3 tubeBasis2;") ? "#define SOFT_SHADOW_TUBE\n"
                                                       : "#define SOFT_SHADOW_SPHERE true\n");
  }
  return definitions + depth;
}
} // namespace

//------------------------------------------------------------------------------
void vtkSoftShadowMapperHooks::SetLights(const vtkSoftShadowLights& lights)
{
  this->Layers.clear();
  this->Attenuations.clear();
  for (const vtkSoftShadowLights::LitLight& lit : lights)
  {
    this->Layers.push_back(lit.Layer);
    this->Attenuations.push_back(std::min(std::max(0.0f, lit.Light->GetShadowAttenuation()), 1.0f));
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowMapperHooks::SetCamera(vtkRenderer* renderer)
{
  vtkMatrix4x4* projection = renderer->GetActiveCamera()->GetProjectionTransformMatrix(
    renderer->GetTiledAspectRatio(), -1.0, 1.0);
  for (int i = 0; i < 2; ++i)
  {
    this->DepthToView[2 * i] = static_cast<float>(projection->GetElement(2 + i, 2));
    this->DepthToView[2 * i + 1] = static_cast<float>(projection->GetElement(2 + i, 3));
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowMapperHooks::PreReplace(
  std::string& vertexShader, std::string& fragmentShader, vtkProp* prop) const
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
    fragmentShader, "//VTK::Light::Dec", declarations + SmoothMark + "//VTK::Light::Dec", false);
  const std::string position = "//VTK::PositionVC::Impl";
  vtkShaderProgram::Substitute(vertexShader, position, position + "\n" + BendMark, false);
  const std::string flow = "//VTK::UniformFlow::Impl";
  vtkShaderProgram::Substitute(fragmentShader, flow, StepsMark + flow, false);
  vtkShaderProgram::Substitute(
    fragmentShader, light, (late ? "" : ReceiveMark) + std::string(ShadeMark) + light, false);
  if (late)
  {
    vtkShaderProgram::Substitute(fragmentShader, picking, picking + "\n" + ReceiveMark, false);
  }
}

//------------------------------------------------------------------------------
std::string vtkSoftShadowMapperHooks::PostReplace(
  std::string& vertexShader, const std::string& geometryShader, std::string& fragmentShader)
{
  PutBend(vertexShader, geometryShader, fragmentShader);
  // Surfaces that are not lit need no shadows.
  const bool usesLights = fragmentShader.find("lightColor") != std::string::npos;
  const bool isDeclared = fragmentShader.find("softShadowFactor(") != std::string::npos;
  const bool hasPosition = fragmentShader.find("vec4 vertexVC") != std::string::npos;
  const std::string lights = isDeclared ? ShadeLights(fragmentShader) : std::string();
  const std::string receive = isDeclared && hasPosition
    ? ReceiveDefinitions(fragmentShader) + vtkSoftShadowMapperReceive
    : std::string();
  // A position or depth that is moved is known later, as are the steps.
  const std::string steps = !receive.empty() && !MovesPosition(fragmentShader) &&
      !Contains(receive, "#define SOFT_SHADOW_MOVED_DEPTH")
    ? vtkSoftShadowMapperSteps
    : "";
  vtkShaderProgram::Substitute(fragmentShader, StepsMark, steps, false);
  const bool receives = vtkShaderProgram::Substitute(fragmentShader, ReceiveMark, receive, false);
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
  if (program->IsUniformUsed("softShadowDepthToView"))
  {
    program->SetUniform4f("softShadowDepthToView", this->DepthToView);
  }
  program->SetUniformf("softShadowReceives",
    static_cast<float>(receives ? VTK_SOFT_SHADOW_RECEIVES : VTK_SOFT_SHADOW_SURFACE));
  if (program->IsUniformUsed("softShadowLargestRise"))
  {
    const double rise = this->Casters ? this->Casters->GetLargestRise(prop) : VTK_FLOAT_MAX;
    program->SetUniformf(
      "softShadowLargestRise", static_cast<float>(std::min<double>(rise, VTK_FLOAT_MAX)));
  }
  if (program->IsUniformUsed("softShadowSmooth"))
  {
    program->SetUniformi("softShadowSmooth", this->Smooth ? 1 : 0);
  }
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
