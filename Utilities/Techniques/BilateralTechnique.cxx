// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TechniqueOptions.h"

#include "vtkBilateralSoftShadowPass.h"
#include "vtkNew.h"

namespace softshadows
{

Technique MakeBilateralTechnique()
{
  vtkNew<vtkBilateralSoftShadowPass> owner;
  vtkBilateralSoftShadowPass* pass = owner;
  Technique technique = MakeTechnique("sbfs",
    "soft bilateral filtering shadows: few points of the light, filtered on the screen", pass);
  technique.Papers = { "Ali, Kolivand, Sunar 2016" };
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(
    pass, NumberOfSamples, "samples", "points of the light, a depth map each"));
  technique.Options.push_back(SOFTSHADOWS_CHOICE_OPTION(
    pass, Weights, "weights", "uniform light, or bright in its middle", { "mean", "gaussian" }));
  technique.Options.push_back(SOFTSHADOWS_CHOICE_OPTION(pass, Filter, "filter",
    "how wide: as published, over a square, iterated, or as wide as the bands",
    { "none", "paper", "full", "atrous", "adaptive" }));
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(
    pass, FilterWidth, "filter_width", "taps along an edge of paper, full and atrous"));
  technique.Options.push_back(SOFTSHADOWS_NUMBER_OPTION(pass, DomainDeviation, "h_d",
    "standard deviation over the domain of paper, full and atrous, in taps"));
  technique.Options.push_back(SOFTSHADOWS_NUMBER_OPTION(
    pass, RangeDeviation, "h_r", "standard deviation over the range, in units of visibility"));
  technique.Options.push_back(
    SOFTSHADOWS_INTEGER_OPTION(pass, Iterations, "iterations", "of atrous"));
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(
    pass, MaximumWidth, "maximum_width", "the widest kernel of adaptive, in pixels"));
  technique.Options.push_back(
    SOFTSHADOWS_FLAG_OPTION(pass, SecondAxisFirst, "second_axis_first", "filter along y before x"));
  technique.Draft.Options = { { "samples", "4" }, { "map_size", "512" } };
  technique.Best.Options = { { "samples", "64" }, { "h_r", "0.1" } };
  return technique;
}

}
