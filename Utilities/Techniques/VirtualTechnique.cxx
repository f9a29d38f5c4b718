// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TechniqueOptions.h"

#include "vtkNew.h"
#include "vtkVirtualSoftShadowPass.h"

namespace softshadows
{

Technique MakeVirtualTechnique()
{
  vtkNew<vtkVirtualSoftShadowPass> owner;
  vtkVirtualSoftShadowPass* pass = owner;
  Technique technique = MakeTechnique(
    "pvssm", "predicted virtual soft shadow maps: tiles as fine as each penumbra needs", pass);
  technique.Papers = { "Shen et al. 2011" };
  technique.Options.push_back(SOFTSHADOWS_FLAG_OPTION(
    pass, Adaptive, "adaptive", "tiles of predicted resolution, or a single map of map_size"));
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(
    pass, FixedLevels, "fixed_levels", "halvings of the single map into tiles"));
  technique.Options.push_back(SOFTSHADOWS_FLAG_OPTION(pass, Antialiasing, "antialiasing",
    "the mean over a pixel's footprint, or what its centre sees"));
  technique.Options.push_back(SOFTSHADOWS_CHOICE_OPTION(pass, Metric, "metric",
    "prediction for moving or resting shadows", { "dynamic", "static", "automatic" }));
  technique.Options.push_back(SOFTSHADOWS_CHOICE_OPTION(
    pass, Weights, "weights", "uniform light, or bright in its middle", { "mean", "gaussian" }));
  technique.Options.push_back(SOFTSHADOWS_NUMBER_OPTION(
    pass, Quality, "quality", "factor on the predicted number of texels along an edge"));
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(
    pass, SearchMapSize, "search_map_size", "texels along an edge of the map for the search"));
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(
    pass, SearchWidth, "search_width", "blocks along an edge of the search for blockers"));
  technique.Options.push_back(
    SOFTSHADOWS_INTEGER_OPTION(pass, MaximumTiles, "maximum_tiles", "the most tiles of a light"));
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(pass, GridLatency, "grid_latency",
    "frames that the grid of wanted texels may be old, 0 or 1; -1: 1 on a graphics card"));
  technique.Options.push_back(SOFTSHADOWS_CHOICE_OPTION(pass, DebugView, "debug_view",
    "what is shown in place of visibility", { "none", "tiles", "resolution", "kernel" }));
  technique.Draft.Options = { { "quality", "0.5" } };
  technique.Good.Options = { { "split", "2" }, { "quality", "0.5" } };
  technique.Best.Options = { { "split", "4" }, { "quality", "1.5" } };
  return technique;
}

}
