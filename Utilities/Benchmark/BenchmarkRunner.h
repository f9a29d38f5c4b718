// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkRunner
 * @brief   Runs scenes x contestants: errors against the ray-traced reference, then times.
 *
 * In each scene all contestants are made and judged first. Then rounds of frames are timed: every
 * round draws a frame of each contestant and each motion, so that whatever slows the machine for a
 * while hits all alike. A contestant that has used up its seconds sits out the remaining rounds.
 */

#ifndef SoftShadowsBenchmark_BenchmarkRunner_h
#define SoftShadowsBenchmark_BenchmarkRunner_h

#include "Contestant.h"
#include "ReferenceSource.h"

#include <functional> // For the progress callback
#include <string>     // For names

namespace softshadows
{

struct BenchmarkSettings
{
  /// Rounds of timed frames, after two frames to warm up.
  int Rounds = 9;
  /// Time that one contestant may use for one scene, in seconds; one frame per motion is always run.
  double SecondsPerContestant = 20.0;
  /**
   * Time for a scene without its reference, in seconds; 0: as long as it takes. Contestants whose turn
   * comes after JudgingShare of it are left out unless they are essential; rounds after the third end
   * with it, all rounds with one and a half of it. A frame may take a fifteenth of it.
   */
  double SecondsPerScene = 0.0;
  static constexpr double JudgingShare = 0.5;
  static constexpr int LeastRounds = 3;
  /// Seconds; of contestants that take longer a single frame is timed, and those of which that can be
  /// foreseen are left out.
  double LongestFrame = 60.0;
  /// What is timed. The first frame with moving lights after warming up is drawn in any case.
  std::vector<Motion> Motions = { AllMotions.begin(), AllMotions.end() };
  /// Without a truth nothing is judged, and no reference is traced.
  bool HasTruth = true;
  /// The truth's lights are weighted by N(0, 0.5) over their windows.
  bool Gaussian = false;
  int ReferenceSamplesPerAxis = 48;
  /// Whether lit pictures are compared with the picture of the truth.
  bool JudgesPictures = true;
  /// Pictures of the first contestant of every technique.
  bool Pictures = true;
};

/// A scene by name. Make throws if the scene is broken.
struct BenchmarkScene
{
  std::string Name;
  int Width = 0;
  int Height = 0;
  SceneFactory Make;
  /// One of a family that grows in actors or triangles: a few contestants are enough.
  bool Grows = false;
  /// Of the time of a run that is limited, beside the others'.
  double Share = 3.0;
  /// Set instead if not even the file could be read.
  std::string Failure;
};

/// What contestants are judged by. Images are empty where there is nothing to judge.
struct SceneTruth
{
  VisibilityImage Soft;
  /// Of the lights' centres alone.
  VisibilityImage Hard;
  /// Lit by Soft.
  ColorImage Picture;
};

class SceneTrial;

class BenchmarkRunner
{
public:
  using ProgressFunction = std::function<void(const std::string& line, bool isFinal)>;

  BenchmarkRunner(
    BenchmarkSettings settings, TechniqueFactory makeTechnique, ReferenceSource findReference)
    : Settings(std::move(settings))
    , MakeTechnique(std::move(makeTechnique))
    , FindReference(std::move(findReference))
  {
  }

  /// Lines for a terminal; those that are not final may be overwritten by the next.
  void SetProgress(ProgressFunction progress) { this->Progress = std::move(progress); }

  /// Never throws: what is broken is reported in the result.
  SceneResult Run(const BenchmarkScene& scene, const std::vector<ContestantChoice>& choices) const;

  /// Only traces the references that Run will read, into the cache. Never throws: false if it failed.
  bool Prepare(const BenchmarkScene& scene, const std::vector<ContestantChoice>& choices) const;

  ///@{
  /// May change from scene to scene.
  const BenchmarkSettings& GetSettings() const { return this->Settings; }
  void SetSettings(BenchmarkSettings settings) { this->Settings = std::move(settings); }
  ///@}

private:
  BenchmarkSettings Settings;
  TechniqueFactory MakeTechnique;
  ReferenceSource FindReference;
  ProgressFunction Progress;

  void Report(const std::string& line, bool isFinal) const;
  SceneTruth GetTruth(const BenchmarkScene& scene, const std::vector<ContestantChoice>& choices,
    SceneResult& result) const;
  VisibilityImage GetReference(
    vtkRenderer* renderer, const BenchmarkScene& scene, int samplesPerAxis, bool gaussian) const;
  void TimeRounds(SceneTrial& trial, const std::string& name, double secondsUsed) const;
};

}

#endif
