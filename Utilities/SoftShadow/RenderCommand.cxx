// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RenderCommand.h"

#include "FrameReport.h"
#include "NumberRange.h"
#include "OutputFiles.h"
#include "SceneFrame.h"
#include "SceneInput.h"
#include "VirtualDisplay.h"

#include "ModelStore.h"
#include "PictureFile.h"
#include "SceneBuilder.h"
#include "VisibilityFile.h"

#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>

namespace softshadows
{
namespace
{

struct RenderOptions
{
  SceneInput Scene;
  TechniqueInput Technique;
  std::string Image;
  std::string Visibility;
  std::string Report;
  double Converge = 0.0; // 0: one frame
  int Frames = 4096;     // at most, with Converge
};

//--------------------------------------------------------------------------------------------------
/// Before anything is rendered: can the pictures be written in the formats that their names say?
void CheckFormats(const RenderOptions& options)
{
  if (options.Image.empty() && options.Visibility.empty() && options.Report.empty())
  {
    throw std::runtime_error("nothing to write: give -o, --visibility or --report");
  }
  if (!options.Image.empty() && !OIIO::ImageOutput::create(options.Image))
  {
    OIIO::geterror(); // else the library prints it when the program ends
    throw std::runtime_error(
      "-o " + options.Image + ": the ending is of no known format; png, jpg, tif and exr are");
  }
  const std::filesystem::path visibility(options.Visibility);
  if (!options.Visibility.empty() && visibility.extension() != ".exr")
  {
    throw std::runtime_error("--visibility " + options.Visibility + ": must end in .exr");
  }
}

//--------------------------------------------------------------------------------------------------
void WriteText(const std::string& path, const std::string& text)
{
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file)
  {
    throw std::runtime_error(path + ": cannot be written");
  }
}

//--------------------------------------------------------------------------------------------------
// A light that could throw shadows and does not is no error, but should not go unseen.
void SayWhichLightsCastNothing(const vtkSoftShadowPass* pass)
{
  std::istringstream lines(pass->GetLightReport());
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t colon = line.find(": ");
    if (line.compare(colon, 17, ": casts nothing: ") == 0 ||
      line.find(", but not with") != std::string::npos)
    {
      std::cerr << "softshadow: " << line << '\n';
    }
  }
}

//--------------------------------------------------------------------------------------------------
void Render(const RenderOptions& options)
{
  const Technique& technique = FindTechnique(options.Technique.Name);
  const vtkSmartPointer<vtkSoftShadowPass> pass =
    CreatePass(technique, options.Technique.GetOptions());
  CheckFormats(options);

  OutputFiles outputs(options.Scene.Files);
  const std::string image = outputs.Add(options.Image);
  const std::string visibility = outputs.Add(options.Visibility);
  const std::string report = outputs.Add(options.Report);

  ModelStore models(options.Scene.ModelFolders);
  const SceneDescription scene = options.Scene.Read(models);
  const BuiltScene built = BuildScene(scene, models);
  SayWhatIsNotShown(models);

  const VirtualDisplay display; // outlives the frame, whose window it shows
  // Never destroyed: VTK looks for each buffer that it frees among all of them, which takes longer than
  // the picture where there are thousands of objects. The process ends after this command.
  static SceneFrame* kept = nullptr;
  kept = new SceneFrame(built, pass, scene.Width, scene.Height);
  SceneFrame& frame = *kept;
  if (options.Converge > 0.0)
  {
    frame.Converge(options.Converge, options.Frames);
  }
  else
  {
    frame.Render();
  }
  outputs.Write(
    [&]
    {
      if (!image.empty())
      {
        WritePicture(image, scene.Width, scene.Height, frame.GetPicture());
      }
      if (!visibility.empty())
      {
        WriteVisibility(visibility, frame.GetVisibility());
      }
      if (!report.empty())
      {
        WriteText(report, ReportFrame(options.Scene.Files, technique, frame));
      }
    });
  outputs.Commit();
  if (!built.Lights.empty())
  {
    SayWhichLightsCastNothing(pass);
  }
  if (options.Converge > 0.0 && !pass->GetConverged())
  {
    std::cerr << "softshadow: not converged to " << options.Converge << " after "
              << pass->GetStatistics().Frames << " frames: " << pass->GetProgressReport() << '\n';
    throw CLI::RuntimeError(ExitNotConverged);
  }
}

}

//--------------------------------------------------------------------------------------------------
void AddRenderCommand(CLI::App& app)
{
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render",
    "Render a scene file, or models (ply, obj, stl, vtp, glb, gltf) on a ground plane under a key "
    "light. All files are written, or none.");
  options->Scene.AddTo(command);
  command->add_option("-o,--output", options->Image, "Write the picture: png, jpg, tif, exr, ...");
  options->Technique.AddTo(command);
  command->add_option("--visibility", options->Visibility,
    "Write the visibility of every light as OpenEXR, 32-bit float: channels V0, V1, ... (1 lit, 0 "
    "umbra, NaN no value) and depth");
  command->add_option(
    "--report", options->Report, "Write settings, counts and times of every step as JSON");
  CLI::Option* converge = command
                            ->add_option("--converge", options->Converge,
                              "Add points of the lights, frame by frame, until the estimated error "
                              "of the visibility's worst "
                              "tile of 32 x 32 pixels is under this; the report has the frames, "
                              "the error and whether it "
                              "converged; if it did not, files are written and the exit code is 2")
                            ->check(Number(0.0001, 1.0))
                            ->type_name("TOLERANCE");
  command->add_option("--converge-frames", options->Frames, "Frames at most, with --converge")
    ->check(WholeNumber(1, 1000000))
    ->needs(converge)
    ->capture_default_str();
  command->callback([options] { Render(*options); });
}

}
