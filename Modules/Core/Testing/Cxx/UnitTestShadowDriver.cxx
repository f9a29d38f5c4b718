// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Who draws: names of drivers as they are met, and the driver at hand.

#include "OffscreenWindow.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShadowDriver.h"
#include "vtkSoftShadowsOpenGL.h"

#include <gtest/gtest.h>

#include <string>

using namespace SoftShadowsTesting;

TEST(ShadowDriver, KnowsWhoDrawsOnTheProcessor)
{
  for (const char* name :
    { "llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "zink (llvmpipe (LLVM 15.0.6, 256 bits))",
      "SWR (LLVM 11.0.1, 256 bits)", "Software Rasterizer", "Google SwiftShader", "GDI Generic",
      "D3D12 (Microsoft Basic Render Driver)", "Apple Software Renderer" })
  {
    EXPECT_TRUE(vtkShadowDriver::IsOfProcessor(name)) << name;
  }
  for (const char* name : { "", "NVIDIA GeForce RTX 4090/PCIe/SSE2", "NVIDIA H200/PCIe/SSE2",
         "AMD Radeon RX 6800 (navi21, LLVM 15.0.7, DRM 3.54, 6.1.0)",
         "Mesa Intel(R) UHD Graphics 620 (KBL GT2)", "zink (NVIDIA GeForce RTX 3060)", "V3D 4.2",
         "Apple M1", "D3D12 (Intel(R) Iris(R) Xe Graphics)", "Quadro P2200/PCIe/SSE2" })
  {
    EXPECT_FALSE(vtkShadowDriver::IsOfProcessor(name)) << name;
  }
}

class ShadowDriverOfWindow : public testing::Test
{
public:
  ShadowDriverOfWindow()
    : Window(16, 16)
  {
    this->Window.Render();
    this->Window.GetOpenGL()->MakeCurrent();
  }
  ~ShadowDriverOfWindow() override { vtkShadowDriver::Pretend(vtkShadowDriver::TOLD_BY_NAME); }

  OffscreenWindow Window;
};

TEST_F(ShadowDriverOfWindow, TellsItsKindUnlessATestPretendsAnother)
{
  const std::string name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const bool isProcessor = vtkShadowDriver::IsOfProcessor(name);
  EXPECT_EQ(vtkShadowDriver::DrawsOnProcessor(), isProcessor) << name;
  for (const bool pretended : { true, false })
  {
    vtkShadowDriver::Pretend(pretended ? vtkShadowDriver::PROCESSOR : vtkShadowDriver::CARD);
    EXPECT_EQ(vtkShadowDriver::DrawsOnProcessor(), pretended);
    // What vertices see is a matter of right and wrong.
    EXPECT_EQ(vtkShadowDriver::OrdersVertices(), !isProcessor) << name;
  }
  vtkShadowDriver::Pretend(vtkShadowDriver::TOLD_BY_NAME);
  EXPECT_EQ(vtkShadowDriver::DrawsOnProcessor(), isProcessor) << name;
}

TEST_F(ShadowDriverOfWindow, HasItsVersionAndItsExtensions)
{
  GLint version[2] = { 0, 0 };
  glGetIntegerv(GL_MAJOR_VERSION, &version[0]);
  glGetIntegerv(GL_MINOR_VERSION, &version[1]);
  EXPECT_TRUE(vtkShadowDriver::HasVersion(3, 2));
  EXPECT_TRUE(vtkShadowDriver::HasVersion(version[0], version[1]));
  EXPECT_TRUE(vtkShadowDriver::HasVersion(version[0] - 1, version[1] + 5));
  EXPECT_FALSE(vtkShadowDriver::HasVersion(version[0], version[1] + 1));
  EXPECT_FALSE(vtkShadowDriver::HasVersion(version[0] + 1, 0));
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  ASSERT_GT(count, 0);
  const std::string last =
    reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(count - 1)));
  EXPECT_TRUE(vtkShadowDriver::HasExtension(last)) << last;
  EXPECT_FALSE(vtkShadowDriver::HasExtension(last + "_of_the_future")) << last;
  EXPECT_FALSE(vtkShadowDriver::HasExtension(last.substr(0, last.size() - 1))) << last;
}
