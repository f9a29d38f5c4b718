// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Every hard case with every technique against the ray tracer.
#include "HardCaseJudge.h"
#include "HardCases.h"
#include "Techniques.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace SoftShadowsTesting;

namespace
{

// The visibility must not notice what an invariance changes.
const double LargestChange = 0.01;

class Stability : public testing::TestWithParam<HardCase>
{
};

//------------------------------------------------------------------------------
std::string NameOf(const testing::TestParamInfo<HardCase>& info)
{
  std::string name = info.param.Name;
  for (std::size_t minus = name.find('-'); minus != std::string::npos; minus = name.find('-'))
  {
    name.replace(minus, 1, "Minus");
  }
  return name;
}

//------------------------------------------------------------------------------
void ExpectGood(const Judgement& judgement, const Technique& technique, const HardCase& hardCase)
{
  const Tolerance tolerance = ToleranceOf(technique.Name, hardCase.Name);
  EXPECT_LE(judgement.Rmse, tolerance.Most) << "bias " << judgement.Bias;
  EXPECT_GE(judgement.Rmse, tolerance.Least)
    << "better than half of what is asked for: tighten it (tighten-tolerances.py)";
  EXPECT_LE(judgement.ShareUnlike, hardCase.LargestShareUnlike);
  EXPECT_EQ(judgement.OutOfRange, 0);
  EXPECT_EQ(judgement.OpenGLErrors, 0);
  // Only a known shadow makes the comparison mean something.
  EXPECT_GT(judgement.Shadowed, judgement.Compared / 100);
  EXPECT_GT(judgement.Compared, 1000);
}

}

//------------------------------------------------------------------------------
TEST_P(Stability, IsNearTheTruth)
{
  const HardCase& hardCase = this->GetParam();
  const HardCase& first = InvarianceCases().front();
  HardCaseJudge judge(hardCase);
  HardCaseJudge firstJudge(first);
  for (const Technique& technique : AllTechniques())
  {
    SCOPED_TRACE(technique.Name);
    const Judgement judgement = judge.Judge(technique);
    ExpectGood(judgement, technique, hardCase);
    if (hardCase.SameAsFirst)
    {
      const Picture expected = firstJudge.Judge(technique).Visibility;
      EXPECT_LE(HardCaseJudge::Distance(expected, judgement.Visibility), LargestChange);
    }
  }
}

//------------------------------------------------------------------------------
TEST(StabilityTable, HasATolerancePerCaseAndNoOther)
{
  std::vector<std::string> names;
  for (const auto& list : { InvarianceCases(), GeometryCases(), LightCases() })
  {
    for (const HardCase& hardCase : list)
    {
      names.push_back(hardCase.Name);
    }
  }
  EXPECT_EQ(CasesWithTolerances(), names);
  for (const KnownError& error : KnownErrors())
  {
    EXPECT_NO_THROW(ToleranceOf(error.TechniqueName, error.CaseName));
  }
}

//------------------------------------------------------------------------------
INSTANTIATE_TEST_SUITE_P(Invariance, Stability, testing::ValuesIn(InvarianceCases()), NameOf);
INSTANTIATE_TEST_SUITE_P(Geometry, Stability, testing::ValuesIn(GeometryCases()), NameOf);
INSTANTIATE_TEST_SUITE_P(Lights, Stability, testing::ValuesIn(LightCases()), NameOf);
