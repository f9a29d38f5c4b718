// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Techniques.h
 * @brief The list of techniques that the tests walk. A new technique is one more entry in it.
 */

#ifndef SoftShadowsTesting_Techniques_h
#define SoftShadowsTesting_Techniques_h

#include "ClosedForms.h"

#include "vtkSmartPointer.h" // For the pass

#include <gtest/gtest.h> // For names of cases

#include <functional> // For factories
#include <iosfwd>     // For names in messages
#include <string>     // For names
#include <vector>     // For the list

class vtkSoftShadowPass;

namespace SoftShadowsTesting
{

enum class Effort
{
  Accurate, ///< What the technique's published figures were measured with.
  Moderate, ///< Maps of 512 texels and 64 points of the light, or as good.
  Quick     ///< Small maps and few samples, for tests that compare a technique with itself.
};

struct Technique
{
  std::string Name;
  std::function<vtkSmartPointer<vtkSoftShadowPass>(Effort, Weights)> Make;
  /// Largest root mean square error on the closed forms, with Effort::Accurate.
  double LargestError;
  /// Largest relative error of the penumbra's width there.
  double LargestWidthError;
  /// The fewest steps in which the visibility can change with Effort::Quick: one sample's weight.
  double QuickStep;
  /// Largest root mean square that the border of the picture may add where neighbours on the screen
  /// take part; 0 for techniques that look at each pixel alone.
  double LargestBorderError = 0.0;
  /// The visibility varies continuously with depths, and so with their rounding, which depends on
  /// where the casters' origin was laid first. Others have steps that such rounding does not reach.
  bool IsContinuous = false;
  /// Whether pixels proved lit or blocked are left out; not where neighbours need their value.
  bool HasProof = true;
  /// Whether it sees the casters in depth maps.
  bool HasMaps = true;
};

const std::vector<Technique>& AllTechniques();

/// And those that are rivals of a paper with errors of their own: for tests that judge no error.
std::vector<Technique> EveryTechnique();

/// GoogleTest prints a parameter with it.
std::ostream& operator<<(std::ostream& os, const Technique& technique);

/// The name of a case in a suite that walks the list.
std::string NameOfTechnique(const testing::TestParamInfo<Technique>& parameter);

}

#endif
