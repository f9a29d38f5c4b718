// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DebugView.h"

namespace softshadows
{
namespace
{

const char* const TintOption = "tint";
const char* const DebugOption = "debug_view";

//--------------------------------------------------------------------------------------------------
void AddOptionViews(const TechniqueOption& option, std::vector<DebugView>& views)
{
  using Source = DebugView::Source;
  if (option.Name == TintOption)
  {
    views.push_back({ "cascades", "the picture, tinted by cascade: red, green, blue, yellow",
      Source::Picture, option.Name, 1.0 });
  }
  else if (option.Name == DebugOption)
  {
    for (std::size_t i = 1; i < option.Choices.size(); ++i) // 0 is none
    {
      views.push_back({ option.Choices[i], "the technique's own view of its " + option.Choices[i],
        Source::Visibility, option.Name, static_cast<double>(i) });
    }
  }
}

}

//--------------------------------------------------------------------------------------------------
std::vector<DebugView> GetDebugViews(const Technique& technique)
{
  using Source = DebugView::Source;
  std::vector<DebugView> views = {
    { "picture", "the scene as it is shaded", Source::Picture, "", 0.0 },
    { "visibility", "how much of the light each point sees: white all, black nothing",
      Source::Visibility, "", 0.0 },
    { "penumbra", "white lit, black umbra, bands of colour for every tenth between them",
      Source::Penumbra, "", 0.0 },
    { "error", "against ray tracing: blue too dark, red too bright, full colour at 0.25",
      Source::Error, "", 0.0 },
  };
  for (const TechniqueOption& option : technique.Options)
  {
    AddOptionViews(option, views);
  }
  return views;
}

//--------------------------------------------------------------------------------------------------
bool IsViewOption(const std::string& name)
{
  return name == TintOption || name == DebugOption;
}

}
