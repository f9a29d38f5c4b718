// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowCasterProgram
 * @brief   The shaders that draw casters from their buffer, and the OpenGL state they need.
 */

#ifndef vtkShadowCasterProgram_h
#define vtkShadowCasterProgram_h

#include "vtkOpenGLState.h"    // For scoped state
#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <array> // For the origin

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
struct vtkShadowMapView;

class vtkShadowCasterProgram
{
public:
  /**
   * Depth only, two-sided, depth clamped to the range, the greater depth wins; what was before comes
   * back at the end.
   */
  class ScopedState
  {
  public:
    explicit ScopedState(vtkOpenGLState* state);
    ~ScopedState();
    ScopedState(const ScopedState&) = delete;
    void operator=(const ScopedState&) = delete;

  private:
    vtkOpenGLState::ScopedglEnableDisable DepthTest;
    vtkOpenGLState::ScopedglEnableDisable CullFace;
    vtkOpenGLState::ScopedglEnableDisable Blend;
    int CullFaceMode = 0;
    vtkOpenGLState* State;
    vtkOpenGLState::ScopedglDepthMask DepthMask;
    vtkOpenGLState::ScopedglDepthFunc DepthFunc;
    vtkOpenGLState::ScopedglColorMask ColorMask;
    bool HadDepthClamp;
    bool HadPolygonOffset;
  };

  /**
   * Makes the program current with its uniforms for the view, and OpenGL's clip space that of
   * vtkShadowMapView::WorldToClip(true) until Finish(), where there is such a one. False if it does not
   * compile.
   */
  bool Use(vtkOpenGLRenderWindow* window, const vtkShadowMapView& view,
    const std::array<double, 3>& origin, int resolution, bool conservative);

  /**
   * The same for several maps at once, one per instance that is drawn: the i-th goes to layer
   * firstLayer + i of the texture, whose layers are all attached. At most LayersPerDraw views. Needs
   * CanDrawLayers().
   */
  bool UseLayers(vtkOpenGLRenderWindow* window, const vtkShadowMapView* views, int count,
    int firstLayer, const std::array<double, 3>& origin);

  static constexpr int LayersPerDraw = 16;

  /// Whether a vertex shader may choose the layer. Costs nothing but the first time.
  bool CanDrawLayers();

  /// Draw only triangles that turn counterclockwise (1), clockwise (-1), or all (0).
  static void SetSide(vtkOpenGLState* state, int side);

  /// OpenGL's own clip space again, which VTK's mappers rely on.
  void Finish() const;

  /// Where the current program takes the vertices.
  unsigned int GetLocation() const { return this->Location; }

  void ReleaseGraphicsResources();

private:
  vtkShaderProgram* MakeReady(vtkOpenGLRenderWindow* window, int which);
  void Begin(vtkShaderProgram* program);

  std::array<vtkShaderProgram*, 3>
    Programs{}; // normal, conservative, layers; the shader cache owns them
  unsigned int Location = 0;
  bool WritesDepth = true; // for want of a clip space from 0 to 1
  bool IsLayerKnown = false;
  const char* LayerExtension = nullptr; // by which a vertex shader chooses the layer, if any does
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowCasterProgram.h
