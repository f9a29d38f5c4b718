// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCascadedDrawing
 * @brief   Draws cascades whose points are one set each: straight away, or as sums that are filtered on
 *          the screen.
 */

#ifndef vtkCascadedDrawing_h
#define vtkCascadedDrawing_h

#include "vtkShadowShader.h"           // For members
#include "vtkSoftShadowScreenFilter.h" // For members
#include "vtkSoftShadowsABI.h"         // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkCascadedEmitter;
class vtkSoftShadowServices;
struct vtkCascadedSettings;

class vtkCascadedDrawing
{
public:
  vtkCascadedDrawing();

  /// Of the shaders that look at the maps.
  void SetDefinitions(const vtkShadowShader::Definitions& definitions);

  /// Draws a cascade, whose points are the set of that number.
  void DrawCascade(
    const vtkSoftShadowServices& services, vtkCascadedEmitter& emitter, size_t cascade);

  /// Draws the sums of all cascades, filtered on the screen.
  void DrawScreen(const vtkSoftShadowServices& services, const vtkCascadedSettings& settings,
    vtkCascadedEmitter& emitter);

  vtkTypeInt64 GetBytes() const { return this->ScreenFilter.GetBytes(); }
  int GetNumberOfBuilds() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkShadowShader Shader;
  vtkShadowShader SumsShader;
  vtkSoftShadowScreenFilter ScreenFilter;

  /// Draws a cascade's part of the sums. isFirst: nothing has been drawn yet; false afterwards.
  void DrawSums(const vtkSoftShadowServices& services, vtkCascadedEmitter& emitter, size_t cascade,
    bool& isFirst);
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkCascadedDrawing.h
