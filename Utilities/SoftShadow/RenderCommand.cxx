// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RenderCommand.h"

#include "FrameReport.h"
#include "OutputFiles.h"
#include "SceneFrame.h"
#include "VirtualDisplay.h"

#include "DifferencePicture.h"
#include "ModelScene.h"
#include "ModelStore.h"
#include "SceneBuilder.h"
#include "SceneReader.h"
#include "Technique.h"
#include "VisibilityFile.h"

#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace softshadows
{
namespace
{

struct RenderOptions
{
  std::vector<std::string> Inputs;
  std::string Image;
  std::string Visibility;
  std::string Report;
  std::string TechniqueName = "pcss";
  std::string Quality = "good";
  std::vector<std::string> Options;
  std::vector<std::string> ModelFolders;
  UpAxis Up = UpAxis::Y;
  int Width = 0; // 0: the scene's
  int Height = 0;
  double Converge = 0.0; // 0: one frame
  int Frames = 4096;     // at most, with Converge
};

//--------------------------------------------------------------------------------------------------
bool IsScene(const std::string& file)
{
  return std::filesystem::path(file).extension() == ".json";
}

//--------------------------------------------------------------------------------------------------
SceneDescription ReadInput(const RenderOptions& options, ModelStore& models)
{
  SceneDescription scene;
  if (IsScene(options.Inputs.front()) && options.Inputs.size() == 1)
  {
    scene = ReadScene(options.Inputs.front());
  }
  else
  {
    for (const std::string& file : options.Inputs)
    {
      if (IsScene(file))
      {
        throw std::runtime_error(file + ": give one scene, or models without a scene");
      }
    }
    scene = SceneAroundModels(options.Inputs, options.Up, models);
  }
  scene.Width = options.Width > 0 ? options.Width : scene.Width;
  scene.Height = options.Height > 0 ? options.Height : scene.Height;
  return scene;
}

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
void Render(const RenderOptions& options)
{
  const Technique& technique = FindTechnique(options.TechniqueName);
  OptionTexts optionTexts = technique.FindQuality(options.Quality);
  for (const std::string& text : options.Options)
  {
    optionTexts.push_back(SplitOption(text)); // later ones win
  }
  const vtkSmartPointer<vtkSoftShadowPass> pass = CreatePass(technique, optionTexts);
  CheckFormats(options);

  OutputFiles outputs(options.Inputs);
  const std::string image = outputs.Add(options.Image);
  const std::string visibility = outputs.Add(options.Visibility);
  const std::string report = outputs.Add(options.Report);

  ModelStore models(options.ModelFolders);
  const SceneDescription scene = ReadInput(options, models);
  const BuiltScene built = BuildScene(scene, models);

  const VirtualDisplay display; // outlives the frame, whose window it shows
  SceneFrame frame(built, pass, scene.Width, scene.Height);
  if (options.Converge > 0.0)
  {
    frame.Converge(options.Converge, options.Frames);
    if (!pass->GetConverged())
    {
      std::cerr << "softshadow: not converged to " << options.Converge << " after "
                << pass->GetStatistics().Frames << " frames; estimated error "
                << pass->GetEstimatedError() << '\n';
    }
  }
  else
  {
    frame.Render();
  }
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
    WriteText(report, ReportFrame(options.Inputs, technique, frame));
  }
  outputs.Commit();
}

//--------------------------------------------------------------------------------------------------
/// Options that may be given again and again, one value each time.
CLI::Option* AddRepeated(CLI::App* command, const std::string& name,
  std::vector<std::string>& values, const std::string& description)
{
  return command->add_option(name, values, description)->allow_extra_args(false);
}

}

//--------------------------------------------------------------------------------------------------
void AddRenderCommand(CLI::App& app)
{
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render",
    "Render a scene file, or models (ply, obj, stl, vtp) on a ground plane under a key light. All "
    "files are written, or none.");
  command->add_option("SCENE.json|MODEL", options->Inputs, "One scene file, or one or more models")
    ->required();
  command->add_option("-o,--output", options->Image, "Write the picture: png, jpg, tif, exr, ...");
  command
    ->add_option("--technique", options->TechniqueName,
      "How shadows are made; see softshadow --list-techniques")
    ->capture_default_str();
  command
    ->add_option("--quality", options->Quality,
      "Settings of the technique: draft, good (its defaults) or best; an --option wins over them")
    ->capture_default_str();
  AddRepeated(command, "--option", options->Options,
    "NAME=VALUE: an option of the technique; may be given again")
    ->type_name("NAME=VALUE");
  AddRepeated(command, "--models", options->ModelFolders,
    "Folder in which models of the scene are looked for, after the scene's own; may be given again")
    ->type_name("DIR");
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
                              "the error and whether it came "
                              "to pass")
                            ->check(CLI::Range(0.0001, 1.0))
                            ->type_name("TOLERANCE");
  command->add_option("--converge-frames", options->Frames, "Frames at most, with --converge")
    ->check(CLI::Range(1, 1000000))
    ->needs(converge)
    ->capture_default_str();
  command
    ->add_option("--up", options->Up, "Which axis of models without a scene points up: x, y or z")
    ->transform(CLI::CheckedTransformer(std::vector<std::pair<std::string, UpAxis>>{
      { "x", UpAxis::X }, { "y", UpAxis::Y }, { "z", UpAxis::Z } }))
    ->default_str("y");
  constexpr int longestEdge = 16384;
  command->add_option("--width", options->Width, "Pixels, in place of the scene's")
    ->check(CLI::Range(1, longestEdge));
  command->add_option("--height", options->Height, "Pixels, in place of the scene's")
    ->check(CLI::Range(1, longestEdge));
  command->callback([options] { Render(*options); });
}

}
