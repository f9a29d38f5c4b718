// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewImage.h"

#include "PassImages.h"

#include "vtkImageMapper.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace softshadows
{

//--------------------------------------------------------------------------------------------------
ViewImage::ViewImage(vtkRenderer* renderer)
  : Renderer(renderer)
{
  vtkNew<vtkImageMapper> mapper;
  mapper->SetInputData(this->Image);
  mapper->SetColorWindow(255.0); // bytes as they are
  mapper->SetColorLevel(127.5);
  this->Actor->SetMapper(mapper);
  this->Actor->SetVisibility(false);
  this->Renderer->AddViewProp(this->Actor);
}

//--------------------------------------------------------------------------------------------------
ViewImage::~ViewImage()
{
  this->Renderer->RemoveViewProp(this->Actor);
}

//--------------------------------------------------------------------------------------------------
void ViewImage::Show(const std::vector<unsigned char>& rgb, int width, int height)
{
  this->Image->SetDimensions(width, height, 1);
  this->Image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  // VTK's images start at the bottom: the same turn again.
  const std::vector<unsigned char> turned = TopRowFirst(rgb.data(), 3 * width, height);
  std::copy(
    turned.begin(), turned.end(), static_cast<unsigned char*>(this->Image->GetScalarPointer()));
  this->Image->Modified();
  this->Actor->SetVisibility(true);
}

//--------------------------------------------------------------------------------------------------
void ViewImage::Hide()
{
  this->Actor->SetVisibility(false);
}

}
