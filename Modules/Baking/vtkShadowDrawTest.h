// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowDrawTest
 * @brief   Which casters a depth map shows, and which sides of them.
 */

#ifndef vtkShadowDrawTest_h
#define vtkShadowDrawTest_h

#include "vtkShadowCasterEntry.h" // For casters
#include "vtkShadowMapView.h"     // For the view
#include "vtkSoftShadowsABI.h"    // For the ABI namespace

#include <array> // For planes

VTK_ABI_NAMESPACE_BEGIN

class vtkShadowDrawTest
{
public:
  explicit vtkShadowDrawTest(const vtkShadowMapView& view);

  /**
   * 1, -1 or 0: triangles that turn counterclockwise, clockwise, or all; NO_SIDE if the map does not
   * show the caster at all.
   */
  int GetSide(const vtkShadowCasterEntry& entry) const;

private:
  bool IsInView(const std::array<double, 6>& box) const;
  bool IsEffective(const vtkShadowCasterEntry& entry) const;
  bool IsInside(const std::array<double, 6>& box) const;

  const vtkShadowMapView& View;
  // {a, b, c, d} with a x + b y + c z + d < 0 outside, in world coordinates.
  std::array<std::array<double, 4>, 5> Planes;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowDrawTest.h
