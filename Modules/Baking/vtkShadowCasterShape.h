// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowCasterShape
 * @brief   What one caster is made of, for techniques that do without depth maps.
 *
 * Pointers are valid until the next vtkShadowCasters::Update().
 */

#ifndef vtkShadowCasterShape_h
#define vtkShadowCasterShape_h

#include "vtkShadowScreen.h"   // For the size of a pixel
#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkType.h"           // For times

#include <array>   // For the matrix
#include <cstdint> // For numbers
#include <vector>  // For data

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
class vtkProp3D;
class vtkShadowCasterGeometry;
class vtkShadowStrokes;

struct vtkShadowCasterShape
{
  /// Of the caster, the same from frame to frame and of no other caster.
  std::uint64_t Number = 0;
  /// Grows whenever anything but the matrix changes.
  vtkMTimeType Time = 0;
  /// Model to world coordinates, row-major, affine.
  std::array<double, 16> Matrix{};
  vtkProp3D* Prop = nullptr;
  /// Triangles in model coordinates; empty if nothing is known to lie within triangles.
  const vtkShadowCasterGeometry* Triangles = nullptr;
  /// The data, if the mapper draws them as they are but for clipping planes and textures; else none.
  std::vector<vtkPolyData*> Pieces;
  /// Points and lines besides, as wide as the picture draws them; null if there are none.
  const vtkShadowStrokes* Strokes = nullptr;
  vtkShadowScreen Screen;
  /// Triangles and strokes are exactly what is drawn. If not, the prop's mapper knows more.
  bool IsPlain = true;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowCasterShape.h
