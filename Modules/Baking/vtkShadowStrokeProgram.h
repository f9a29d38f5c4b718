// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowStrokeProgram
 * @brief   The shaders that draw strokes into a depth map.
 */

#ifndef vtkShadowStrokeProgram_h
#define vtkShadowStrokeProgram_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <array> // For places

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
struct vtkShadowMapView;
struct vtkShadowScreen;

class vtkShadowStrokeProgram
{
public:
  /// Makes the program current for a map. False if it does not compile. The view must outlive the draws.
  bool Use(vtkOpenGLRenderWindow* window, const vtkShadowMapView& view, int resolution);

  /// Vertices are relative to the center (world coordinates); the size of the picture's pixels.
  void SetPlace(const std::array<double, 3>& center, const vtkShadowScreen& screen);

  /// Dots or lines, round or flat, and how many pixels wide.
  void SetKind(bool dots, bool round, double pixels);

  /// Where the program takes the vertices.
  unsigned int GetLocation() const { return this->Location; }

  void ReleaseGraphicsResources() { this->Program = nullptr; }

private:
  vtkShaderProgram* Program = nullptr; // the shader cache owns it
  const vtkShadowMapView* View = nullptr;
  unsigned int Location = 0;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowStrokeProgram.h
