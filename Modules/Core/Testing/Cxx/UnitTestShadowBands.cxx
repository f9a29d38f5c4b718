// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Long work in bands: how many, and that every pixel is drawn once.

#include "OffscreenWindow.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShadowBands.h"
#include "vtkShadowFramebuffer.h"
#include "vtkShadowShader.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

using namespace SoftShadowsTesting;

TEST(ShadowBands, AreAsManyAsTheWorkNeeds)
{
  // Usual work is one draw: 15 x 15 and 21 x 21 taps of a large window, 29 x 29 and 41 x 41 of a small one.
  EXPECT_EQ(vtkShadowBands::GetRows(1920, 1080, 666.0), 1080);
  EXPECT_EQ(vtkShadowBands::GetRows(1280, 720, 2522.0), 720);
  EXPECT_EQ(vtkShadowBands::GetRows(1920, 1080, 0.0), 1080);
  for (const double taps : { 2522.0, 8192.0, 32258.0, 1e6, 1e9 })
  {
    const int rows = vtkShadowBands::GetRows(3840, 2160, taps);
    EXPECT_TRUE(rows == 1 || 3840.0 * rows * taps <= 4e9) << taps;
    EXPECT_TRUE(rows == 1 || 2.0 * 3840.0 * (rows + 8) * taps > 4e9) << taps << ": in vain";
    EXPECT_GE(rows, 1) << taps;
    EXPECT_LT(rows, 2160) << taps;
  }
}

class ShadowBandsOfWindow : public testing::Test
{
public:
  ShadowBandsOfWindow()
    : Window(16, 16)
  {
    this->Window.Render();
    this->GL = this->Window.GetOpenGL();
    this->GL->MakeCurrent();
  }
  ~ShadowBandsOfWindow() override { vtkShadowBands::SetMostTaps(0.0); }

  OffscreenWindow Window;
  vtkOpenGLRenderWindow* GL = nullptr;
};

TEST_F(ShadowBandsOfWindow, DrawEveryPixelOnceAndRestoreTheScissor)
{
  constexpr int Width = 40;
  constexpr int Height = 37;
  vtkOpenGLState* state = this->GL->GetState();
  vtkNew<vtkShadowTextureArray> target;
  ASSERT_TRUE(target->Allocate(this->GL, vtkShadowTextureArray::R32F, Width, Height, 1));
  vtkShadowShader shader("//VTK::System::Dec\n//VTK::Output::Dec\n"
                         "void main() { gl_FragData[0] = vec4(1.0); }\n");
  for (const bool hasScissor : { false, true })
  {
    int least = 0;
    for (const double taps : { 0.0, 10.0, 40.0, 1e5 })
    {
      vtkShadowBands::SetMostTaps(10.0 * Width * Height);
      state->Push();
      state->PushFramebufferBindings();
      vtkShadowFramebuffer framebuffer;
      framebuffer.Bind(this->GL);
      target->AttachLayer(0);
      vtkShadowFramebuffer::SetDrawBuffers(this->GL, 1);
      state->vtkglViewport(0, 0, Width, Height);
      state->vtkglDisable(GL_DEPTH_TEST);
      state->vtkglDisable(GL_SCISSOR_TEST);
      state->vtkglEnable(GL_BLEND);
      state->vtkglBlendFunc(GL_ONE, GL_ONE);
      const float zero[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
      glClearBufferfv(GL_COLOR, 0, zero);
      state->vtkglScissor(3, 5, 20, 17);
      hasScissor ? state->vtkglEnable(GL_SCISSOR_TEST) : state->vtkglDisable(GL_SCISSOR_TEST);
      ASSERT_TRUE(shader.Use(this->GL));
      const vtkTypeInt64 before = vtkShadowBands::GetNumberOfDraws();
      shader.Draw(taps);
      const int draws = static_cast<int>(vtkShadowBands::GetNumberOfDraws() - before);
      std::array<GLint, 4> box;
      glGetIntegerv(GL_SCISSOR_BOX, box.data());
      EXPECT_EQ(box, (std::array<GLint, 4>{ { 3, 5, 20, 17 } }));
      EXPECT_EQ(glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE, hasScissor);
      state->PopFramebufferBindings();
      framebuffer.Release();
      state->Pop();
      if (taps <= 10.0)
      {
        EXPECT_EQ(draws, 1) << taps;
      }
      else
      {
        EXPECT_GT(draws, least) << taps;
      }
      least = draws;
      const std::vector<float> pixels = target->ReadLayer(0);
      for (int y = 0; y < Height; ++y)
      {
        for (int x = 0; x < Width; ++x)
        {
          const bool isInside = !hasScissor || (x >= 3 && x < 23 && y >= 5 && y < 22);
          ASSERT_EQ(pixels[y * Width + x], isInside ? 1.0f : 0.0f)
            << x << ", " << y << ", taps " << taps << ", scissor " << hasScissor;
        }
      }
    }
  }
}
