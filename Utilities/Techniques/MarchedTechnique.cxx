// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TechniqueOptions.h"

#include "vtkMarchedSoftShadowPass.h"
#include "vtkNew.h"

namespace softshadows
{

Technique MakeMarchedTechnique()
{
  vtkNew<vtkMarchedSoftShadowPass> owner;
  vtkMarchedSoftShadowPass* pass = owner;
  Technique technique =
    MakeTechnique("marched", "rays to points of the light, marched through one depth map", pass);
  technique.Options.push_back(
    SOFTSHADOWS_INTEGER_OPTION(pass, Rays, "rays", "rays to points of the light"));
  technique.Options.push_back(
    SOFTSHADOWS_INTEGER_OPTION(pass, Steps, "steps", "steps along a ray"));
  technique.Options.push_back(SOFTSHADOWS_NUMBER_OPTION(
    pass, Thickness, "thickness", "how thick a blocker is taken to be, in steps"));
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(
    pass, Pattern, "pattern", "edge in pixels of the pattern of rays; 1: none"));
  technique.Options.push_back(SOFTSHADOWS_CHOICE_OPTION(
    pass, Weights, "weights", "uniform light, or bright in its middle", { "mean", "gaussian" }));
  technique.Draft.Options = { { "rays", "16" }, { "map_size", "512" } };
  technique.Good.Options = { { "split", "2" }, { "rays", "8" }, { "steps", "4" } };
  technique.Best.Options = { { "split", "4" }, { "rays", "16" }, { "steps", "4" },
    { "map_size", "4096" } };
  return technique;
}

}
