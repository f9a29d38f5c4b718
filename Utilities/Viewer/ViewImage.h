// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A picture over the scene, pixel by pixel, below the menu.
 */

#ifndef ViewImage_h
#define ViewImage_h

#include "vtkActor2D.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <vector>

class vtkRenderer;

namespace softshadows
{

class ViewImage
{
public:
  /// The renderer must outlive the image.
  explicit ViewImage(vtkRenderer* renderer);
  ~ViewImage();
  ViewImage(const ViewImage&) = delete;
  ViewImage& operator=(const ViewImage&) = delete;

  /// RGB bytes, top row first; of the renderer's size.
  void Show(const std::vector<unsigned char>& rgb, int width, int height);
  void Hide();

private:
  vtkRenderer* Renderer;
  vtkNew<vtkImageData> Image;
  vtkNew<vtkActor2D> Actor;
};

}

#endif
