// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The shaders' kernel against the same in C++: every texel's overlap, drawn into a float texture.

#include "OffscreenWindow.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkShadowShader.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"
#include "vtkVirtualKernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace SoftShadowsTesting;

namespace
{
constexpr int Size = 48; // texels along an edge of the map

struct Case
{
  std::array<double, 2> Light;
  std::array<double, 2> U;
  std::array<double, 2> V;
  std::array<double, 2> Center;
  bool Disk = false;
  bool Gaussian = false;
  std::array<double, 4> Window = { { 0.0, 0.0, 1.0, 1.0 } };
};

const char* const Shader = R"(//VTK::System::Dec
//VTK::Output::Dec
//KERNEL
uniform vec2 lightExtent;
uniform vec4 footprint;
uniform vec2 center;
uniform int disk;
uniform int gaussian;
uniform vec4 window;

void main()
{
  vec3 variance = convolve(lightExtent, disk == 1, varianceOf(footprint.xy, footprint.zw));
  Kernel kernel = kernelOf(variance, vec2(1.0), gaussian == 1, window);
  vec2 texel = floor(gl_FragCoord.xy);
  vec2 along = kernel.transposed ? texel.yx : texel;
  Strip strip = stripOf(kernel, disk == 1, kernel.transposed ? center.yx : center, along.x);
  gl_FragData[0] = vec4(strip.width * texelOverlap(strip, along.y), kernel.along, kernel.lean,
    kernel.across);
}
)";

std::string ShaderText()
{
  std::string text = Shader;
  const std::string mark = "//KERNEL\n";
  return text.replace(text.find(mark), mark.size(), vtkVirtualKernel::GetShaderText());
}

// Draws cases one by one.
class KernelDrawing
{
public:
  KernelDrawing()
    : Window(32, 32)
    , Text(ShaderText())
    , Program(this->Text.c_str())
  {
    this->Window.Render();
    this->GL = vtkOpenGLRenderWindow::SafeDownCast(this->Window.Get());
    this->GL->MakeCurrent();
    this->Target->Allocate(this->GL, vtkShadowTextureArray::RGBA32F, Size, Size, 1);
    glGenFramebuffers(1, &this->Framebuffer);
  }

  ~KernelDrawing()
  {
    glDeleteFramebuffers(1, &this->Framebuffer);
    this->Target->ReleaseGraphicsResources(this->GL);
    this->Program.ReleaseGraphicsResources(this->GL);
  }

  // Per texel: overlap, half extent along, lean, half extent across. Empty if it does not compile.
  std::vector<float> Draw(const Case& shape)
  {
    vtkOpenGLState* state = this->GL->GetState();
    state->PushFramebufferBindings();
    state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
    this->Target->AttachLayer(0);
    state->vtkglDrawBuffer(GL_COLOR_ATTACHMENT0);
    state->vtkglViewport(0, 0, Size, Size);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_BLEND);
    state->vtkglDisable(GL_SCISSOR_TEST);
    const bool compiled = this->Program.Use(this->GL);
    if (compiled)
    {
      this->SetUniforms(this->Program.GetProgram(), shape);
      this->Program.Draw();
    }
    state->PopFramebufferBindings();
    return compiled ? this->Target->ReadLayer(0) : std::vector<float>();
  }

private:
  static void SetUniforms(vtkShaderProgram* program, const Case& shape)
  {
    const float light[2] = { static_cast<float>(shape.Light[0]),
      static_cast<float>(shape.Light[1]) };
    const float footprint[4] = { static_cast<float>(shape.U[0]), static_cast<float>(shape.U[1]),
      static_cast<float>(shape.V[0]), static_cast<float>(shape.V[1]) };
    const float center[2] = { static_cast<float>(shape.Center[0]),
      static_cast<float>(shape.Center[1]) };
    const float window[4] = { static_cast<float>(shape.Window[0]),
      static_cast<float>(shape.Window[1]), static_cast<float>(shape.Window[2]),
      static_cast<float>(shape.Window[3]) };
    program->SetUniform2f("lightExtent", light);
    program->SetUniform4f("footprint", footprint);
    program->SetUniform2f("center", center);
    program->SetUniform4f("window", window);
    program->SetUniformi("disk", shape.Disk ? 1 : 0);
    program->SetUniformi("gaussian", shape.Gaussian ? 1 : 0);
  }

  OffscreenWindow Window;
  std::string Text;
  vtkShadowShader Program;
  vtkOpenGLRenderWindow* GL = nullptr;
  vtkNew<vtkShadowTextureArray> Target;
  unsigned int Framebuffer = 0;
};

vtkVirtualKernel KernelOf(const Case& shape)
{
  vtkVirtualKernel kernel =
    vtkVirtualKernel::FromVariance(vtkVirtualKernel::Convolve(shape.Light, shape.Disk,
                                     vtkVirtualKernel::Variance(shape.U, shape.V)),
      shape.Disk, { { 1.0, 1.0 } });
  kernel.Gaussian = shape.Gaussian;
  kernel.Window = shape.Window;
  return kernel;
}

// Lights and footprints of all kinds, the degenerate ones first.
std::vector<Case> MakeCases()
{
  std::vector<Case> cases = {
    { { { 5.3, 3.7 } }, { { 0, 0 } }, { { 0, 0 } }, { { 24.3, 23.6 } } },
    { { { 0.0, 0.0 } }, { { 0, 0 } }, { { 0, 0 } }, { { 24.3, 23.6 } } },
    { { { 7.0, 0.0 } }, { { 0, 0 } }, { { 0, 0 } }, { { 24.3, 23.6 } } },
    { { { 0.0, 0.0 } }, { { 5.0, 2.0 } }, { { -2.5, -1.0 } }, { { 24.3, 23.6 } } },
    { { { 0.5, 0.5 } }, { { 1.0, 15.0 } }, { { 0.5, 0.0 } }, { { 24.3, 23.6 } } },
    { { { 9.0, 4.0 } }, { { 0, 0 } }, { { 0, 0 } }, { { 1.5, 46.8 } } },
  };
  std::mt19937 random(3);
  std::uniform_real_distribution<double> extent(0.05, 8.0);
  std::uniform_real_distribution<double> axis(-6.0, 6.0);
  std::uniform_real_distribution<double> center(0.0, Size);
  for (int i = 0; i < 40; ++i)
  {
    cases.push_back({ { { extent(random), extent(random) } }, { { axis(random), axis(random) } },
      { { axis(random), axis(random) } }, { { center(random), center(random) } } });
  }
  return cases;
}

// Kernels of both kinds and weights, a part of a light among them.
std::vector<Case> Variants(const Case& shape)
{
  std::vector<Case> variants;
  for (const bool disk : { false, true })
  {
    for (const bool gaussian : { false, true })
    {
      variants.push_back(shape);
      variants.back().Disk = disk;
      variants.back().Gaussian = gaussian;
    }
  }
  variants.push_back(shape);
  variants.back().Gaussian = true;
  variants.back().Window = { { -0.5, 0.25, 0.5, 0.25 } };
  return variants;
}
} // namespace

TEST(VirtualKernelShader, EqualsTheKernelInCxx)
{
  KernelDrawing drawing;
  int number = 0;
  for (const Case& shape : MakeCases())
  {
    for (const Case& variant : Variants(shape))
    {
      const vtkVirtualKernel kernel = KernelOf(variant);
      const std::vector<float> drawn = drawing.Draw(variant);
      ASSERT_EQ(drawn.size(), 4u * Size * Size);
      double worst = 0.0;
      for (int y = 0; y < Size; ++y)
      {
        for (int x = 0; x < Size; ++x)
        {
          const double expected = kernel.GetOverlap(variant.Center[0], variant.Center[1], x, y);
          worst = std::max(worst, std::abs(expected - drawn[4 * (y * Size + x)]));
        }
      }
      // Single precision: a part in 10^4 of the kernel or of a texel. A disk's chords come from an arc
      // tangent, which drivers approximate to about 10^-5.
      const double chords = variant.Disk ? 1e-5 * kernel.Along : 0.0;
      EXPECT_LE(worst, 1e-4 * std::min(kernel.GetArea(), 1.0) + chords + 1e-8)
        << "case " << number << " disk " << variant.Disk << " gaussian " << variant.Gaussian
        << " along " << drawn[1] << " " << kernel.Along << " lean " << drawn[2] << " "
        << kernel.Lean << " across " << drawn[3] << " " << kernel.Across;
    }
    ++number;
  }
}

TEST(VirtualKernelShader, MovesWithoutSteps)
{
  KernelDrawing drawing;
  const double step = 0.01; // texels
  for (const Case& shape : MakeCases())
  {
    for (Case variant : Variants(shape))
    {
      const vtkVirtualKernel kernel = KernelOf(variant);
      if (kernel.Across < 0.1 || kernel.Along + std::abs(kernel.Lean) > 0.4 * Size)
      {
        continue; // a line moves from texel to texel in one step; a wide one leaves the map
      }
      // Of the weighted area no more can change than what a step sweeps at the border.
      const double share =
        4.0 * step * (kernel.Along + kernel.Across + std::abs(kernel.Lean)) / kernel.GetArea();
      double before = -1.0;
      for (int i = 0; i < 12; ++i)
      {
        // Across the border of a texel, along s and t.
        variant.Center = { { 23.95 + i * step, 23.97 + 0.37 * i * step } };
        const std::vector<float> drawn = drawing.Draw(variant);
        ASSERT_EQ(drawn.size(), 4u * Size * Size);
        double sums[2] = { 0.0, 0.0 };
        for (int texel = 0; texel < Size * Size; ++texel)
        {
          // The worst map there is: a chessboard of single texels.
          const int isLit = (texel % Size + texel / Size) % 2;
          sums[0] += isLit * drawn[4 * texel];
          sums[1] += drawn[4 * texel];
        }
        const double now = sums[0] / sums[1];
        EXPECT_TRUE(i == 0 || std::abs(now - before) <= share + 1e-5)
          << "disk " << variant.Disk << " gaussian " << variant.Gaussian << " along "
          << kernel.Along << " across " << kernel.Across << " step " << i << ": " << before
          << " to " << now << ", share " << share;
        before = now;
      }
    }
  }
}

TEST(VirtualKernel, GaussianOverlapsSumToTheArea)
{
  for (Case shape : MakeCases())
  {
    shape.Center = { { 200.3, 199.6 } };
    for (const Case& variant : Variants(shape))
    {
      const vtkVirtualKernel kernel = KernelOf(variant);
      const auto everywhere = [](int, int) { return 1.0; };
      const double area =
        kernel.Filter(variant.Center[0], variant.Center[1], 400, 400, everywhere)[1];
      // A disk's strips are boxes of its mean chord, exact for uniform weights only: 2.4 % for one strip.
      const double tolerance = variant.Disk && variant.Gaussian ? 0.025 : 1e-4;
      EXPECT_NEAR(area / kernel.GetArea(), 1.0, tolerance)
        << "disk " << variant.Disk << " gaussian " << variant.Gaussian << " along " << kernel.Along;
    }
  }
}
