// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// A pipeline as in ParaView: a reader of a time series, contour, stream tubes, glyphs and a scalar bar,
// under a soft light. The program walks through the series, turns the camera and changes the colours, and
// proves by the pass's statistics that depth maps are baked only when the data changed.

#include "TimeSeries.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkArrowSource.h"
#include "vtkCamera.h"
#include "vtkContourFilter.h"
#include "vtkGlyph3DMapper.h"
#include "vtkLineSource.h"
#include "vtkLookupTable.h"
#include "vtkMaskPoints.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSampledSoftShadowPass.h"
#include "vtkScalarBarActor.h"
#include "vtkStreamTracer.h"
#include "vtkTubeFilter.h"
#include "vtkWindowToImageFilter.h"
#include "vtkXMLImageDataReader.h"

#include <cstdlib>
#include <iostream>
#include <string>

namespace
{

struct Pipeline
{
  vtkNew<vtkXMLImageDataReader> Reader;
  vtkNew<vtkContourFilter> Contour;
  vtkNew<vtkStreamTracer> Stream;
  vtkNew<vtkTubeFilter> Tubes;
  vtkNew<vtkGlyph3DMapper> Arrows;
  vtkNew<vtkLookupTable> Colors;
  vtkNew<vtkScalarBarActor> Bar;

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkSampledSoftShadowPass> Shadows;
  vtkNew<vtkRenderWindow> Window;
};

vtkActor* AddActor(vtkRenderer* renderer, vtkMapper* mapper)
{
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.2); // shadows are not black
  actor->GetProperty()->SetDiffuse(0.8);
  renderer->AddActor(actor);
  return actor; // the renderer holds it
}

// The drops' surface, coloured by height above the floor.
void AddContour(Pipeline& p)
{
  p.Contour->SetInputConnection(p.Reader->GetOutputPort());
  p.Contour->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "density");
  p.Contour->SetValue(0, 0.45);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(p.Contour->GetOutputPort());
  mapper->ScalarVisibilityOff();
  AddActor(p.Renderer, mapper)->GetProperty()->SetColor(0.9, 0.75, 0.55);
}

// Tubes around stream lines from a line of seeds, coloured by density.
void AddTubes(Pipeline& p)
{
  vtkNew<vtkLineSource> seeds;
  seeds->SetPoint1(0.9, 0.0, 0.15);
  seeds->SetPoint2(1.7, 0.0, 0.15);
  seeds->SetResolution(4);
  p.Stream->SetInputConnection(p.Reader->GetOutputPort());
  p.Stream->SetSourceConnection(seeds->GetOutputPort());
  p.Stream->SetMaximumPropagation(10.0);
  p.Stream->SetIntegratorTypeToRungeKutta4();
  p.Tubes->SetInputConnection(p.Stream->GetOutputPort());
  p.Tubes->SetRadius(0.04);
  p.Tubes->SetNumberOfSides(12);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(p.Tubes->GetOutputPort());
  mapper->SetLookupTable(p.Colors);
  mapper->UseLookupTableScalarRangeOn();
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("density");
  AddActor(p.Renderer, mapper);
}

// Arrows along the velocity at a few points: casters that are drawn by their own mapper.
void AddGlyphs(Pipeline& p)
{
  vtkNew<vtkMaskPoints> few;
  few->SetInputConnection(p.Reader->GetOutputPort());
  few->SetOnRatio(613);
  vtkNew<vtkArrowSource> arrow;
  p.Arrows->SetInputConnection(few->GetOutputPort());
  p.Arrows->SetSourceConnection(arrow->GetOutputPort());
  p.Arrows->SetOrientationArray("velocity");
  p.Arrows->SetScaling(true);
  p.Arrows->SetScaleFactor(0.22);
  p.Arrows->SetScaleModeToNoDataScaling();
  p.Arrows->ScalarVisibilityOff();
  AddActor(p.Renderer, p.Arrows)->GetProperty()->SetColor(0.35, 0.5, 0.75);
}

void AddFloorAndLamp(Pipeline& p)
{
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-20.0, -20.0, -0.1);
  floor->SetPoint1(20.0, -20.0, -0.1);
  floor->SetPoint2(-20.0, 20.0, -0.1);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(floor->GetOutputPort());
  AddActor(p.Renderer, mapper);
  vtkNew<vtkAreaLight> lamp;
  lamp->SetPosition(-2.5, -3.0, 6.5);
  lamp->SetFocalPoint(0.0, 0.0, 0.5);
  lamp->SetShapeToDisk();
  lamp->SetSize(1.2, 1.2);
  p.Renderer->AddLight(lamp);
}

void Build(Pipeline& p)
{
  p.Reader->SetFileName(StepFile(0).c_str());
  p.Colors->SetHueRange(0.66, 0.0);
  p.Colors->SetTableRange(0.0, 0.4);
  p.Colors->Build();
  AddContour(p);
  AddTubes(p);
  AddGlyphs(p);
  AddFloorAndLamp(p);
  p.Bar->SetLookupTable(p.Colors);
  p.Bar->SetTitle("density");
  p.Bar->SetNumberOfLabels(5);
  p.Renderer->AddViewProp(p.Bar);

  // Many maps: they are kept while the camera moves, and tubes at many depths need them.
  p.Shadows->SetNumberOfSamples(49);
  p.Shadows->SetMapSize(1024);
  vtkNew<vtkRenderStepsPass> steps; // its overlay step draws the scalar bar
  steps->SetOpaquePass(p.Shadows);
  p.Renderer->SetPass(steps);
  p.Renderer->SetBackground(0.9, 0.92, 0.95);
  vtkCamera* camera = p.Renderer->GetActiveCamera();
  camera->SetPosition(1.5, -7.5, 4.5);
  camera->SetFocalPoint(0.2, 0.0, 0.7);
  camera->SetViewUp(0.0, 0.0, 1.0);
  p.Renderer->ResetCameraClippingRange();
  p.Window->SetSize(640, 480);
  p.Window->SetWindowName("ScientificPipeline");
  p.Window->AddRenderer(p.Renderer);
}

// Draws a frame; false if it baked maps and should not have, or the other way round.
bool Draw(Pipeline& p, const std::string& what, bool mustBake)
{
  const vtkTypeInt64 before = p.Shadows->GetStatistics().MapsBaked;
  p.Window->Render();
  const vtkTypeInt64 baked = p.Shadows->GetStatistics().MapsBaked - before;
  std::cout << what << ": " << baked << " maps baked\n";
  return (baked > 0) == mustBake;
}

// The whole series, each step seen from three sides and in other colours.
bool Play(Pipeline& p)
{
  // The mapper of the glyphs sets itself up while it draws its first frame, which counts as a change.
  p.Window->Render();
  bool good = true;
  for (int step = 1; step < NumberOfSteps; ++step)
  {
    p.Reader->SetFileName(StepFile(step).c_str());
    good = Draw(p, "step " + std::to_string(step), true) && good;
    for (int i = 0; i < 2; ++i)
    {
      p.Renderer->GetActiveCamera()->Azimuth(4.0);
      good = Draw(p, "  camera turned", false) && good;
    }
    p.Renderer->GetActiveCamera()->Azimuth(-8.0);
    p.Colors->SetTableRange(0.0, 0.5 + 0.1 * step);
    good = Draw(p, "  colours changed", false) && good;
    p.Contour->Modified(); // runs again, with the same result
    good = Draw(p, "  contour computed anew", false) && good;
  }
  return good;
}

// False if the file cannot be written.
bool Save(vtkRenderWindow* window, const std::string& file)
{
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(file.c_str());
  writer->Write();
  return writer->GetErrorCode() == 0;
}

} // namespace

int main(int argc, char* argv[])
{
  const bool save = argc == 3 && std::string(argv[1]) == "-o";
  if (argc != 1 && !save)
  {
    std::cerr << "usage: ScientificPipeline [-o FILE.png]\n";
    return EXIT_FAILURE;
  }
  if (!WriteTimeSeries())
  {
    return EXIT_FAILURE;
  }
  Pipeline pipeline;
  Build(pipeline);
  pipeline.Window->SetOffScreenRendering(save);
  vtkNew<vtkRenderWindowInteractor> interactor;
  if (!save)
  {
    interactor->SetRenderWindow(pipeline.Window);
  }
  bool good = Play(pipeline);
  if (!good)
  {
    std::cerr << "maps were baked for nothing, or not baked for new data\n";
  }
  if (save)
  {
    good = Save(pipeline.Window, argv[2]) && good;
  }
  else
  {
    interactor->Start();
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
