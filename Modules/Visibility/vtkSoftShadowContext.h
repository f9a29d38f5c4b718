// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowContext
 * @brief   What visibility is estimated from: the frame, its settings, and one emitter with its map.
 */

#ifndef vtkSoftShadowContext_h
#define vtkSoftShadowContext_h

#include "vtkRenderingSoftShadowsVisibilityModule.h" // For export macro
#include "vtkShadowEmitter.h"                        // For the emitter
#include "vtkSoftShadowsABI.h"                       // For the ABI namespace
#include "vtkType.h"                                 // For numbers

VTK_ABI_NAMESPACE_BEGIN
class vtkLight;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkShadowCasters;
class vtkShadowDepthMaps;
class vtkShadowDepthPyramid;
class vtkShadowMapFitter;
class vtkShadowReceivers;

struct VTKRENDERINGSOFTSHADOWSVISIBILITY_EXPORT vtkSoftShadowContext
{
  ///@{
  /// The frame.
  vtkRenderer* Renderer = nullptr;
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkShadowCasters* Casters = nullptr;
  const vtkShadowMapFitter* Fitter = nullptr;
  vtkShadowReceivers* Receivers = nullptr;
  /// Grows with every estimate, of the picture or of data: what has another one is of an older estimate.
  vtkTypeInt64 Estimate = 0;
  /// Whether anything that the visibility depends on changed; if not, the technique wanted it anew.
  bool Changed = true;
  /// Whether it is for being read, not for the picture: to be as good as it gets, once.
  bool IsData = false;
  /// The depth renderbuffer of the bound framebuffer, the viewport's size: steps before the last,
  /// drawn at depth 0.5 with GL_LESS, touch with it only the pixels that the last step will filter.
  unsigned int Marks = 0;
  ///@}

  ///@{
  /// The settings of the pass.
  /// Texels along an edge of a map, no more than this OpenGL allows.
  int MapSize = 0;
  /// Bytes of depth maps that may be held at a time.
  vtkTypeInt64 MapMemory = 0;
  bool EarlyOut = true;
  ///@}

  ///@{
  /// The emitter.
  /// Which of the lit lights, in the renderer's order, and which of its emitters (faces x parts).
  int Light = 0;
  int Part = 0;
  /// That light itself.
  vtkLight* Source = nullptr;
  /// Which axis of the cube a face of an omni light looks along; -1 for other lights.
  int FaceAxis = -1;
  /// The emitter; Weight is what its visibility is multiplied by.
  vtkShadowEmitter Emitter;
  /// If the technique requires a map from the emitter's centre: the maps, and the layer to look at.
  vtkShadowDepthMaps* Maps = nullptr;
  int Layer = 0;
  /// A pyramid over Maps if the technique requires one.
  vtkShadowDepthPyramid* Pyramid = nullptr;
  ///@}

  /// Whether a renderer has a light, lit or not. The light is compared, not followed.
  static bool HasLight(vtkRenderer* renderer, const vtkLight* light);
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkSoftShadowContext.h
