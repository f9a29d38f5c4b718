// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TechniqueOptions.h"

namespace softshadows
{

// A technique is one file with one such function, and its name in the table below.
Technique MakeSampledTechnique();
Technique MakePercentageCloserTechnique();
Technique MakeSeparableTechnique();
Technique MakeScreenSpaceTechnique();
Technique MakeCascadedTechnique();
Technique MakeBilateralTechnique();
Technique MakeVirtualTechnique();
Technique MakeMarchedTechnique();
Technique MakeAdaptiveSampledTechnique();
#ifdef SOFTSHADOWS_HAS_TRACED
Technique MakeTracedTechnique();
#endif

//--------------------------------------------------------------------------------------------------
const std::vector<Technique>& GetTechniques()
{
  static const std::vector<Technique> techniques = []
  {
    std::vector<Technique> all = {
      MakeSampledTechnique(),
      MakePercentageCloserTechnique(),
      MakeSeparableTechnique(),
      MakeScreenSpaceTechnique(),
      MakeCascadedTechnique(),
      MakeBilateralTechnique(),
      MakeVirtualTechnique(),
      MakeMarchedTechnique(),
      MakeAdaptiveSampledTechnique(),
#ifdef SOFTSHADOWS_HAS_TRACED
      MakeTracedTechnique(),
#endif
    };
    for (Technique& technique : all)
    {
      AddPictureOptions(technique, technique.Create());
    }
    return all;
  }();
  return techniques;
}

}
