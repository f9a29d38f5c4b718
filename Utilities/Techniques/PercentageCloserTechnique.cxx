// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TechniqueOptions.h"

#include "vtkNew.h"
#include "vtkPercentageCloserSoftShadowPass.h"

namespace softshadows
{

Technique MakePercentageCloserTechnique()
{
  vtkNew<vtkPercentageCloserSoftShadowPass> owner;
  vtkPercentageCloserSoftShadowPass* pass = owner;
  Technique technique = MakeTechnique(
    "pcss", "percentage-closer soft shadows: one depth map, a filter per pixel", pass);
  technique.Papers = { "Fernando 2005" };
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(
    pass, SearchWidth, "search_width", "taps along an edge of the search for blockers"));
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(
    pass, FilterWidth, "filter_width", "taps along an edge of the filter"));
  technique.Options.push_back(SOFTSHADOWS_CHOICE_OPTION(
    pass, Weights, "weights", "uniform light, or bright in its middle", { "mean", "gaussian" }));
  technique.Options.push_back(SOFTSHADOWS_FLAG_OPTION(pass, Footprint, "footprint",
    "search and filter only where rays to the light pass; off: as in the paper"));
  technique.Draft.Options = { { "search_width", "7" }, { "filter_width", "11" },
    { "map_size", "1024" } };
  technique.Good.Options = { { "split", "2" }, { "search_width", "7" }, { "filter_width", "11" } };
  technique.Best.Options = { { "split", "4" }, { "search_width", "7" }, { "filter_width", "7" },
    { "map_size", "4096" } };
  return technique;
}

}
