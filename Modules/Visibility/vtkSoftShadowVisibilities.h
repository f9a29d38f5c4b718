// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowVisibilities
 * @brief   The visibilities of a renderer's lights at its receivers: estimated, refined, read.
 *
 * Two sets of them: those that the picture is shaded with and, where these are of smooth receivers, those
 * of the triangles themselves, which are estimated only if they are read.
 */

#ifndef vtkSoftShadowVisibilities_h
#define vtkSoftShadowVisibilities_h

#include "vtkNew.h" // For members
#include "vtkRenderer.h"
#include "vtkShadowCasters.h"
#include "vtkShadowMapStore.h"
#include "vtkShadowReceivers.h"
#include "vtkSmartPointer.h"
#include "vtkSoftShadowEstimator.h"
#include "vtkSoftShadowFits.h"
#include "vtkSoftShadowLights.h"
#include "vtkSoftShadowLosses.h"
#include "vtkSoftShadowPixelCount.h"
#include "vtkSoftShadowRefinement.h"
#include "vtkSoftShadowServices.h"
#include "vtkSoftShadowStatistics.h"
#include "vtkSoftShadowTarget.h"
#include "vtkSoftShadowTimers.h"
#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkWeakPointer.h"

#include <string> // For warnings
#include <vector> // For warnings

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkRenderWindow;
class vtkSoftShadowSignature;

class vtkSoftShadowVisibilities
{
public:
  /// The settings of the pass that estimates depend on.
  struct Settings
  {
    int MapSize = 0;
    int Split = 1;
    bool EarlyOut = true;
    vtkTypeInt64 MapMemory = 0; // bytes; 0: a share of what is free
    int Points = 1;             // of every light, per refinement
    double Tolerance = 0.0;     // of refinements
    bool Progressive = false;
  };

  /// technique: lives longer.
  explicit vtkSoftShadowVisibilities(vtkSoftShadowPass& technique);

  ///@{
  /// What visibilities come from, and what is told about them.
  vtkShadowCasters* GetCasters() { return this->Casters; }
  vtkShadowReceivers* GetReceivers() { return this->Receivers; }
  vtkSoftShadowLights& GetLights() { return this->Lights; }
  vtkSoftShadowLosses& GetLosses() { return this->Losses; }
  vtkSoftShadowTimers& GetTimers() { return this->Timers; }
  vtkSoftShadowStatistics& GetStatistics() { return this->Statistics; }
  vtkRenderer* GetRenderer() { return this->Renderer; }
  ///@}

  /// Takes over the renderer and the settings of a frame. Returns what to warn of: maps that are larger
  /// than this OpenGL allows, once; else nothing.
  std::string Begin(vtkRenderer* renderer, const Settings& settings);

  /// Forgets what was refined or read of the visibilities that are held.
  void Restart(vtkWindow* window);

  /// Fits views to the lights. Returns the number of casters too near to their lights.
  int FitViews();

  /// Estimates the picture's from maps and receivers.
  void Estimate(bool changed);

  /// Adds points to the picture's. Returns what to warn of.
  std::vector<std::string> Refine() { return this->Refine(this->Picture); }

  const vtkSoftShadowSchedule& GetSchedule() const
  {
    return this->Picture.Refinement.GetSchedule();
  }
  /// Whether the picture's have converged since this was asked last.
  bool TakeNews() { return this->Picture.Refinement.TakeNews(); }

  /// The picture's: R32F, a layer per casting light.
  vtkShadowTextureArray* GetTexture() { return this->Picture.Target.GetTexture(); }

  /**
   * Whether those of the triangles themselves are others than the picture's, of the frame that was drawn
   * in this window. Waits for the GPU.
   */
  bool NeedsTriangles(vtkRenderWindow* window);

  /// Estimates them unless they are known, and refines them as far as the picture's. Returns what to
  /// warn of.
  std::vector<std::string> UpdateTriangles();

  /**
   * An image of a light's visibility, the picture's or that of the triangles themselves. A light without
   * a layer (-1) reaches every surface. Null if there is none.
   */
  vtkSmartPointer<vtkImageData> MakeImage(int layer, bool triangles);

  /// All that they depend on beyond the pass's settings.
  void AddTo(vtkSoftShadowSignature& signature) const;

  /// Brings the counts up to date. Waits for the GPU.
  void UpdateStatistics();

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// Visibilities, and what they come from beyond receivers and maps.
  struct Set
  {
    vtkSoftShadowTarget Target;
    vtkSoftShadowRefinement Refinement;
    vtkSoftShadowPixelCount Pixels;

    void ReleaseGraphicsResources(vtkWindow* window);
  };

  vtkSoftShadowPass& Technique;
  Settings Given;
  vtkTypeInt64 FreeMemory = 0;          // bytes for maps where the settings say none; 0: not asked
  int ToldMapSize = 0;                  // that is too large for this OpenGL
  vtkWeakPointer<vtkRenderer> Renderer; // of the last frame
  vtkNew<vtkShadowCasters> Casters;
  vtkNew<vtkShadowReceivers> Receivers;
  vtkSoftShadowLights Lights;
  vtkShadowMapStore Maps;
  vtkSoftShadowFits Fits;
  vtkSoftShadowEstimator Estimator;
  vtkSoftShadowLosses Losses; // of the visibilities that are held
  vtkSoftShadowTimers Timers;
  vtkSoftShadowStatistics Statistics;
  vtkTypeInt64 Estimates = 0; // how many there were
  bool IsDataLast = false;    // the last one was of what is read
  Set Picture;
  Set Data;                  // what is read
  bool IsDataKnown = false;  // of the receivers at hand
  bool IsDataWanted = false; // it was read since they were drawn

  vtkTypeInt64 GetFreeMemory();
  vtkSoftShadowServices MakeServices(const vtkShadowMapFitter& fitter, Set& set);
  vtkSoftShadowEstimator::Job MakeJob(Set& set);
  void Estimate(Set& set, bool changed);
  std::vector<std::string> Refine(Set& set);
  void ReleaseData(vtkWindow* window);
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkSoftShadowVisibilities.h
