// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HardCaseJudge.h
 * @brief Draws a hard case with a technique and measures the result against the ray tracer.
 */

#ifndef SoftShadowsTesting_HardCaseJudge_h
#define SoftShadowsTesting_HardCaseJudge_h

#include "HardCases.h"
#include "Picture.h"
#include "Techniques.h"

#include <memory> // For the stage
#include <string> // For complaints
#include <vector> // For lists

namespace SoftShadowsTesting
{

class Stage;

struct Judgement
{
  /// Root mean square and mean of estimate - truth, over pixels that show the same surface in both.
  double Rmse = 0.0;
  double Bias = 0.0;
  /// Share of all pixels that show another surface, or have a visibility in one picture only.
  double ShareUnlike = 0.0;
  /// Pixels that were compared, and those of them that the truth has in shadow (below 0.9).
  int Compared = 0;
  int Shadowed = 0;
  /// Visibilities outside [0, 1].
  int OutOfRange = 0;
  /// Errors that OpenGL reported.
  int OpenGLErrors = 0;
  Picture Visibility;
};

class HardCaseJudge
{
public:
  explicit HardCaseJudge(const HardCase& hardCase);
  ~HardCaseJudge();

  Judgement Judge(const Technique& technique);

  /// Root mean square of the difference, over pixels with a value in both.
  static double Distance(const Picture& first, const Picture& second);

private:
  void Trace();

  HardScene Scene;
  Effort Settings;
  std::unique_ptr<Stage> Window;
  /// Bottom row first.
  Picture Truth;
  Picture TrueDepth;
};

/// What the root mean square error of a technique in a case must lie between.
struct Tolerance
{
  /// Half of Most: a smaller error is better than what is asked for, which is to be tightened. 0 where
  /// Most is no larger than chance.
  double Least;
  double Most;
};

/// Throws std::out_of_range for cases and techniques that the table does not have.
Tolerance ToleranceOf(const std::string& techniqueName, const std::string& caseName);

/// The cases of the table, in its order.
std::vector<std::string> CasesWithTolerances();

/// A case that a technique does worse in by its nature, and why.
struct KnownError
{
  std::string TechniqueName;
  std::string CaseName;
  std::string Reason;
};

const std::vector<KnownError>& KnownErrors();

}

#endif
