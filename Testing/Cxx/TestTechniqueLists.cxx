// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The tests' list of techniques and the tool's table name the same ones.
#include "Technique.h"
#include "Techniques.h"

#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

//------------------------------------------------------------------------------
TEST(TechniqueLists, NameTheSamePasses)
{
  std::set<std::string> tested;
  for (const SoftShadowsTesting::Technique& technique : SoftShadowsTesting::EveryTechnique())
  {
    tested.insert(
      technique.Make(SoftShadowsTesting::Effort::Quick, SoftShadowsTesting::Weights::Mean)
        ->GetClassName());
  }
  std::set<std::string> offered;
  for (const softshadows::Technique& technique : softshadows::GetTechniques())
  {
    offered.insert(technique.Create()->GetClassName());
  }
  EXPECT_EQ(tested, offered);
}
