// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TechniqueOptions.h"

#include "vtkNew.h"
#include "vtkScreenSpaceSoftShadowPass.h"
#include "vtkSeparableSoftShadowPass.h"

namespace softshadows
{
namespace
{

// The options of both techniques that shape their kernels.
template <typename Pass>
void AddKernelOptions(Technique& technique, Pass* pass)
{
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(
    pass, SearchWidth, "search_width", "taps along an edge of the search for blockers"));
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(
    pass, FilterWidth, "filter_width", "taps along an edge of the filter"));
  technique.Options.push_back(SOFTSHADOWS_CHOICE_OPTION(
    pass, Weights, "weights", "uniform light, or bright in its middle", { "mean", "gaussian" }));
}

}

//--------------------------------------------------------------------------------------------------
Technique MakeSeparableTechnique()
{
  vtkNew<vtkSeparableSoftShadowPass> owner;
  vtkSeparableSoftShadowPass* pass = owner;
  Technique technique = MakeTechnique(
    "sssm", "separable soft shadow mapping: pcss whose rows of taps serve many pixels", pass);
  technique.Papers = { "Buades et al. 2015" };
  AddKernelOptions(technique, pass);
  technique.Options.push_back(SOFTSHADOWS_NUMBER_OPTION(
    pass, Alpha, "alpha", "how far off the plane a row of the search may be; 0 reuses none"));
  technique.Options.push_back(SOFTSHADOWS_NUMBER_OPTION(
    pass, Beta, "beta", "how far off the plane a row of the filter may be; 0 reuses none"));
  technique.Options.push_back(SOFTSHADOWS_CHOICE_OPTION(pass, Reuse, "reuse",
    "shares of the kernel's depth, or of the light's and the view's", { "kernel", "published" }));
  technique.Options.push_back(SOFTSHADOWS_FLAG_OPTION(pass, Footprint, "footprint",
    "search and filter only where rays to the light can meet a blocker"));
  technique.Options.push_back(SOFTSHADOWS_CHOICE_OPTION(
    pass, RowAxis, "row_axis", "axis of the light that rows lie along", { "s", "t" }));
  technique.Options.push_back(SOFTSHADOWS_FLAG_OPTION(
    pass, CountReuse, "count_reuse", "count the rows that are reused, in the report"));
  technique.Options.push_back(SOFTSHADOWS_CHOICE_OPTION(pass, DebugView, "debug_view",
    "what is shown in place of visibility", { "none", "search_reuse", "filter_reuse" }));
  technique.Draft.Options = { { "search_width", "7" }, { "filter_width", "11" },
    { "map_size", "1024" }, { "weights", "mean" } };
  technique.Good.Options = { { "split", "2" }, { "search_width", "7" }, { "filter_width", "7" },
    { "alpha", "0.05" }, { "beta", "0.05" }, { "weights", "mean" } };
  technique.Best.Options = { { "split", "4" }, { "search_width", "7" }, { "filter_width", "7" },
    { "map_size", "4096" }, { "alpha", "0.02" }, { "beta", "0.02" }, { "weights", "mean" } };
  return technique;
}

//--------------------------------------------------------------------------------------------------
Technique MakeScreenSpaceTechnique()
{
  vtkNew<vtkScreenSpaceSoftShadowPass> owner;
  vtkScreenSpaceSoftShadowPass* pass = owner;
  Technique technique =
    MakeTechnique("ssabss", "the hard shadow, blurred on the screen by a bilateral filter", pass);
  technique.Papers = { "Zheng, Saito 2011", "MohammadBagher et al. 2010" };
  AddKernelOptions(technique, pass);
  technique.Options.push_back(SOFTSHADOWS_NUMBER_OPTION(
    pass, Beta, "beta", "distance to the plane that taps fade over, in view distances"));
  technique.Draft.Options = { { "split", "2" }, { "search_width", "5" }, { "filter_width", "7" },
    { "map_size", "512" }, { "weights", "mean" } };
  technique.Good.WhyNone =
    "it takes 16 parts of the light and five times the time; cascaded meets the class";
  technique.Best.WhyNone = "64 parts of the light still leave 0.009; cascaded meets the class";
  return technique;
}

}
