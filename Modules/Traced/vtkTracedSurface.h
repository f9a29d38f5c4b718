// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedSurface
 * @brief   Where triangles have holes: beyond their mapper's clipping planes, and where their texture has no
 * alpha.
 */

#ifndef vtkTracedSurface_h
#define vtkTracedSurface_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkTracedVector.h"

#include <array>   // For planes
#include <cstdint> // For corners
#include <memory>  // For the result
#include <vector>  // For alphas

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkShadowCasterGeometry;
class vtkTexture;

class vtkTracedSurface
{
public:
  /// Of an actor and its triangles; null if there are no holes.
  static std::unique_ptr<const vtkTracedSurface> Of(
    vtkActor* actor, const vtkShadowCasterGeometry& triangles);

  /**
   * Whether something is there: at a place in world coordinates, and at u and v of the way from the first
   * of three vertices to the second and the third.
   */
  bool IsThere(
    const vtkTracedVector& world, const std::uint32_t* vertices, double u, double v) const;

private:
  bool TakeTexture(vtkTexture* texture, const vtkShadowCasterGeometry& triangles);
  bool HasAlpha(double s, double t) const;
  float GetAlpha(int column, int row) const;

  std::vector<std::array<double, 4>> Planes; // a x + b y + c z + d < 0 is cut away
  std::vector<float> Coordinates;            // of the texture, two per vertex
  std::vector<float> Alphas;
  int Width = 0;
  int Height = 0;
  bool Repeats = false;
  bool Interpolates = false;
};

VTK_ABI_NAMESPACE_END
#endif
