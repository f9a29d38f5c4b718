// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Technique.h"

#include <nlohmann/json.hpp>

#include <ostream>

namespace softshadows
{
namespace
{

using Json = nlohmann::ordered_json;

//--------------------------------------------------------------------------------------------------
const char* NameOf(TechniqueOption::Kind kind)
{
  switch (kind)
  {
    case TechniqueOption::Kind::Integer:
      return "integer";
    case TechniqueOption::Kind::Number:
      return "number";
    case TechniqueOption::Kind::Flag:
      return "flag";
    default:
      return "choice";
  }
}

//--------------------------------------------------------------------------------------------------
// Flags as booleans, choices by name.
Json ValueToJson(const TechniqueOption& option, double value)
{
  switch (option.Is)
  {
    case TechniqueOption::Kind::Integer:
      return static_cast<int>(value);
    case TechniqueOption::Kind::Number:
      return value;
    case TechniqueOption::Kind::Flag:
      return value != 0.0;
    default:
      return option.Spell(value);
  }
}

//--------------------------------------------------------------------------------------------------
Json OptionToJson(const TechniqueOption& option, vtkSoftShadowPass* pass)
{
  Json json = { { "name", option.Name }, { "property", option.Property } };
  if (option.Index)
  {
    json["index"] = *option.Index;
  }
  json["kind"] = NameOf(option.Is);
  json["default"] = ValueToJson(option, option.Get(pass));
  if (option.Choices.empty())
  {
    json["least"] = ValueToJson(option, option.Least);
    json["most"] = ValueToJson(option, option.Most);
  }
  else
  {
    json["choices"] = option.Choices;
  }
  json["meaning"] = option.Meaning;
  return json;
}

//--------------------------------------------------------------------------------------------------
Json QualitiesToJson(const Technique& technique)
{
  Json json = Json::object();
  for (const QualityClass& quality : GetQualities())
  {
    const TechniqueQuality& settings = technique.FindQuality(quality.Name);
    json[quality.Name] = settings.Exists() ? Json::object() : Json(nullptr);
    for (const auto& [name, value] : settings.Options)
    {
      json[quality.Name][name] = value;
    }
  }
  return json;
}

//--------------------------------------------------------------------------------------------------
Json TechniqueToJson(const Technique& technique)
{
  const vtkSmartPointer<vtkSoftShadowPass> pass = technique.Create();
  Json json = { { "name", technique.Name }, { "class", pass->GetClassName() },
    { "meaning", technique.Meaning }, { "papers", technique.Papers },
    { "options", Json::array() } };
  for (const TechniqueOption& option : technique.Options)
  {
    json["options"].push_back(OptionToJson(option, pass));
  }
  json["qualities"] = QualitiesToJson(technique);
  return json;
}

}

//--------------------------------------------------------------------------------------------------
void PrintTechniquesAsJson(std::ostream& os)
{
  Json json = { { "techniques", Json::array() }, { "qualities", Json::array() } };
  for (const Technique& technique : GetTechniques())
  {
    json["techniques"].push_back(TechniqueToJson(technique));
  }
  for (const QualityClass& quality : GetQualities())
  {
    json["qualities"].push_back(
      { { "name", quality.Name }, { "largest_error", quality.LargestError } });
  }
  os << json.dump(2) << '\n';
}

}
