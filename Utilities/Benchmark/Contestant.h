// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   Contestant
 * @brief   One way to draw a scene with shadows, ready to be timed and judged.
 *
 * Every contestant has a scene, a renderer and, if it draws with OpenGL, a window of its own, so that
 * none disturbs another's cached programs and buffers.
 */

#ifndef SoftShadowsBenchmark_Contestant_h
#define SoftShadowsBenchmark_Contestant_h

#include "BenchmarkResults.h"

#include <functional> // For factories
#include <memory>     // For contestants
#include <string>     // For names

class vtkRenderer;
class vtkSoftShadowPass;

template <class T>
class vtkSmartPointer;

namespace softshadows
{

using TechniqueOptions = std::map<std::string, std::string>;

/// A renderer with camera, lights and actors that nobody else uses.
using SceneFactory = std::function<vtkSmartPointer<vtkRenderer>()>;

/// Throws std::exception for techniques and options that do not exist.
using TechniqueFactory = std::function<vtkSmartPointer<vtkSoftShadowPass>(
  const std::string& technique, const TechniqueOptions& options)>;

/// Which technique with which options.
struct ContestantChoice
{
  std::string Technique;
  TechniqueOptions Options;
  /// It is measured even where the time of a scene is used up.
  bool IsEssential = false;

  /// "pcss filter_width=21 search_width=11"
  std::string GetName() const;

  /// Of one point per light: vtk, and sampled with one sample.
  bool HasHardShadows() const;
};

class Contestant
{
public:
  virtual ~Contestant() = default;

  /// Draws a frame and waits until it is done. Frame numbers only have to differ.
  virtual void Draw(Motion motion, int frame) = 0;

  /// One image per light that is on, top row first; empty if there is nothing to judge.
  virtual std::vector<std::vector<float>> GetVisibility() { return {}; }

  /// What the last frame showed; empty if nothing was shown.
  virtual ColorImage GetPicture() { return {}; }

  virtual std::vector<std::pair<std::string, double>> GetSteps() { return {}; }
  virtual std::vector<std::pair<std::string, std::int64_t>> GetCounts() { return {}; }

  /// Whether a motion costs it anything else than standing still.
  virtual bool Notices(Motion) const { return true; }
};

/**
 * plain (VTK's own frame, no shadows), vtk (vtkShadowMapPass, hard shadows), rays (ray tracing,
 * option samples), and whatever the factory knows, which may have the option supersample: that many
 * samples along each edge of a pixel. All may have light_scale: a factor on the size of the lights,
 * which the truth does not know of.
 */
std::unique_ptr<Contestant> MakeContestant(const ContestantChoice& choice,
  const SceneFactory& makeScene, int width, int height, const TechniqueFactory& makeTechnique);

}

#endif
