// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What lies beyond a map's border or the screen's is told by arithmetic: samplers do not matter.
#include "ImageComparison.h"
#include "Scenes.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkAreaLight.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowDriver.h"
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowsOpenGL.h"

#include <gtest/gtest.h>

using namespace SoftShadowsTesting;

namespace
{

//------------------------------------------------------------------------------
/// While one lives, every unit samples its texture in this way, whatever the texture says.
class SamplerOfAllUnits
{
public:
  SamplerOfAllUnits(vtkOpenGLRenderWindow* window, GLint wrap, float border)
    : Window(window)
  {
    this->Window->MakeCurrent();
    const float color[4] = { border, border, border, border };
    glGenSamplers(1, &this->Sampler);
    glSamplerParameteri(this->Sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(this->Sampler, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glSamplerParameteri(this->Sampler, GL_TEXTURE_WRAP_S, wrap);
    glSamplerParameteri(this->Sampler, GL_TEXTURE_WRAP_T, wrap);
    glSamplerParameterfv(this->Sampler, GL_TEXTURE_BORDER_COLOR, color);
    this->Bind(this->Sampler);
  }
  ~SamplerOfAllUnits()
  {
    this->Window->MakeCurrent();
    this->Bind(0);
    glDeleteSamplers(1, &this->Sampler);
  }
  SamplerOfAllUnits(const SamplerOfAllUnits&) = delete;
  SamplerOfAllUnits& operator=(const SamplerOfAllUnits&) = delete;

private:
  void Bind(GLuint sampler) const
  {
    GLint units = 0;
    glGetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units);
    for (GLint unit = 0; unit < units; ++unit)
    {
      glBindSampler(static_cast<GLuint>(unit), sampler);
    }
  }

  vtkOpenGLRenderWindow* Window;
  GLuint Sampler = 0;
};

class MapBorders : public testing::TestWithParam<Technique>
{
protected:
  /// A pass that has drawn nothing yet.
  vtkSmartPointer<vtkSoftShadowPass> MakePass(int mapSize) const
  {
    auto pass = this->GetParam().Make(Effort::Quick, Weights::Mean);
    pass->SetMapSize(mapSize);
    return pass;
  }
};

}

//------------------------------------------------------------------------------
// Maps end where their casters do, and kernels reach over their borders.
TEST_P(MapBorders, AreNotTheSamplersBusiness)
{
  for (const NamedScene& named : ClosedFormScenes())
  {
    const Scene scene = named.Make(Placement());
    for (const int mapSize : { 256, 333 })
    {
      Stage stage(scene.Renderer, this->MakePass(mapSize), 100, 75);
      const Picture expected = stage.RenderVisibility(scene.Light);
      vtkOpenGLRenderWindow* window = stage.GetWindow().GetOpenGL();
      if (!vtkShadowDriver::HasVersion(3, 3) &&
        !vtkShadowDriver::HasExtension("GL_ARB_sampler_objects"))
      {
        GTEST_SKIP() << "no sampler objects";
      }
      // A map holds -d: 1 is a blocker at the near plane, -1 lies farther than anything.
      for (const float border : { 0.0f, 1.0f, -1.0f })
      {
        const SamplerOfAllUnits sampler(window, GL_CLAMP_TO_BORDER, border);
        stage.SetPass(this->MakePass(mapSize));
        EXPECT_TRUE(Matches(stage.RenderVisibility(scene.Light), expected, Identical))
          << named.Name << ", maps of " << mapSize << ", border " << border;
      }
      const SamplerOfAllUnits sampler(window, GL_CLAMP_TO_EDGE, 0.0f);
      stage.SetPass(this->MakePass(mapSize));
      EXPECT_TRUE(Matches(stage.RenderVisibility(scene.Light), expected, Identical))
        << named.Name << ", maps of " << mapSize << ", clamped to the edge";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, MapBorders, testing::ValuesIn(EveryTechnique()), NameOfTechnique);
