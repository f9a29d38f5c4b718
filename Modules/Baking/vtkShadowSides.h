// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowSides.h
 * @brief On which side of a flat body lights and receivers are.
 *
 * A plane throws a shadow only on what lies on its other side than the light.
 */

#ifndef vtkShadowSides_h
#define vtkShadowSides_h

#include "vtkShadowCasters.h"  // For bodies
#include "vtkShadowEmitter.h"  // For emitters
#include "vtkSoftShadowsABI.h" // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN

struct vtkShadowSides
{
  using Body = vtkShadowCasters::Body;

  /// Where all of the emitter is: 1 along the flat body's normal, -1 against it, 0 on both sides.
  static int OfEmitter(const Body& plane, const vtkShadowEmitter& emitter);

  /**
   * Whether some of a body is on the plane's other side than side (1 or -1); always if side is 0.
   * What is out by less than 1e-5 of the body's size touches and does not count.
   */
  static bool ReachesBehind(const Body& plane, int side, const Body& body);
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowSides.h
