// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PictureFile.h"

#include "ImageFile.h"

namespace softshadows
{

//--------------------------------------------------------------------------------------------------
void WritePicture(
  const std::string& path, int width, int height, const std::vector<unsigned char>& rgb)
{
  const OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::UINT8);
  WriteImageFile(path, spec, OIIO::TypeDesc::UINT8, rgb.data());
}

}
