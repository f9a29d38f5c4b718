// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SceneTrial
 * @brief   All contestants in one scene: made, judged, timed round by round.
 */

#ifndef SoftShadowsBenchmark_SceneTrial_h
#define SoftShadowsBenchmark_SceneTrial_h

#include "BenchmarkRunner.h"

namespace softshadows
{

class SceneTrial
{
public:
  /// Keeps references to all of them.
  SceneTrial(const BenchmarkSettings& settings, const BenchmarkScene& scene,
    const SceneTruth& truth, const TechniqueFactory& makeTechnique);

  /**
   * Makes a contestant, warms it up and compares its visibility. One that fails is kept with its
   * reason. One with samples or a split light is not even tried where one of its kind with fewer
   * tells that a frame would take too long.
   */
  void Add(const ContestantChoice& choice);

  /// Keeps a contestant with the reason why it is not tried.
  void LeaveOut(const ContestantChoice& choice, const std::string& reason);

  /// Draws and times one frame of each contestant and motion that the settings name.
  void TimeRound();

  /// The contestants' results in the order of Add. Ends the trial.
  std::vector<ContestantResult> Finish();

  /// The first light's reference in grey.
  ColorImage DrawReference() const;

private:
  struct Entry
  {
    std::unique_ptr<Contestant> Runner;
    ContestantResult Result;
    double SecondsUsed = 0.0;
    /// Of the first frame with moving lights after warming up.
    double SecondsPerFrame = 0.0;
    /// That frame took longer than a frame may: it is not drawn again.
    bool IsSlow = false;
    std::map<std::string, FrameTimes> Steps;
    std::vector<std::string> StepOrder;
  };

  const BenchmarkSettings& Settings;
  const BenchmarkScene& Scene;
  const SceneTruth& Truth;
  const TechniqueFactory& MakeTechnique;
  std::vector<unsigned char> Silhouettes;
  /// Of the first contestant that has any.
  std::vector<std::vector<float>> FirstVisibility;
  std::vector<Entry> Entries;
  int Frame = 0;

  void Prepare(const ContestantChoice& choice, Entry& entry);
  void Judge(const ContestantChoice& choice, Entry& entry);
  double CompareWith(const std::vector<std::vector<float>>& truth,
    const std::vector<std::vector<float>>& images) const;
  void KeepPictures(const std::vector<std::vector<float>>& images, Entry& entry) const;
  double LongestFrame() const;
  double Time(Entry& entry, Motion motion);
  bool HasTime(const Entry& entry) const;
  double Foresee(const ContestantChoice& choice) const;
  static void KeepSteps(Entry& entry);
};

}

#endif
