// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowShader.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkShadowBands.h"
#include "vtkShadowFailures.h"
#include "vtkSoftShadowsOpenGL.h"

#include "vtkShadowBlocker.h"
#include "vtkShadowCrease.h"
#include "vtkShadowDepthMap.h"
#include "vtkShadowFootprint.h"
#include "vtkShadowFullscreenVS.h"
#include "vtkShadowKernel.h"
#include "vtkShadowLight.h"
#include "vtkShadowPointSums.h"
#include "vtkShadowProof.h"
#include "vtkShadowReceiver.h"
#include "vtkShadowSamples.h"
#include "vtkShadowSurface.h"

#include <set>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
const std::string IncludeMark = "//SoftShadows::Include ";

const char* FindSnippet(const std::string& name)
{
  const std::pair<const char*, const char*> snippets[] = {
    { "vtkShadowBlocker", vtkShadowBlocker },
    { "vtkShadowCrease", vtkShadowCrease },
    { "vtkShadowDepthMap", vtkShadowDepthMap },
    { "vtkShadowFootprint", vtkShadowFootprint },
    { "vtkShadowKernel", vtkShadowKernel },
    { "vtkShadowLight", vtkShadowLight },
    { "vtkShadowPointSums", vtkShadowPointSums },
    { "vtkShadowProof", vtkShadowProof },
    { "vtkShadowReceiver", vtkShadowReceiver },
    { "vtkShadowSamples", vtkShadowSamples },
    { "vtkShadowSurface", vtkShadowSurface },
  };
  for (const auto& snippet : snippets)
  {
    if (name == snippet.first)
    {
      return snippet.second;
    }
  }
  return nullptr;
}

void Include(std::ostream& out, const std::string& text, std::set<std::string>& included)
{
  std::istringstream lines(text);
  std::string line;
  while (std::getline(lines, line))
  {
    if (line.compare(0, IncludeMark.size(), IncludeMark) != 0)
    {
      out << line << "\n";
      continue;
    }
    const std::string name = line.substr(IncludeMark.size());
    if (!included.insert(name).second)
    {
      continue;
    }
    if (const char* snippet = FindSnippet(name))
    {
      Include(out, snippet, included);
    }
    else
    {
      out << "#error unknown snippet " << name << "\n";
    }
  }
}
} // namespace

//------------------------------------------------------------------------------
vtkShadowShader::vtkShadowShader(const char* text)
  : Text(text)
  , Watch(
      [this](vtkOpenGLRenderWindow*)
      {
        if (this->VertexArray)
        {
          this->VertexArray->ReleaseGraphicsResources();
          this->VertexArray = nullptr;
        }
        this->Program = nullptr;
      })
{
}

//------------------------------------------------------------------------------
vtkShadowShader::~vtkShadowShader() = default;

//------------------------------------------------------------------------------
vtkShadowShader::Definitions vtkShadowShader::CommonDefinitions()
{
  return { { "SOFT_SHADOW_STAGE_SHADE", std::to_string(VTK_SOFT_SHADOW_STAGE_SHADE) },
    { "SOFT_SHADOW_STAGE_RECEIVE", std::to_string(VTK_SOFT_SHADOW_STAGE_RECEIVE) },
    { "SOFT_SHADOW_SURFACE", std::to_string(VTK_SOFT_SHADOW_SURFACE) + ".0" },
    { "SOFT_SHADOW_RECEIVES", std::to_string(VTK_SOFT_SHADOW_RECEIVES) + ".0" },
    { "SOFT_SHADOW_FIRST_NORMAL", std::to_string(VTK_SOFT_SHADOW_FIRST_NORMAL) + ".0" },
    { "SOFT_SHADOW_NORMAL_STEPS", std::to_string(VTK_SOFT_SHADOW_NORMAL_STEPS) + ".0" },
    { "SOFT_SHADOW_SAMPLES_PER_DRAW", std::to_string(VTK_SOFT_SHADOW_SAMPLES_PER_DRAW) } };
}

//------------------------------------------------------------------------------
std::string vtkShadowShader::Compose(const char* text, const Definitions& definitions)
{
  std::ostringstream defines;
  for (const Definitions& list : { CommonDefinitions(), definitions })
  {
    for (const auto& definition : list)
    {
      defines << "#define " << definition.first << " " << definition.second << "\n";
    }
  }
  std::ostringstream composed;
  std::set<std::string> included;
  Include(composed, text, included);
  std::string source = composed.str();
  const std::string mark = "//VTK::System::Dec\n";
  const size_t position = source.find(mark);
  source.insert(position == std::string::npos ? 0 : position + mark.size(), defines.str());
  return source;
}

//------------------------------------------------------------------------------
void vtkShadowShader::SetDefinitions(const Definitions& definitions)
{
  if (this->Defined != definitions)
  {
    this->Defined = definitions;
    this->Program = nullptr;
  }
}

//------------------------------------------------------------------------------
bool vtkShadowShader::Use(vtkOpenGLRenderWindow* window)
{
  this->Watch.Enter(window);
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  if (this->Program)
  {
    return cache->ReadyShaderProgram(this->Program) != nullptr;
  }
  const std::string source = vtkShadowShader::Compose(this->Text, this->Defined);
  this->Program = cache->ReadyShaderProgram(vtkShadowFullscreenVS, source.c_str(), "");
  ++this->NumberOfBuilds;
  if (!this->VertexArray)
  {
    this->VertexArray = vtkSmartPointer<vtkOpenGLVertexArrayObject>::New();
  }
  if (!this->Program)
  {
    vtkShadowFailures::Report("a shader does not compile");
  }
  return this->Program != nullptr;
}

//------------------------------------------------------------------------------
void vtkShadowShader::Draw(double tapsPerPixel)
{
  if (vtkShadowFailures::IsFailing())
  {
    return;
  }
  this->VertexArray->Bind();
  vtkShadowBands::Draw(
    this->Watch.GetWindow(), tapsPerPixel, [] { glDrawArrays(GL_TRIANGLES, 0, 3); });
  this->VertexArray->Release();
}

//------------------------------------------------------------------------------
void vtkShadowShader::ReleaseGraphicsResources(vtkWindow*)
{
  this->Watch.Free();
}
VTK_ABI_NAMESPACE_END
