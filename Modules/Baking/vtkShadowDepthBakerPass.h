// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowDepthBakerPass
 * @brief   Depth maps of everything that casts, seen from the lights of a renderer.
 *
 * A step for a pass chain: it keeps the depth maps of every lit light that can cast up to date and
 * draws nothing into the picture. Put it before the pass that uses the maps, behind the lights
 * (vtkLightsPass, vtkRenderStepsPass), and read the maps as textures (GetDepthMaps) or as images
 * (GetDepthImage). The soft-shadow passes bake by themselves and do not need it.
 *
 * Stages: casters brought up to date; for each lit light its emitter, sample points on it, a view
 * fitted from each of them to the effective casters; layers baked whose view or casters changed. A
 * still scene under a moving camera bakes nothing. The maps are in a vtkShadowMapStore, as those of the
 * soft-shadow passes.
 *
 * A light's layers are its sample points in order, or the faces of a cube around an omni light for
 * each of them; a point or face from which nothing casts has no layer.
 *
 * @sa vtkShadowCasters vtkShadowMapFitter vtkShadowDepthMaps
 */

#ifndef vtkShadowDepthBakerPass_h
#define vtkShadowDepthBakerPass_h

#include "vtkNew.h" // For members
#include "vtkRenderPass.h"
#include "vtkRenderingSoftShadowsBakingModule.h" // For export macro
#include "vtkSmartPointer.h"                     // For images
#include "vtkSoftShadowsABI.h"                   // For the ABI namespace

#include <memory> // For the implementation
#include <string> // For the report

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkLight;
class vtkShadowCasters;
class vtkShadowDepthMaps;

class VTKRENDERINGSOFTSHADOWSBAKING_EXPORT vtkShadowDepthBakerPass : public vtkRenderPass
{
public:
  static vtkShadowDepthBakerPass* New();
  vtkTypeMacro(vtkShadowDepthBakerPass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Render(const vtkRenderState* s) override;

  ///@{
  /// Texels along an edge of each map, in [1, 16384]. Default is 1024. More than the driver allows
  /// count as what it allows, with a warning.
  vtkSetClampMacro(MapSize, int, 1, 16384);
  vtkGetMacro(MapSize, int);
  ///@}

  ///@{
  /**
   * Sample points per light, each with a map of its own; a light without extent has one. The first n
   * points are a grid where n allows one, else Hammersley's (see vtkShadowLightSampling). Default is
   * 1, the light's centre. Of more maps than a texture has layers only the first are drawn, with a
   * warning.
   */
  vtkSetClampMacro(NumberOfSamples, int, 1, 1024);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * Fill every texel that a triangle touches, with the least depth it has there (see
   * vtkShadowCasters::Draw): what a map shows empty is proved empty. Default is off.
   */
  vtkSetMacro(Conservative, bool);
  vtkGetMacro(Conservative, bool);
  vtkBooleanMacro(Conservative, bool);
  ///@}

  /// What casts; its settings are its own.
  vtkShadowCasters* GetCasters() { return this->Casters; }

  /// Lights that had maps in the last frame.
  int GetNumberOfLights() const;

  /// The maps of a light in the last frame, null if it had none.
  vtkShadowDepthMaps* GetDepthMaps(vtkLight* light);

  /**
   * A layer of a light's maps as an image of distances (see vtkShadowDepthMaps::ReadDepth); null, with
   * an error, if there is none. Needs the window's context to be current, as after its Render.
   */
  vtkSmartPointer<vtkImageData> GetDepthImage(vtkLight* light, int layer);

  /// A line per lit light of the renderer in the last frame: its maps, or why it casts nothing.
  std::string GetLightReport() const;

  ///@{
  /// Of the last frame.
  vtkGetMacro(NumberOfBakes, int);
  ///@}

  /// Frees the maps in the window that they lie in, and what the casters hold.
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkShadowDepthBakerPass();
  ~vtkShadowDepthBakerPass() override;

  int MapSize = 1024;
  int NumberOfSamples = 1;
  bool Conservative = false;
  int NumberOfBakes = 0;
  vtkNew<vtkShadowCasters> Casters;

private:
  vtkShadowDepthBakerPass(const vtkShadowDepthBakerPass&) = delete;
  void operator=(const vtkShadowDepthBakerPass&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl;

  void Warn(const std::string& wanted, const std::string& lost);
};

VTK_ABI_NAMESPACE_END
#endif
