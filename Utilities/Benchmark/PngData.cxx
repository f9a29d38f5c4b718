// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PngData.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>
#include <vtksys/Base64.h>

#include <algorithm> // For the copy of rows

namespace softshadows
{

//--------------------------------------------------------------------------------------------------
std::string EncodePng(const ColorImage& image)
{
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.Width, image.Height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const std::ptrdiff_t length = 3 * static_cast<std::ptrdiff_t>(image.Width);
  for (int row = 0; row < image.Height; ++row)
  {
    const auto first = image.Pixels.begin() + row * length;
    std::copy(first, first + length,
      static_cast<unsigned char*>(data->GetScalarPointer(0, image.Height - 1 - row, 0)));
  }
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetInputData(data);
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return std::string(
    reinterpret_cast<const char*>(bytes->GetPointer(0)), bytes->GetNumberOfTuples());
}

//--------------------------------------------------------------------------------------------------
std::string EncodePngUrl(const ColorImage& image)
{
  const std::string png = EncodePng(image);
  std::string text((png.size() + 2) / 3 * 4 + 1, '\0');
  const size_t length = vtksysBase64_Encode(reinterpret_cast<const unsigned char*>(png.data()),
    png.size(), reinterpret_cast<unsigned char*>(&text[0]), 0);
  text.resize(length);
  return "data:image/png;base64," + text;
}

}
