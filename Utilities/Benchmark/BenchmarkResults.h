// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkResults.h
 * @brief What a benchmark run finds out, as plain values.
 */

#ifndef SoftShadowsBenchmark_BenchmarkResults_h
#define SoftShadowsBenchmark_BenchmarkResults_h

#include "ErrorMeasures.h"

#include <array>   // For the motions
#include <cstdint> // For counts
#include <limits>  // For what was not measured
#include <map>     // For options
#include <string>  // For names
#include <utility> // For pairs
#include <vector>  // For lists

namespace softshadows
{

/// What changes from frame to frame while it is timed.
enum class Motion
{
  Still,  ///< Nothing.
  Camera, ///< The camera.
  Light   ///< All lights: every map is baked anew.
};
constexpr std::array<Motion, 3> AllMotions = { { Motion::Still, Motion::Camera, Motion::Light } };

/// "still", "camera", "light"
const char* NameOf(Motion motion);

/// Times of single frames.
struct FrameTimes
{
  std::vector<double> Milliseconds;

  ///@{
  /// Order statistics with linear interpolation; NaN without frames.
  double Quantile(double share) const;
  double Median() const { return this->Quantile(0.5); }
  ///@}
  double Mean() const;
  double StandardDeviation() const;
};

/// RGB bytes, top row first.
struct ColorImage
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Pixels;
};

/// One technique with one set of options in one scene.
struct ContestantResult
{
  std::string Name;
  std::string Technique;
  std::map<std::string, std::string> Options;
  /// Why there are no numbers; empty if all went well.
  std::string Failure;
  /// By motion.
  std::array<FrameTimes, 3> Times;
  /// Median milliseconds per step while the lights move, in the frame's order.
  std::vector<std::pair<std::string, double>> Steps;
  std::vector<std::pair<std::string, std::int64_t>> Counts;
  /// Per light; empty if the contestant has no visibility to compare.
  std::vector<VisibilityErrors> Errors;
  /// Over the pixels of all lights together.
  double Rmse = 0.0;
  /// The same against the ray-traced shadows of the lights' centres; NaN for what draws no hard shadows.
  double RmseToHard = std::numeric_limits<double>::quiet_NaN();
  /// The same against the scene's first contestant that has a visibility; NaN if there is none.
  double RmseToFirst = std::numeric_limits<double>::quiet_NaN();
  /// Of the luminance of the lit picture, against the picture lit by the ray-traced visibility. Over all
  /// pixels; none without a picture.
  ErrorMeasures PictureErrors;
  ///@{
  /// Of the first light; empty if there is none or pictures are not wanted.
  ColorImage Picture;
  ColorImage Visibility;
  ColorImage Difference;
  ///@}

  bool HasErrors() const { return !this->Errors.empty(); }
};

struct SceneResult
{
  std::string Name;
  std::string Failure;
  int Width = 0;
  int Height = 0;
  int Lights = 0;
  int Actors = 0;
  std::int64_t Triangles = 0;
  int ReferenceSamples = 0;
  ColorImage Reference;
  std::vector<ContestantResult> Contestants;
};

/// The machine and the run.
struct BenchmarkContext
{
  std::string Date;
  std::string Host;
  std::string Processor;
  int Processors = 0;
  std::string Renderer; ///< What OpenGL says of itself.
  std::string VtkVersion;
  std::string Version;
};

struct BenchmarkResults
{
  BenchmarkContext Context;
  std::vector<SceneResult> Scenes;
};

}

#endif
