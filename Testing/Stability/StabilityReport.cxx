// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Prints Documentation/Stability.md: the matrix of hard cases and techniques, measured.
#include "HardCaseJudge.h"
#include "HardCases.h"
#include "Techniques.h"

#include <cstdio>
#include <exception>
#include <iostream>
#include <map>
#include <string>

using namespace SoftShadowsTesting;

namespace
{

using Pictures = std::map<std::string, Picture>;

//------------------------------------------------------------------------------
std::string Number(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.4f", value);
  return text;
}

//------------------------------------------------------------------------------
void PrintHead(const char* title)
{
  std::cout << "\n## " << title << "\n\n| case | what |";
  std::string line = "| --- | --- |";
  for (const Technique& technique : AllTechniques())
  {
    std::cout << ' ' << technique.Name << " |";
    line += " ---: |";
  }
  std::cout << '\n' << line << '\n';
}

//------------------------------------------------------------------------------
/// A line of the matrix, and what each technique drew.
Pictures PrintRow(const HardCase& hardCase)
{
  Pictures pictures;
  HardCaseJudge judge(hardCase);
  std::string row = "| " + hardCase.Name + " | " + hardCase.What + " |";
  for (const Technique& technique : AllTechniques())
  {
    const Judgement judgement = judge.Judge(technique);
    const Tolerance tolerance = ToleranceOf(technique.Name, hardCase.Name);
    const bool isOut = judgement.Rmse > tolerance.Most || judgement.Rmse < tolerance.Least;
    row += isOut ? " **" + Number(judgement.Rmse) + "** |" : " " + Number(judgement.Rmse) + " |";
    pictures[technique.Name] = judgement.Visibility;
  }
  std::cout << row << std::endl;
  return pictures;
}

//------------------------------------------------------------------------------
void PrintChanges(const std::vector<std::pair<std::string, Pictures>>& drawn)
{
  PrintHead("Change of the visibility");
  for (const auto& row : drawn)
  {
    std::cout << "| " << row.first << " | |";
    for (const Technique& technique : AllTechniques())
    {
      const Picture& first = drawn.front().second.at(technique.Name);
      std::cout << ' ' << Number(HardCaseJudge::Distance(first, row.second.at(technique.Name)))
                << " |";
    }
    std::cout << '\n';
  }
}

//------------------------------------------------------------------------------
void PrintIntroduction()
{
  std::cout << R"(# Stability

What the techniques make of hard cases. Printed by

    bash Utilities/Scripts/offscreen.sh build/release/bin/SoftShadowsStability > Documentation/Stability.md

The tests `Stability.*` draw the same scenes. Each figure must lie between half of its tolerance in
`Testing/Stability/HardCaseTolerances.inc` and the whole: one that is better asks to tighten it, unless the
tolerance is no larger than chance (0.004; 0.021, four pixels, under lights of no size).

Figures are root mean square errors of the visibility against the ray tracer (256 rays per pixel, itself
good to 0.005 in the penumbra), over all pixels of a picture of 96 x 96 that show the same surface in
both. Maps have 512 texels along an edge. 64 points stand for the light (32 for Bilateral, up to 81 for
AdaptiveSampled, 32 rays for Marched, 16 to 64 for Traced; 15 to 25 in `MillionTriangles`). Single pixels at a hard edge or a
silhouette that fall to the other side add 0.01 each. A figure in bold is outside of its tolerance.

Columns are named by class: Sampled is `sampled`, PercentageCloser `pcss`, Marched `marched`, Bilateral
`sbfs`, Separable `sssm`, Cascaded `cascaded`, AdaptiveSampled `fassalss`, Virtual `pvssm`, Traced `traced`.
)";
}

//------------------------------------------------------------------------------
void PrintKnownErrors()
{
  std::cout << R"(
## Known errors

Where a technique is worse by its nature, and why.

| technique | case | at most | reason |
| --- | --- | ---: | --- |
)";
  for (const KnownError& error : KnownErrors())
  {
    std::cout << "| " << error.TechniqueName << " | " << error.CaseName << " | "
              << ToleranceOf(error.TechniqueName, error.CaseName).Most << " | " << error.Reason
              << " |\n";
  }
}

//------------------------------------------------------------------------------
void PrintTests()
{
  std::cout << R"(
## What is tested where

Beside the cases above, by name (`ctest -N` lists them all). Most run with every technique.

| what | tests |
| --- | --- |
| scale, place, window, viewport, history, resize | `Invariance.*`, `Viewports.*`, `SharedPass.*` |
| large pictures in tiles, multisamples, opacity, both eyes in stereo, gradient and textured backgrounds, buffers kept for the next renderer, windows closed and opened again, picking by a hardware selector | `Windows.*` |
| lights and props that change while the camera rests | `Windows.ChangesUnderARestingCamera`, `Frames.LightsComeAndGo`, `Counts.*` |
| levels of detail that switch with the update rate | `LevelsOfDetail.*` |
| contacts, self-shadowing | `Surface.*` |
| no light, no caster, NaN, no area, lights on and in surfaces | `Degenerate.*` |
| Phong, Gouraud, PBR, composite data, glyphs, assemblies as casters and receivers | `Material.*` |
| textures, holes by alpha, clipping planes, scalar colours, vertex shaders, levels of detail, mirroring and nested matrices, edges, spheres, sticks, molecules against the same bodies in plain triangles | `VarietyTest.*` |
| wires, lines, points, tubes | `Frames.WiresLinesAndPointsCast` |
| SSAO, FXAA, SSAA, depth of field, tone mapping and EDL around the pass | `PassChain.*`, `Frames.AmbientOcclusionChangesNoVisibility` |
| translucent props with and without depth peeling, volumes | `Frames.TranslucentPropsWithDepthPeeling`, `Frames.VolumesStay` |
| thousands of frames, windows that come and go, OpenGL state, objects and errors | `Lifetime.*`, `Hygiene.*`, `PassSwitching.*` |
| settings out of range | `AreaLight.*`, `Techniques.*`, `RenderErrors.*` |
| scene files | `SceneErrors.*`, and the fuzz target |
| models that are cut, damaged, huge, of another kind | `ModelFiles.*` |
| outputs that are folders, links, devices, full; a tool that is ended by a signal | `RenderErrors.*`, `RenderFailures.*` |

What vtkShadowMapPass gets wrong has a test each, with that pass beside ours where it shows:

| fault | test |
| --- | --- |
| wrong shadows in windows that are not square | `Invariance.WindowShape`, `Stability` `WindowWide`, `WindowTall` |
| light leaks near contacts in deep scenes | `Surface.ShadowTouchesTheBoxInADeepScene` |
| no shadow on PBR from positional lights | `Material.ColourIsMultipliedByVisibility` |
| points outside the map too bright | `Pitfall.OutsideTheMapIsLitAsEver` |
| a changed input of the mapper does not count | `Pitfall.InputOfTheMapperChanges` |
| a new resolution is ignored | `Pitfall.MapSizeChangesAfterTheFirstFrame` |
| lights that are off shift the others | `Pitfall.LightThatIsOffStandsFirst` |
| translucent actors vanish | `Pitfall.TranslucentActorsStay` |
| background in the map, black translucent receivers | `Pitfall.BackgroundDoesNotShadow`, `Pitfall.TranslucentReceiverIsNotBlack` |
| casters out of view | `Pitfall.CasterLeavesTheView` |
| imposters cast billboards | `Pitfall.SphereImpostersCastSpheres` |
| headlights bake everything anew | `Pitfall.HeadlightsBakeNothing` |
| shaders built again and again | `Counts.ThousandActorsAndAMovingCamera` |
| lights that silently cast nothing | `Pitfall.OmniLightCastsToAllSides`, `Pitfall.LightsWithoutShadowAreReported` |
)";
}

//------------------------------------------------------------------------------
void PrintReport()
{
  PrintIntroduction();
  std::vector<std::pair<std::string, Pictures>> same;
  PrintHead("Invariance");
  for (const HardCase& hardCase : InvarianceCases())
  {
    Pictures pictures = PrintRow(hardCase);
    if (hardCase.SameAsFirst)
    {
      same.emplace_back(hardCase.Name, std::move(pictures));
    }
  }
  PrintChanges(same);
  PrintHead("Geometry");
  for (const HardCase& hardCase : GeometryCases())
  {
    PrintRow(hardCase);
  }
  PrintHead("Lights");
  for (const HardCase& hardCase : LightCases())
  {
    PrintRow(hardCase);
  }
  PrintKnownErrors();
  PrintTests();
}

}

//------------------------------------------------------------------------------
int main()
{
  try
  {
    PrintReport();
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
