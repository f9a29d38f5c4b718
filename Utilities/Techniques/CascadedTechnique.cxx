// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TechniqueOptions.h"

#include "vtkAdaptiveSampledSoftShadowPass.h"
#include "vtkCascadedSoftShadowPass.h"
#include "vtkNew.h"

#include <string>

namespace softshadows
{
namespace
{

// "edge_0" to "edge_3" and the like.
void AddCascadeOptions(Technique& technique, int cascade)
{
  using Pass = vtkCascadedSoftShadowPass;
  const std::string number = std::to_string(cascade);
  technique.Options.push_back(WithIndex(
    WithRange(
      MakeOption<Pass>(
        TechniqueOption::Kind::Integer, "SampleEdge", "edge_" + number,
        "points of the light along an edge in cascade " + number + ", 0 the nearest",
        [cascade](Pass* pass, double value)
        { pass->SetSampleEdge(cascade, static_cast<int>(value)); },
        [cascade](Pass* pass) { return static_cast<double>(pass->GetSampleEdge(cascade)); }),
      1, 32),
    cascade));
  technique.Options.push_back(WithIndex(
    WithChoices(
      MakeOption<Pass>(
        TechniqueOption::Kind::Choice, "Resolution", "resolution_" + number,
        "of the maps of cascade " + number + ": all, a half or a quarter of map_size",
        [cascade](Pass* pass, double value)
        { pass->SetResolution(cascade, static_cast<int>(value)); },
        [cascade](Pass* pass) { return static_cast<double>(pass->GetResolution(cascade)); }),
      { "high", "medium", "low" }),
    cascade));
  technique.Options.push_back(WithIndex(
    WithRange(
      MakeOption<Pass>(
        TechniqueOption::Kind::Integer, "FilterSize", "filter_" + number,
        "texels along an edge of filter=fixed over the maps of cascade " + number + "; 1 is none",
        [cascade](Pass* pass, double value)
        { pass->SetFilterSize(cascade, static_cast<int>(value)); },
        [cascade](Pass* pass) { return static_cast<double>(pass->GetFilterSize(cascade)); }),
      1, 15),
    cascade));
}

void AddRefinementOptions(Technique& technique, vtkCascadedSoftShadowPass* pass)
{
  technique.Options.push_back(SOFTSHADOWS_NUMBER_OPTION(pass, Tolerance, "tolerance",
    "change of a pixel's visibility from one grid of points to the next that counts as settled"));
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(
    pass, MaximumLevel, "level", "finest grid of points: 4, 9, 25 or 81"));
  technique.Options.push_back(SOFTSHADOWS_CHOICE_OPTION(
    pass, Weights, "weights", "uniform light, or bright in its middle", { "mean", "gaussian" }));
}

}

Technique MakeCascadedTechnique()
{
  vtkNew<vtkCascadedSoftShadowPass> owner;
  vtkCascadedSoftShadowPass* pass = owner;
  Technique technique = MakeTechnique("cascaded",
    "the mean of hard shadows from points of the light, fewer where the view is far", pass);
  technique.Papers = { "Zerari et al. 2023" };
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(
    pass, NumberOfCascades, "cascades", "parts of the view by depth, with maps of their own"));
  technique.Options.push_back(SOFTSHADOWS_NUMBER_OPTION(pass, SplitLambda, "lambda",
    "share of the logarithmic in the split of the view; the rest is uniform"));
  technique.Options.push_back(SOFTSHADOWS_NUMBER_OPTION(
    pass, BlendBand, "blend", "part of a cascade over which it blends into the next"));
  for (int i = 0; i < vtkCascadedSoftShadowPass::MaximumNumberOfCascades; ++i)
  {
    AddCascadeOptions(technique, i);
  }
  technique.Options.push_back(SOFTSHADOWS_CHOICE_OPTION(pass, Filter, "filter",
    "on the screen, over the shadow of a point's part of the light; or filter_0 and so on texels",
    { "screen", "fixed" }));
  technique.Options.push_back(SOFTSHADOWS_CHOICE_OPTION(
    pass, Pattern, "pattern", "how the points are spread", { "grid", "stratified", "hammersley" }));
  technique.Options.push_back(SOFTSHADOWS_FLAG_OPTION(pass, Adaptive, "adaptive",
    "as many points as each pixel needs, instead of edges and pattern"));
  AddRefinementOptions(technique, pass);
  technique.Options.push_back(SOFTSHADOWS_FLAG_OPTION(
    pass, FitToView, "fit_to_view", "cut the maps to what each cascade sees"));
  technique.Options.push_back(
    SOFTSHADOWS_FLAG_OPTION(pass, Tint, "tint", "tint the picture by cascade"));
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(pass, TintLight, "tint_light",
    "light by whose cascades the picture is tinted; -1 for the mean of all"));
  technique.Draft.Options = { { "edge_0", "2" }, { "edge_1", "2" }, { "edge_2", "1" },
    { "map_size", "512" } };
  technique.Best.Options = { { "edge_0", "8" }, { "edge_1", "8" }, { "edge_2", "8" },
    { "map_size", "2048" } };
  return technique;
}

Technique MakeAdaptiveSampledTechnique()
{
  vtkNew<vtkAdaptiveSampledSoftShadowPass> owner;
  vtkAdaptiveSampledSoftShadowPass* pass = owner;
  Technique technique = MakeTechnique(
    "fassalss", "hard shadows from as many points of the light as each pixel needs", pass);
  technique.Papers = { "Schwarzler et al. 2012" };
  AddRefinementOptions(technique, pass);
  technique.Draft.Options = { { "level", "1" }, { "map_size", "512" } };
  technique.Best.Options = { { "tolerance", "0.03" }, { "map_size", "2048" } };
  return technique;
}

}
