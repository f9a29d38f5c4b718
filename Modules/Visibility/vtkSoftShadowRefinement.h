// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowRefinement
 * @brief   Visibilities that improve while nothing changes: a running mean of hard shadows from points
 *          of the lights.
 *
 * Which points, which maps and when it is enough the schedule says; the accumulator holds the sums.
 */

#ifndef vtkSoftShadowRefinement_h
#define vtkSoftShadowRefinement_h

#include "vtkNew.h" // For members
#include "vtkShadowDepthMaps.h"
#include "vtkShadowLightSampling.h" // For points
#include "vtkShadowShader.h"        // For members
#include "vtkSoftShadowAccumulator.h"
#include "vtkSoftShadowSchedule.h"
#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <string> // For warnings
#include <vector> // For lists

VTK_ABI_NAMESPACE_BEGIN
class vtkSoftShadowLights;
class vtkSoftShadowPass;
class vtkSoftShadowServices;
class vtkSoftShadowTarget;

class vtkSoftShadowRefinement
{
public:
  vtkSoftShadowRefinement();

  /// Who refines what.
  struct Job
  {
    vtkSoftShadowPass* Technique = nullptr;
    vtkSoftShadowLights* Lights = nullptr;
    vtkSoftShadowTarget* Target = nullptr; // the visibilities, as the technique estimated them
    bool GaussianWeights = false;
    int Points = 1; // of every light, per call
    double Tolerance = 0.0;
  };

  /// Back to before the first point. What is held stays until it is released.
  void Reset();

  /// Adds points to the mean, and shows it. Returns what to warn of.
  std::vector<std::string> Refine(const Job& job, vtkSoftShadowServices& services);

  /// Ends at once, with nothing left to do or in failure.
  void Finish(bool converged);

  const vtkSoftShadowSchedule& GetSchedule() const { return this->Schedule; }
  /// Calls that added to the mean.
  int GetFrames() const { return this->Frames; }
  /// Whether it has converged since this was asked last.
  bool TakeNews();

  vtkTypeInt64 GetBytes();
  vtkTypeInt64 GetNumberOfDrawCalls() { return this->Maps->GetNumberOfDrawCalls(); }
  int GetNumberOfBuilds() const;

  /// Frees the textures, and keeps the shaders for the next time.
  void ReleaseTextures(vtkWindow* window);
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkSoftShadowSchedule Schedule;
  vtkSoftShadowAccumulator Accumulator;
  vtkNew<vtkShadowDepthMaps> Maps; // of one point; sizes follow each other
  std::vector<double> Weights;     // in the sum, per casting light
  vtkShadowShader Shader;
  int Frames = 0;
  bool HasNews = false;
  std::vector<std::string> Warnings;

  bool Begin(const Job& job, const vtkSoftShadowServices& services);
  void AddPoints(const Job& job, vtkSoftShadowServices& services);
  bool AddRun(const Job& job, vtkSoftShadowServices& services, int run);
  bool AddPoint(const Job& job, vtkSoftShadowServices& services, int layer, int index);
  bool AddMappedPoint(
    const vtkSoftShadowServices& services, int layer, const vtkShadowLightSampling::Sample& sample);
  void LookAtMean(const Job& job, const vtkSoftShadowServices& services);
  void LoseMaps(const vtkSoftShadowServices& services, const std::string& reason);
  void ClearMean(const vtkSoftShadowServices& services);
  int GetLayers() const { return static_cast<int>(this->Weights.size()); }
  /// What a light's sum is multiplied by to be a mean; 0 if there is none.
  float GetMeanScale(int layer) const;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkSoftShadowRefinement.h
