// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GivenVisibilityPass.h"

#include "GivenVisibilityFS.h"

#include "vtkShadowShader.h"
#include "vtkSoftShadowServices.h"

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>

#include <cmath> // For pixels without a value

namespace softshadows
{

class GivenVisibilityPass::Internals
{
public:
  int Width = 0;
  int Height = 0;
  std::vector<std::vector<float>> Images; // bottom row first
  vtkShadowShader Shader{ GivenVisibilityFS };
};

//--------------------------------------------------------------------------------------------------
vtkStandardNewMacro(GivenVisibilityPass);

//--------------------------------------------------------------------------------------------------
GivenVisibilityPass::GivenVisibilityPass()
  : Impl(new Internals)
{
}

//--------------------------------------------------------------------------------------------------
GivenVisibilityPass::~GivenVisibilityPass() = default;

//--------------------------------------------------------------------------------------------------
void GivenVisibilityPass::SetVisibility(
  int width, int height, const std::vector<std::vector<float>>& images)
{
  this->Impl->Width = width;
  this->Impl->Height = height;
  this->Impl->Images.clear();
  for (const std::vector<float>& image : images)
  {
    std::vector<float> flipped;
    flipped.reserve(image.size());
    for (int row = height - 1; row >= 0; --row)
    {
      for (int column = 0; column < width; ++column)
      {
        const float value = image[static_cast<size_t>(row) * width + column];
        flipped.push_back(std::isnan(value) ? 1.0F : value);
      }
    }
    this->Impl->Images.push_back(std::move(flipped));
  }
  this->Modified();
}

//--------------------------------------------------------------------------------------------------
vtkSoftShadowRequirements GivenVisibilityPass::GetRequirements() const
{
  vtkSoftShadowRequirements requirements;
  requirements.EmitterMap = false;
  requirements.Proof = vtkSoftShadowRequirements::PROVES_NOTHING;
  return requirements;
}

//--------------------------------------------------------------------------------------------------
void GivenVisibilityPass::Add(const vtkSoftShadowServices& services)
{
  const auto light = static_cast<size_t>(services.Light);
  if (light >= this->Impl->Images.size() || !this->Impl->Shader.Use(services.Window))
  {
    return;
  }
  vtkNew<vtkTextureObject> texture;
  texture->SetContext(services.Window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->Create2DFromRaw(static_cast<unsigned int>(this->Impl->Width),
    static_cast<unsigned int>(this->Impl->Height), 1, VTK_FLOAT, this->Impl->Images[light].data());
  texture->Activate();
  vtkShaderProgram* program = this->Impl->Shader.GetProgram();
  program->SetUniformi("given", texture->GetTextureUnit());
  program->SetUniformf("weight", static_cast<float>(services.Emitter.Weight));
  services.DrawMarked(this->Impl->Shader);
  texture->Deactivate();
  texture->ReleaseGraphicsResources(services.Window);
}

//--------------------------------------------------------------------------------------------------
void GivenVisibilityPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Impl->Shader.ReleaseGraphicsResources(window);
}

}
