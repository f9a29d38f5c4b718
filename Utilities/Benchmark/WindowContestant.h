// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WindowContestant
 * @brief   A contestant that draws with OpenGL into an off-screen window of its own.
 */

#ifndef SoftShadowsBenchmark_WindowContestant_h
#define SoftShadowsBenchmark_WindowContestant_h

#include "Contestant.h"

#include <vtkSmartPointer.h>

class vtkRenderPass;
class vtkRenderWindow;

namespace softshadows
{

/// VTK's plain frame.
class WindowContestant : public Contestant
{
public:
  WindowContestant(const SceneFactory& makeScene, int width, int height);
  ~WindowContestant() override;

  void Draw(Motion motion, int frame) override;
  ColorImage GetPicture() override;

  vtkRenderer* GetRenderer() { return this->Renderer; }
  vtkRenderWindow* GetWindow() { return this->Window; }

private:
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
};

/// One of the techniques of this project.
class TechniqueContestant : public WindowContestant
{
public:
  TechniqueContestant(const SceneFactory& makeScene, int width, int height,
    const vtkSmartPointer<vtkSoftShadowPass>& pass);
  ~TechniqueContestant() override;

  std::vector<std::vector<float>> GetVisibility() override;
  std::vector<std::pair<std::string, double>> GetSteps() override;
  std::vector<std::pair<std::string, std::int64_t>> GetCounts() override;

private:
  vtkSmartPointer<vtkSoftShadowPass> Pass;
};

/// A step so small that no pixel changes, and no caller can take for none.
void MoveALittle(vtkRenderer* renderer, Motion motion, int frame);

}

#endif
