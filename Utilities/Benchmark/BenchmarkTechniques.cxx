// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkTechniques.h"

#include "Technique.h"

namespace softshadows
{

//--------------------------------------------------------------------------------------------------
std::vector<KnownTechnique> ListTechniques()
{
  std::vector<KnownTechnique> known;
  for (const Technique& technique : GetTechniques())
  {
    known.push_back({ technique.Name, {} });
    for (const TechniqueOption& option : technique.Options)
    {
      known.back().Options.push_back(option.Name);
    }
  }
  return known;
}

//--------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkSoftShadowPass> CreateContestantPass(
  const std::string& technique, const TechniqueOptions& options)
{
  return CreatePass(FindTechnique(technique), OptionTexts(options.begin(), options.end()));
}

}
