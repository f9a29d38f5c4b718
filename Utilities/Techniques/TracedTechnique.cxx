// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TechniqueOptions.h"

#include "vtkNew.h"
#include "vtkTracedSoftShadowPass.h"

namespace softshadows
{

Technique MakeTracedTechnique()
{
  vtkNew<vtkTracedSoftShadowPass> owner;
  vtkTracedSoftShadowPass* pass = owner;
  Technique technique = MakeTechnique(
    "traced", "exact rays to points of the light, traced on the processor; no depth maps", pass);
  technique.Options.push_back(
    SOFTSHADOWS_INTEGER_OPTION(pass, Rays, "rays", "rays to points of the light per pixel"));
  technique.Options.push_back(SOFTSHADOWS_FLAG_OPTION(
    pass, Filter, "filter", "take the mean of neighbours where the penumbra is wide"));
  technique.Options.push_back(SOFTSHADOWS_FLAG_OPTION(
    pass, Adaptive, "adaptive", "shoot more rays where neighbours disagree and it is narrow"));
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(
    pass, MostRays, "most_rays", "rays per pixel where adaptive wants more"));
  technique.Options.push_back(SOFTSHADOWS_CHOICE_OPTION(
    pass, Weights, "weights", "uniform light, or bright in its middle", { "mean", "gaussian" }));
  technique.Draft.Options = { { "rays", "2" }, { "adaptive", "off" } };
  technique.Best.Options = { { "rays", "8" }, { "most_rays", "64" } };
  return technique;
}

}
