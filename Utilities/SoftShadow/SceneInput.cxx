// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneInput.h"

#include "NumberRange.h"

#include "SceneReader.h"

#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <utility>

namespace softshadows
{
namespace
{

//--------------------------------------------------------------------------------------------------
bool IsScene(const std::string& file)
{
  return std::filesystem::path(file).extension() == ".json";
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
void SceneInput::AddTo(CLI::App* command)
{
  command->add_option("SCENE.json|MODEL", this->Files, "One scene file, or one or more models")
    ->required();
  AddRepeated(command, "--models", this->ModelFolders,
    "Folder in which models of the scene are looked for, after the scene's own; may be given again")
    ->type_name("DIR");
  command->add_option("--up", this->Up, "Which axis of models without a scene points up: x, y or z")
    ->transform(CLI::CheckedTransformer(std::vector<std::pair<std::string, UpAxis>>{
      { "x", UpAxis::X }, { "y", UpAxis::Y }, { "z", UpAxis::Z } }))
    ->default_str("y");
  constexpr int longestEdge = 16384;
  command->add_option("--width", this->Width, "Pixels, in place of the scene's")
    ->check(WholeNumber(1, longestEdge));
  command->add_option("--height", this->Height, "Pixels, in place of the scene's")
    ->check(WholeNumber(1, longestEdge));
}

//--------------------------------------------------------------------------------------------------
SceneDescription SceneInput::Read(ModelStore& models) const
{
  SceneDescription scene;
  if (IsScene(this->Files.front()) && this->Files.size() == 1)
  {
    scene = ReadScene(this->Files.front());
  }
  else
  {
    for (const std::string& file : this->Files)
    {
      if (IsScene(file))
      {
        throw std::runtime_error(file + ": give one scene, or models without a scene");
      }
    }
    scene = SceneAroundModels(this->Files, this->Up, models);
  }
  scene.Width = this->Width > 0 ? this->Width : scene.Width;
  scene.Height = this->Height > 0 ? this->Height : scene.Height;
  return scene;
}

//--------------------------------------------------------------------------------------------------
void SayWhatIsNotShown(const ModelStore& models)
{
  for (const std::string& line : models.GetNotShown())
  {
    std::cerr << "softshadow: " << line << '\n';
  }
}

//--------------------------------------------------------------------------------------------------
void TechniqueInput::AddTo(CLI::App* command)
{
  command
    ->add_option(
      "--technique", this->Name, "How shadows are made; see softshadow --list-techniques")
    ->capture_default_str();
  command->add_option("--quality", this->Quality,
    "Settings of the technique for an error class, as --list-techniques has them: draft, good or "
    "best; its defaults if left out; an --option wins over them");
  AddRepeated(command, "--option", this->Options,
    "NAME=VALUE: an option of the technique; may be given again")
    ->type_name("NAME=VALUE");
}

//--------------------------------------------------------------------------------------------------
OptionTexts TechniqueInput::GetOptions() const
{
  const Technique& technique = FindTechnique(this->Name);
  OptionTexts texts;
  if (!this->Quality.empty())
  {
    texts = technique.GetQualityOptions(this->Quality);
  }
  for (const std::string& text : this->Options)
  {
    texts.push_back(SplitOption(text));
  }
  return texts;
}

}
