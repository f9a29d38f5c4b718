// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReferenceTracer
 * @brief   The exact visibility of a renderer's area lights, by ray tracing: the truth to measure by.
 *
 * For every pixel centre the first surface is found and N x N rays are sent from it to jittered
 * strata of each light; the visibility is the weighted mean of what is not blocked. It shares the
 * scene and the description of the lights with the raster techniques, and no other code.
 *
 * Surfaces are opaque: what of the light lies behind the side that the camera sees is blocked by the
 * surface itself, be it a closed body or a thin sheet.
 *
 * The jitter is a fixed function of pixel, light and stratum: the same scene gives the same numbers
 * on any number of cores.
 *
 * Pixels: top row first. Visibility: 1 lit, 0 umbra, NaN where there is no surface, where the surface
 * receives no shadow or is unlit, outside the light's cone and behind a rectangle or a disk. A light that can
 * cast no shadow is visible from everywhere. Lights that are switched off are left out.
 *
 * Error: for an edge across the light about 0.3 N^-1.5, that is 6e-4 for N = 64.
 *
 * @sa ReferenceGeometry ReferenceLight ReferenceSnapshot
 */

#ifndef SoftShadowsRayTracing_ReferenceTracer_h
#define SoftShadowsRayTracing_ReferenceTracer_h

#include <array>      // For normals
#include <atomic>     // For the request to stop
#include <cstdint>    // For counts
#include <functional> // For the progress callback
#include <vector>     // For the images

class vtkProp;
class vtkRenderer;

namespace softshadows
{

class ReferenceSnapshot;

/// Images of Width x Height, top row first.
struct ReferenceVisibility
{
  int Width = 0;
  int Height = 0;
  /// One image per light that is switched on, in the renderer's order.
  std::vector<std::vector<float>> Visibility;
  /// World units along the view direction; NaN where there is no surface.
  std::vector<float> Depth;
  /// Geometric unit normals towards the camera, world axes; NaN where there is no surface.
  std::vector<std::array<float, 3>> Normal;
  /// Which of Props is seen, -1 for none.
  std::vector<int> Object;
  /// Per object (actor or part of an assembly) the prop in the renderer's list. Not owned.
  std::vector<vtkProp*> Props;
  /// Rays sent to lights.
  std::int64_t ShadowRays = 0;
  /// False if the trace was cancelled: pixels not reached have no value.
  bool Complete = true;
};

class ReferenceTracer
{
public:
  /// Throws std::invalid_argument for sizes and numbers of samples below 1.
  ReferenceTracer(int width, int height, int samplesPerAxis);

  /// Weights of the light's points: N(0, 0.5) over the window [-1, 1]^2 instead of uniform ones.
  void SetGaussian(bool gaussian) { this->Gaussian = gaussian; }

  /**
   * A faster, no longer exact mode: this many samples per axis first, and all of them only where
   * the first disagree. It misses blockers that fall between the first samples of a pixel. 0, the
   * default, is off.
   */
  void SetPilotSamplesPerAxis(int samples) { this->PilotSamplesPerAxis = samples; }

  /// Threads to use; 0, the default, takes all cores.
  void SetNumberOfThreads(unsigned int threads) { this->NumberOfThreads = threads; }

  /// Called from the calling thread with the share done, in [0, 1].
  void SetProgress(std::function<void(double)> progress) { this->Progress = std::move(progress); }

  /**
   * Reads the renderer's camera, lights and props; does not render. Throws std::runtime_error if
   * Embree gives no device.
   */
  ReferenceVisibility Trace(vtkRenderer* renderer) const;

  /**
   * Traces what a snapshot holds, which may happen in any thread: no VTK object is touched. Whether
   * weights are Gaussian is the snapshot's. Throws std::invalid_argument for another size.
   */
  ReferenceVisibility Trace(const ReferenceSnapshot& snapshot) const;

  /// A trace ends early once this is true. Not owned; must live while Trace runs.
  void SetCancelled(const std::atomic<bool>* cancelled) { this->Cancelled = cancelled; }

private:
  int Width;
  int Height;
  int SamplesPerAxis;
  int PilotSamplesPerAxis = 0;
  bool Gaussian = false;
  unsigned int NumberOfThreads = 0;
  std::function<void(double)> Progress;
  const std::atomic<bool>* Cancelled = nullptr;
};

/// The same in one call.
ReferenceVisibility Trace(
  vtkRenderer* renderer, int width, int height, int samplesPerAxis, bool gaussian = false);

}

#endif
