// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HardCases.h
 * @brief Scenes that are hard on shadow maps, each with the truth from the ray tracer.
 *
 * A case is a row of the matrix in Documentation/Stability.md; its columns are the techniques.
 */

#ifndef SoftShadowsTesting_HardCases_h
#define SoftShadowsTesting_HardCases_h

#include "Scenes.h"     // For Placement
#include "Techniques.h" // For Effort

#include "vtkSmartPointer.h" // For members

#include <functional> // For factories
#include <iosfwd>     // For names in messages
#include <string>     // For names
#include <vector>     // For lists

class vtkLight;
class vtkRenderer;

namespace SoftShadowsTesting
{

/// A case made: renderers with camera, lights and props, and the window they belong in.
struct HardScene
{
  vtkSmartPointer<vtkRenderer> Renderer;
  /// Whose visibility is judged.
  vtkSmartPointer<vtkLight> Light;
  /// Drawn in the same window, each by a pass of its own.
  std::vector<vtkSmartPointer<vtkRenderer>> Others;
  int Width = 96;
  int Height = 96;
};

struct HardCase
{
  std::string Name;
  /// For the document: what is hard about it.
  std::string What;
  std::function<HardScene()> Make;
  /// Its visibility must be that of the first case of its list, whatever the technique.
  bool SameAsFirst = false;
  /// Largest share of pixels that may show another surface than the ray tracer sees: silhouettes, and
  /// what culling takes away.
  double LargestShareUnlike = 0.02;
  Effort Settings = Effort::Moderate;
};

///@{
/// The rows of the matrix.
const std::vector<HardCase>& InvarianceCases();
const std::vector<HardCase>& GeometryCases();
const std::vector<HardCase>& LightCases();
///@}

/// GoogleTest prints a parameter with it.
std::ostream& operator<<(std::ostream& os, const HardCase& hardCase);

}

#endif
