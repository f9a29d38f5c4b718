// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowMapFitter
 * @brief   Fits a depth map's window and depth range to the effective casters of an emitter.
 *
 * An effective caster is a body that can throw a shadow on something: not a flat body with everything
 * on its light side, not a body behind which, seen from the emitter, nothing that receives lies, not
 * a body outside the light's cone. The fit depends neither on the window nor on the camera.
 *
 * A window is at most tan(85 degrees) wide around the direction: what a positional light sees at
 * more grazing angles blocks nothing. The depth range encloses the effective casters; the near plane
 * is no nearer than 1e-7 of the far plane.
 */

#ifndef vtkShadowMapFitter_h
#define vtkShadowMapFitter_h

#include "vtkRenderingSoftShadowsBakingModule.h" // For export macro
#include "vtkShadowCasters.h"                    // For the bodies
#include "vtkShadowMapView.h"                    // For the view
#include "vtkSoftShadowsABI.h"                   // For the ABI namespace

#include <vector> // For faces

VTK_ABI_NAMESPACE_BEGIN

class VTKRENDERINGSOFTSHADOWSBAKING_EXPORT vtkShadowMapFitter
{
public:
  explicit vtkShadowMapFitter(const std::vector<vtkShadowCasters::Body>& bodies);

  /**
   * The view from the emitter's centre over its effective casters; margins hold at least one texel
   * at any resolution of 32 texels and above. False if there are none: every point is lit.
   */
  bool Fit(const vtkShadowEmitter& emitter, vtkShadowMapView& view) const;

  /**
   * The views of an emitter that one window cannot hold: the faces of a cube around an omni light, one
   * view otherwise. Faces without effective casters are left out, so the result may be empty.
   */
  std::vector<vtkShadowMapView> FitAll(const vtkShadowEmitter& emitter) const;

  /**
   * Casters that lie wholly in front of the near plane, which is held back by a far plane ten million
   * times as far away: they cast nothing on what is as near as they are.
   */
  int CountTooNear(const vtkShadowMapView& view) const;

  /**
   * The emitter as the bodies see it: a positional one 100000 times as far away as the bodies are large is
   * the directional one of its angular size, which no cancellation harms. One whose cone ends among
   * the bodies, or that shines away from them, stays as it is.
   */
  vtkShadowEmitter SeeFromAfar(const vtkShadowEmitter& emitter) const;

private:
  const std::vector<vtkShadowCasters::Body>& Bodies;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowMapFitter.h
