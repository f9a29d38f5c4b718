// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// CheckPicture FILE...: fails unless every file is a picture (PNG or TIFF) that shows something: no
// value of its first channel may fill 95 % of it, and it must have at least 16 values.

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkImageReader2Factory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>

namespace
{
constexpr double LargestShare = 0.95;
constexpr std::size_t FewestValues = 16;

bool ShowsSomething(const char* file)
{
  auto reader = vtkSmartPointer<vtkImageReader2>::Take(
    vtkImageReader2Factory::CreateImageReader2(file)); // null if missing or of no known kind
  if (!reader)
  {
    std::cerr << file << ": no picture\n";
    return false;
  }
  reader->SetFileName(file);
  reader->Update();
  vtkDataArray* values = reader->GetOutput()->GetPointData()->GetScalars();
  if (!values || values->GetNumberOfTuples() == 0)
  {
    std::cerr << file << ": empty\n";
    return false;
  }
  std::map<double, vtkIdType> counts;
  vtkIdType largest = 0;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    largest = std::max(largest, ++counts[values->GetComponent(i, 0)]);
  }
  const double share = static_cast<double>(largest) / values->GetNumberOfTuples();
  std::cout << file << ": " << counts.size() << " values, the most frequent one fills "
            << 100.0 * share << " %\n";
  return counts.size() >= FewestValues && share < LargestShare;
}
}

int main(int argc, char* argv[])
{
  bool good = argc > 1;
  for (int i = 1; i < argc; ++i)
  {
    good = ShowsSomething(argv[i]) && good;
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
