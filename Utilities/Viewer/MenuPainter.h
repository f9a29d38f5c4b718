// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Draws a MenuLayout in a renderer of its own above the scene.
 */

#ifndef MenuPainter_h
#define MenuPainter_h

#include "MenuLayout.h"

#include "vtkActor2D.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTextActor.h"

#include <vector>

class vtkRenderer;

namespace softshadows
{

class MenuPainter
{
public:
  /// The renderer must outlive the painter.
  explicit MenuPainter(vtkRenderer* renderer);
  ~MenuPainter();
  MenuPainter(const MenuPainter&) = delete;
  MenuPainter& operator=(const MenuPainter&) = delete;

  /// Takes over what the layout says; drawn with the renderer's next frame.
  void Update(const MenuLayout& layout);

  void SetVisible(bool visible);

private:
  vtkRenderer* Renderer;
  vtkNew<vtkPolyData> Grounds;
  vtkNew<vtkActor2D> GroundActor;
  std::vector<vtkSmartPointer<vtkTextActor>> Texts; ///< As many as were ever needed.
  std::size_t UsedTexts = 0;
  bool Visible = true;

  void AddGround(const MenuBox& box);
  void AddText(const MenuBox& box, int font);
};

}

#endif
