// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a model's file holds: a mesh, and what of it cannot be shown.
 */

#ifndef ModelFile_h
#define ModelFile_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <map>
#include <string>

namespace softshadows
{

struct ModelFile
{
  vtkSmartPointer<vtkPolyData> Mesh = vtkSmartPointer<vtkPolyData>::New();
  /// How many of what the mesh leaves out, such as "lines": 12.
  std::map<std::string, std::int64_t> NotShown;

  /// "12 lines, 3 points"; empty if all is shown.
  std::string DescribeNotShown() const
  {
    std::string text;
    for (const auto& [what, count] : this->NotShown)
    {
      text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + what;
    }
    return text;
  }
};

/// The point array with the colours of a mesh: three bytes each, sRGB.
constexpr const char* const ModelColors = "SoftShadowsModelColors";

///@{
/// Names in NotShown.
constexpr const char* const DegenerateFaces = "faces without area";
constexpr const char* const FacesNotFinite = "faces with corners that are not finite";
constexpr const char* const LineCells = "lines";
constexpr const char* const PointCells = "points";
///@}

}

#endif
