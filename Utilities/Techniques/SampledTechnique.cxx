// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TechniqueOptions.h"

#include "vtkNew.h"
#include "vtkSampledSoftShadowPass.h"

namespace softshadows
{

Technique MakeSampledTechnique()
{
  vtkNew<vtkSampledSoftShadowPass> owner;
  vtkSampledSoftShadowPass* pass = owner;
  Technique technique = MakeTechnique(
    "sampled", "the mean of hard shadows from points of the light; converges to the truth", pass);
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(
    pass, NumberOfSamples, "samples", "points of the light, a depth map each; 1 is a hard shadow"));
  technique.Options.push_back(SOFTSHADOWS_CHOICE_OPTION(pass, Pattern, "pattern",
    "how the points are spread", { "grid", "stratified", "hammersley", "sobol", "lattice" }));
  technique.Options.push_back(SOFTSHADOWS_CHOICE_OPTION(
    pass, Weights, "weights", "uniform light, or bright in its middle", { "mean", "gaussian" }));
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(pass, FilterSize, "filter_size",
    "texels along an edge of the filter over each map; 1 is none"));
  technique.Draft.Options = { { "samples", "4" }, { "map_size", "512" } };
  technique.Best.Options = { { "samples", "64" } };
  return technique;
}

}
