// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowEstimator
 * @brief   From lights and receivers to visibility: what a technique is asked for, light by light.
 *
 * Per face of a light: its map is baked, pixels are proved lit or blocked and the others marked; then the
 * technique adds what they see of each part.
 */

#ifndef vtkSoftShadowEstimator_h
#define vtkSoftShadowEstimator_h

#include "vtkNew.h"                    // For members
#include "vtkShadowDepthPyramid.h"     // For members
#include "vtkShadowMapStore.h"         // For requests
#include "vtkShadowShader.h"           // For members
#include "vtkSoftShadowRequirements.h" // For requirements
#include "vtkSoftShadowsABI.h"         // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkSoftShadowLights;
class vtkSoftShadowLosses;
class vtkSoftShadowPass;
class vtkSoftShadowPixelCount;
class vtkSoftShadowServices;
class vtkSoftShadowTarget;
class vtkWindow;
struct vtkShadowMapView;

class vtkSoftShadowEstimator
{
public:
  vtkSoftShadowEstimator();

  /// Who estimates what, and where it goes.
  struct Job
  {
    vtkSoftShadowPass* Technique = nullptr;
    vtkSoftShadowRequirements Requirements;
    int Split = 1;
    vtkSoftShadowLights* Lights = nullptr;
    vtkSoftShadowLosses* Losses = nullptr;
    vtkSoftShadowTarget* Target = nullptr;
    vtkSoftShadowPixelCount* Pixels = nullptr;
  };

  /// Fits the views of all lights that cast. Returns the number of casters too near to their lights.
  static int FitViews(const Job& job, const vtkSoftShadowServices& services);

  /// Estimates the visibilities of all lights that cast. Restores the framebuffer.
  void Estimate(const Job& job, vtkSoftShadowServices& services);

  int GetNumberOfBuilds() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkShadowShader ProofShader;
  vtkShadowShader ConstantShader;
  vtkNew<vtkShadowDepthPyramid> NoPyramid; // of a light without maps

  void EstimateOrPrepare(const Job& job, vtkSoftShadowServices& services, bool preparing);
  void PrepareLight(const Job& job, vtkSoftShadowServices& services, int layer);
  void EstimateLight(const Job& job, vtkSoftShadowServices& services, int layer);
  bool SelectFaces(const Job& job, vtkSoftShadowServices& services, int layer);
  bool Select(vtkSoftShadowServices& services, const vtkShadowMapStore::Key& key,
    const vtkShadowMapStore::Request& request);
  bool SelectPart(
    const Job& job, vtkSoftShadowServices& services, int layer, size_t faceIndex, size_t partIndex);
  void EstimatePart(
    const Job& job, vtkSoftShadowServices& services, int layer, size_t faceIndex, size_t partIndex);
  void DrawMarks(
    const Job& job, const vtkSoftShadowServices& services, const vtkShadowMapView* view);
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkSoftShadowEstimator.h
