// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewerState.h"

#include "LightMotion.h"
#include "OptionSteps.h"

#include <algorithm>
#include <cmath>

namespace softshadows
{
namespace
{

using Kind = ViewerAction::Kind;

constexpr double DegreesPerStep = 5.0;
constexpr double SizePerStep = 1.25;
constexpr double DistancePerStep = 1.1;

//--------------------------------------------------------------------------------------------------
int Around(int place, std::size_t count)
{
  const int size = static_cast<int>(count);
  return ((place % size) + size) % size;
}

}

//--------------------------------------------------------------------------------------------------
ViewerState::ViewerState(
  SceneDescription scene, const std::string& technique, const OptionTexts& options)
  : Scene(std::move(scene))
  , FirstLights(Scene.Lights)
  , Up(NearestAxis(Scene.Camera ? Scene.Camera->ViewUp : Vector3{ { 0.0, 1.0, 0.0 } }))
{
  const Technique& first = FindTechnique(technique);
  for (const Technique& each : GetTechniques())
  {
    const vtkSmartPointer<vtkSoftShadowPass> pass = each.Create();
    Values values;
    for (const TechniqueOption& option : each.Options)
    {
      values.Defaults[option.Name] = option.Get(pass);
    }
    values.Current = values.Defaults;
    this->Options.push_back(values);
  }
  this->TechniquePlace = static_cast<int>(&first - GetTechniques().data());
  this->Views = GetDebugViews(first);
  for (const auto& [name, text] : options)
  {
    this->Options[this->TechniquePlace].Current[name] = first.FindOption(name).Parse(text);
  }
}

//--------------------------------------------------------------------------------------------------
void ViewerState::Changed(Change what)
{
  if (this->Notify)
  {
    this->Notify(what);
  }
}

//--------------------------------------------------------------------------------------------------
bool ViewerState::Perform(const ViewerAction& action)
{
  bool* toggled = nullptr;
  switch (action.Is)
  {
    case Kind::ChooseTechnique:
      this->SetTechnique(action.Step);
      return true;
    case Kind::StepTechnique:
      this->SetTechnique(Around(this->TechniquePlace + action.Step, GetTechniques().size()));
      return true;
    case Kind::ChooseView:
      this->SetView(action.Step);
      return true;
    case Kind::StepView:
      this->SetView(Around(this->ViewPlace + action.Step, this->Views.size()));
      return true;
    case Kind::ToggleHelp:
      toggled = &this->HelpOpen;
      break;
    case Kind::ToggleMenu:
      toggled = &this->MenuOpen;
      break;
    case Kind::ToggleHandle:
      toggled = &this->HandleShown;
      break;
    case Kind::ToggleProgressive:
      this->Progressive = !this->Progressive;
      this->Changed(Change::Options);
      return true;
    default:
      return this->PerformOnOptions(action) || this->PerformOnLight(action);
  }
  *toggled = !*toggled;
  this->Changed(Change::Menu);
  return true;
}

//--------------------------------------------------------------------------------------------------
bool ViewerState::PerformOnOptions(const ViewerAction& action)
{
  const std::vector<const TechniqueOption*> settings = this->GetSettings();
  const auto place = [&settings](const std::string& name)
  {
    const auto found = std::find_if(settings.begin(), settings.end(),
      [&name](const TechniqueOption* option) { return option->Name == name; });
    return static_cast<int>(found - settings.begin());
  };
  switch (action.Is)
  {
    case Kind::SelectOption:
      this->SetSelection(place(action.Name));
      return true;
    case Kind::StepSelection:
      this->SetSelection(this->Selection + action.Step);
      return true;
    case Kind::StepOption:
    {
      if (!action.Name.empty())
      {
        this->SetSelection(place(action.Name));
      }
      const TechniqueOption& option = *settings[this->Selection];
      this->SetOption(option.Name, StepValue(option, this->GetOption(option.Name), action.Step));
      return true;
    }
    case Kind::ChooseQuality:
      this->SetQuality(std::clamp(action.Step, 0, static_cast<int>(GetQualities().size()) - 1));
      return true;
    case Kind::StepQuality:
      this->StepQuality(action.Step);
      return true;
    default:
      return false;
  }
}

//--------------------------------------------------------------------------------------------------
bool ViewerState::PerformOnLight(const ViewerAction& action)
{
  static const Kind kinds[] = { Kind::StepLight, Kind::ScaleLight, Kind::TurnLight,
    Kind::RaiseLight, Kind::ApproachLight, Kind::ResetLight };
  if (std::find(std::begin(kinds), std::end(kinds), action.Is) == std::end(kinds))
  {
    return false;
  }
  if (!this->HasLight())
  {
    return true;
  }
  LightDescription& light = this->Scene.Lights[this->LightPlace];
  switch (action.Is)
  {
    case Kind::StepLight:
      this->LightPlace = Around(this->LightPlace + action.Step, this->Scene.Lights.size());
      this->Changed(Change::Menu);
      return true;
    case Kind::ScaleLight:
      ScaleLightSize(light, std::pow(SizePerStep, action.Step));
      break;
    case Kind::TurnLight:
      TurnLight(light, this->Up, action.Step * DegreesPerStep);
      break;
    case Kind::RaiseLight:
      RaiseLight(light, this->Up, action.Step * DegreesPerStep);
      break;
    case Kind::ApproachLight:
      ScaleLightDistance(light, std::pow(DistancePerStep, -action.Step));
      break;
    default:
      light = this->FirstLights[this->LightPlace];
  }
  this->Changed(Change::Light);
  return true;
}

//--------------------------------------------------------------------------------------------------
const Technique& ViewerState::GetTechnique() const
{
  return GetTechniques()[this->TechniquePlace];
}

//--------------------------------------------------------------------------------------------------
void ViewerState::SetTechnique(int place)
{
  place = std::clamp(place, 0, static_cast<int>(GetTechniques().size()) - 1);
  if (place == this->TechniquePlace)
  {
    return;
  }
  const std::string view = this->GetView().Name;
  this->TechniquePlace = place;
  this->Selection = 0;
  // The same view where the technique has it, else the picture.
  this->Views = GetDebugViews(this->GetTechnique());
  const auto same = std::find_if(this->Views.begin(), this->Views.end(),
    [&view](const DebugView& each) { return each.Name == view; });
  this->ViewPlace = same == this->Views.end() ? 0 : static_cast<int>(same - this->Views.begin());
  this->Changed(Change::Technique);
}

//--------------------------------------------------------------------------------------------------
double ViewerState::GetOption(const std::string& name) const
{
  this->GetTechnique().FindOption(name); // throws
  return this->Options[this->TechniquePlace].Current.at(name);
}

//--------------------------------------------------------------------------------------------------
double ViewerState::GetDefault(const std::string& name) const
{
  this->GetTechnique().FindOption(name); // throws
  return this->Options[this->TechniquePlace].Defaults.at(name);
}

//--------------------------------------------------------------------------------------------------
void ViewerState::SetOption(const std::string& name, double value)
{
  const TechniqueOption& option = this->GetTechnique().FindOption(name);
  const bool isNamed = !option.Choices.empty();
  const double least = isNamed ? 0.0 : option.Least;
  const double most = isNamed ? static_cast<double>(option.Choices.size()) - 1.0 : option.Most;
  double& current = this->Options[this->TechniquePlace].Current[name];
  value = std::clamp(value, least, most);
  if (value != current)
  {
    current = value;
    this->Changed(Change::Options);
  }
}

//--------------------------------------------------------------------------------------------------
std::map<std::string, double> ViewerState::GetQualityValues(int place) const
{
  const Technique& technique = this->GetTechnique();
  std::map<std::string, double> values = this->Options[this->TechniquePlace].Defaults;
  for (const auto& [name, text] : technique.GetQualityOptions(GetQualities()[place].Name))
  {
    values[name] = technique.FindOption(name).Parse(text);
  }
  return values;
}

//--------------------------------------------------------------------------------------------------
bool ViewerState::HasQuality(int place) const
{
  return this->GetTechnique().FindQuality(GetQualities()[place].Name).Exists();
}

//--------------------------------------------------------------------------------------------------
void ViewerState::StepQuality(int steps)
{
  int place = this->GetQualityPlace();
  std::size_t tried = 0;
  do
  {
    place = Around(place + steps, GetQualities().size());
  } while (!this->HasQuality(place) && ++tried < GetQualities().size());
  this->SetQuality(place);
}

//--------------------------------------------------------------------------------------------------
void ViewerState::SetQuality(int place)
{
  if (!this->HasQuality(place))
  {
    return;
  }
  std::map<std::string, double>& current = this->Options[this->TechniquePlace].Current;
  const std::map<std::string, double> values = this->GetQualityValues(place);
  if (current != values)
  {
    current = values;
    this->Changed(Change::Options);
  }
}

//--------------------------------------------------------------------------------------------------
int ViewerState::GetQualityPlace() const
{
  const std::map<std::string, double>& current = this->Options[this->TechniquePlace].Current;
  for (int place = 0; place < static_cast<int>(GetQualities().size()); ++place)
  {
    if (this->HasQuality(place) && this->GetQualityValues(place) == current)
    {
      return place;
    }
  }
  return -1;
}

//--------------------------------------------------------------------------------------------------
void ViewerState::Apply(vtkSoftShadowPass* pass) const
{
  const DebugView& view = this->GetView();
  for (const TechniqueOption& option : this->GetTechnique().Options)
  {
    const double value = option.Name == view.Option ? view.Value : this->GetOption(option.Name);
    // Setters without a comparison of their own would have the pass compute its shadows anew.
    if (option.Get(pass) != value)
    {
      option.Set(pass, value);
    }
  }
}

//--------------------------------------------------------------------------------------------------
bool ViewerState::HasGaussianWeights() const
{
  const std::map<std::string, double>& values = this->Options[this->TechniquePlace].Current;
  const auto weights = values.find("weights");
  return weights != values.end() &&
    this->GetTechnique().FindOption("weights").Spell(weights->second) == "gaussian";
}

//--------------------------------------------------------------------------------------------------
std::vector<const TechniqueOption*> ViewerState::GetSettings() const
{
  std::vector<const TechniqueOption*> settings;
  for (const TechniqueOption& option : this->GetTechnique().Options)
  {
    if (!IsViewOption(option.Name))
    {
      settings.push_back(&option);
    }
  }
  return settings;
}

//--------------------------------------------------------------------------------------------------
void ViewerState::SetSelection(int place)
{
  place = std::clamp(place, 0, static_cast<int>(this->GetSettings().size()) - 1);
  if (place != this->Selection)
  {
    this->Selection = place;
    this->Changed(Change::Menu);
  }
}

//--------------------------------------------------------------------------------------------------
void ViewerState::SetView(int place)
{
  place = std::clamp(place, 0, static_cast<int>(this->Views.size()) - 1);
  if (place != this->ViewPlace)
  {
    this->ViewPlace = place;
    this->Changed(Change::Options);
  }
}

//--------------------------------------------------------------------------------------------------
void ViewerState::SetLightPosition(const Vector3& position)
{
  LightDescription& light = this->Scene.Lights[this->LightPlace];
  // On the focal point it would have no direction.
  if (position != light.Position && position != light.FocalPoint)
  {
    light.Position = position;
    this->Changed(Change::Light);
  }
}

//--------------------------------------------------------------------------------------------------
void ViewerState::SetImageSize(int width, int height)
{
  this->Scene.Width = width;
  this->Scene.Height = height;
}

}
