// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Varieties.h
 * @brief Bodies that VTK draws in ways of its own, each beside the same geometry in plain actors.
 */

#ifndef SoftShadowsTesting_Varieties_h
#define SoftShadowsTesting_Varieties_h

#include "vtkSmartPointer.h" // For props

#include <functional> // For factories
#include <iosfwd>     // For names in messages
#include <string>     // For names
#include <vector>     // For lists

class vtkProp;

namespace SoftShadowsTesting
{

using PropFactory = std::function<std::vector<vtkSmartPointer<vtkProp>>()>;

struct Variety
{
  std::string Name;
  PropFactory MakePlain;
  PropFactory MakeVaried;
  /// Share of pixels that may differ by a step of 8 bits, and the root mean square: greater where the
  /// map covers what is cut away, where rays draw a smooth sphere, and where edges are drawn as lines,
  /// whose pixels have no plane of their own.
  double LargestShareOff = 0.005;
  double LargestRmse = 0.02;
  /// Texels along an edge of a map, more where VTK's bounds are much larger than the body.
  int MapSize = 512;
};

const std::vector<Variety>& AllVarieties();

/// Spheres, sticks and molecules, which VTK traces in fragment shaders; see Imposters.cxx.
std::vector<Variety> ImposterVarieties();

/// What VTK draws with newer mappers, and what it draws otherwise since; see NewMappers.cxx.
std::vector<Variety> NewMapperVarieties();

std::ostream& operator<<(std::ostream& os, const Variety& variety);

}

#endif
