// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Technique.h"

#include "TechniqueOptions.h"

#include "Suggestion.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <stdexcept>

namespace softshadows
{
namespace
{

std::string SpellNumber(double value)
{
  // Every digit of a whole number; others are settings that people wrote.
  std::ostringstream text;
  text << std::setprecision(value == std::floor(value) ? 10 : 6) << value;
  return text.str();
}

/// The place of the text among the choices, or -1.
int PlaceOf(const std::vector<std::string>& choices, const std::string& text)
{
  const auto found = std::find(choices.begin(), choices.end(), text);
  return found == choices.end() ? -1 : static_cast<int>(found - choices.begin());
}

}

//--------------------------------------------------------------------------------------------------
double TechniqueOption::Parse(const std::string& text) const
{
  const std::string refused =
    "option '" + this->Name + "': must be " + this->SpellRange() + ", is '" + text + "'";
  if (this->Is == Kind::Flag || this->Is == Kind::Choice)
  {
    const int place = PlaceOf(this->Choices, text);
    const int flag = std::max(PlaceOf({ "false", "true" }, text), PlaceOf({ "0", "1" }, text));
    if (place < 0 && (flag < 0 || this->Is != Kind::Flag))
    {
      throw std::runtime_error(refused);
    }
    return std::max(place, this->Is == Kind::Flag ? flag : -1);
  }
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool isWhole = end != text.c_str() && *end == '\0';
  // Written so that nan is refused.
  if (!isWhole || !(value >= this->Least && value <= this->Most) ||
    (this->Is == Kind::Integer && value != std::floor(value)))
  {
    throw std::runtime_error(refused);
  }
  return value;
}

//--------------------------------------------------------------------------------------------------
std::string TechniqueOption::Spell(double value) const
{
  return this->Choices.empty() ? SpellNumber(value)
                               : this->Choices.at(static_cast<std::size_t>(value));
}

//--------------------------------------------------------------------------------------------------
std::string TechniqueOption::SpellRange() const
{
  if (this->Choices.empty())
  {
    return (this->Is == Kind::Integer ? "a whole number from " : "a number from ") +
      SpellNumber(this->Least) + " to " + SpellNumber(this->Most);
  }
  std::string text;
  for (const std::string& choice : this->Choices)
  {
    text += (text.empty() ? "" : " or ") + choice;
  }
  return text;
}

//--------------------------------------------------------------------------------------------------
const TechniqueOption& Technique::FindOption(const std::string& name) const
{
  std::vector<std::string> known;
  for (const TechniqueOption& option : this->Options)
  {
    if (option.Name == name)
    {
      return option;
    }
    known.push_back(option.Name);
  }
  throw std::runtime_error(
    "technique '" + this->Name + "' has no option '" + name + "'; " + DidYouMean(name, known));
}

//--------------------------------------------------------------------------------------------------
const std::vector<QualityClass>& GetQualities()
{
  static const std::vector<QualityClass> qualities = { { "draft", 0.05 }, { "good", 0.02 },
    { "best", 0.008 } };
  return qualities;
}

//--------------------------------------------------------------------------------------------------
const TechniqueQuality& Technique::FindQuality(const std::string& name) const
{
  std::vector<std::string> known;
  for (const QualityClass& quality : GetQualities())
  {
    known.push_back(quality.Name);
  }
  switch (PlaceOf(known, name))
  {
    case 0:
      return this->Draft;
    case 1:
      return this->Good;
    case 2:
      return this->Best;
    default:
      throw std::runtime_error("there is no quality '" + name + "'; " + DidYouMean(name, known));
  }
}

//--------------------------------------------------------------------------------------------------
const OptionTexts& Technique::GetQualityOptions(const std::string& name) const
{
  const TechniqueQuality& quality = this->FindQuality(name);
  if (!quality.Exists())
  {
    throw std::runtime_error(
      "technique '" + this->Name + "' has no quality '" + name + "': " + quality.WhyNone);
  }
  return quality.Options;
}

//--------------------------------------------------------------------------------------------------
const Technique& FindTechnique(const std::string& name)
{
  std::vector<std::string> known;
  for (const Technique& technique : GetTechniques())
  {
    if (technique.Name == name)
    {
      return technique;
    }
    known.push_back(technique.Name);
  }
#ifndef SOFTSHADOWS_HAS_TRACED
  if (name == "traced")
  {
    throw std::runtime_error("technique 'traced' is not built here: it needs Embree 3 or 4");
  }
#endif
  throw std::runtime_error("there is no technique '" + name + "'; " + DidYouMean(name, known));
}

//--------------------------------------------------------------------------------------------------
std::pair<std::string, std::string> SplitOption(const std::string& text)
{
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
  {
    throw std::runtime_error("option '" + text + "' is not of the form NAME=VALUE");
  }
  return { text.substr(0, equals), text.substr(equals + 1) };
}

//--------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkSoftShadowPass> CreatePass(
  const Technique& technique, const OptionTexts& options)
{
  vtkSmartPointer<vtkSoftShadowPass> pass = technique.Create();
  for (const auto& [name, text] : options)
  {
    const TechniqueOption& option = technique.FindOption(name);
    option.Set(pass, option.Parse(text));
  }
  return pass;
}

//--------------------------------------------------------------------------------------------------
std::string SpellOptions(const OptionTexts& options)
{
  std::string text;
  for (const auto& [name, value] : options)
  {
    text += (text.empty() ? "" : " ") + name + "=" + value;
  }
  return text.empty() ? "the defaults" : text;
}

//--------------------------------------------------------------------------------------------------
void PrintTechniques(std::ostream& os)
{
  for (const Technique& technique : GetTechniques())
  {
    os << technique.Name << "  " << technique.Meaning << '\n';
    const vtkSmartPointer<vtkSoftShadowPass> pass = technique.Create();
    for (const TechniqueOption& option : technique.Options)
    {
      os << "    " << option.Name << "=" << option.Spell(option.Get(pass)) << "  ("
         << option.SpellRange() << ")\n        " << option.Meaning << '\n';
    }
    for (const auto& [name, largestError] : GetQualities())
    {
      const TechniqueQuality& quality = technique.FindQuality(name);
      os << "    quality " << name << " (error up to " << largestError
         << "): " << (quality.Exists() ? SpellOptions(quality.Options) : "none; " + quality.WhyNone)
         << '\n';
    }
  }
}

//--------------------------------------------------------------------------------------------------
void AddCommonOptions(Technique& technique, vtkSoftShadowPass* pass)
{
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(
    pass, MapSize, "map_size", "texels along an edge of every depth map"));
  technique.Options.push_back(SOFTSHADOWS_INTEGER_OPTION(
    pass, Split, "split", "parts along an edge of every light, each with a depth map of its own"));
  technique.Options.push_back(SOFTSHADOWS_FLAG_OPTION(pass, EarlyOut, "early_out",
    "prove pixels lit or blocked before filtering them; the result is the same"));
}

//--------------------------------------------------------------------------------------------------
void AddPictureOptions(Technique& technique, vtkSoftShadowPass* pass)
{
  technique.Options.push_back(SOFTSHADOWS_FLAG_OPTION(pass, SmoothTerminator, "smooth_terminator",
    "shade coarse bodies with smooth normals as the smooth surfaces that they stand for"));
}

}
