// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "KeyBindings.h"

#include "Technique.h"

#include <algorithm>

namespace softshadows
{
namespace
{

using Kind = ViewerAction::Kind;

//--------------------------------------------------------------------------------------------------
std::vector<KeyBinding> MakeBindings()
{
  std::vector<KeyBinding> bindings = {
    { "t", { Kind::StepTechnique, 1, "" } },
    { "T", { Kind::StepTechnique, -1, "" } },
    { "Down", { Kind::StepSelection, 1, "" } },
    { "Up", { Kind::StepSelection, -1, "" } },
    { "Right", { Kind::StepOption, 1, "" } },
    { "Left", { Kind::StepOption, -1, "" } },
    { "c", { Kind::StepQuality, 1, "" } },
    { "p", { Kind::ToggleProgressive, 0, "" } },
    { "v", { Kind::StepView, 1, "" } },
    { "V", { Kind::StepView, -1, "" } },
    { "plus", { Kind::ScaleLight, 1, "" } },
    { "equal", { Kind::ScaleLight, 1, "" } }, // plus without Shift on many keyboards
    { "KP_Add", { Kind::ScaleLight, 1, "" } },
    { "minus", { Kind::ScaleLight, -1, "" } },
    { "KP_Subtract", { Kind::ScaleLight, -1, "" } },
    { "a", { Kind::TurnLight, -1, "" } },
    { "d", { Kind::TurnLight, 1, "" } },
    { "w", { Kind::RaiseLight, 1, "" } },
    { "s", { Kind::RaiseLight, -1, "" } },
    { "n", { Kind::ApproachLight, 1, "" } },
    { "f", { Kind::ApproachLight, -1, "" } },
    { "l", { Kind::StepLight, 1, "" } },
    { "L", { Kind::ResetLight, 0, "" } },
    { "g", { Kind::ToggleHandle, 0, "" } },
    { "r", { Kind::ResetCamera, 0, "" } },
    { "F2", { Kind::SavePicture, 0, "" } },
    { "F3", { Kind::SaveVisibility, 0, "" } },
    { "F4", { Kind::SaveScene, 0, "" } },
    { "m", { Kind::ToggleMenu, 0, "" } },
    { "h", { Kind::ToggleHelp, 0, "" } },
    { "F1", { Kind::ToggleHelp, 0, "" } },
    { "question", { Kind::ToggleHelp, 0, "" } },
    { "q", { Kind::Quit, 0, "" } },
  };
  const int digits = std::min<int>(9, static_cast<int>(GetTechniques().size()));
  for (int i = 0; i < digits; ++i)
  {
    bindings.push_back({ std::to_string(i + 1), { Kind::ChooseTechnique, i, "" } });
  }
  return bindings;
}

}

//--------------------------------------------------------------------------------------------------
const std::vector<KeyBinding>& GetKeyBindings()
{
  static const std::vector<KeyBinding> bindings = MakeBindings();
  return bindings;
}

//--------------------------------------------------------------------------------------------------
ViewerAction FindAction(const std::string& key)
{
  const std::vector<KeyBinding>& bindings = GetKeyBindings();
  const auto found = std::find_if(bindings.begin(), bindings.end(),
    [&key](const KeyBinding& binding) { return binding.Key == key; });
  return found == bindings.end() ? ViewerAction() : found->Does;
}

//--------------------------------------------------------------------------------------------------
const std::vector<HelpLine>& GetHelp()
{
  static const std::vector<HelpLine> help = {
    { "", "Mouse" },
    { "left drag", "turn the view; with Shift move it, with Ctrl roll it" },
    { "wheel, right drag", "nearer or farther" },
    { "drag the yellow ball", "move the light" },
    { "", "Technique and settings" },
    { "1 - 9, t, T", "choose a technique; the next, the one before" },
    { "Up, Down", "select a setting" },
    { "Left, Right", "change it" },
    { "c", "all settings: draft, good (the defaults), best" },
    { "p", "let the resting picture converge to the truth, or not" },
    { "v, V", "next view, view before: visibility, penumbra, error, ..." },
    { "", "Light" },
    { "+, -", "larger, smaller" },
    { "a, d, w, s", "turn it left, right, up, down" },
    { "n, f", "nearer, farther" },
    { "l, L", "the next light; this one back to where it was" },
    { "g", "hide or show its ball" },
    { "", "Save and leave" },
    { "F2, F3, F4", "save picture (PNG), visibility (EXR), scene (JSON)" },
    { "r", "camera back to where it was" },
    { "m, h, q", "hide or show the menu, this help (also F1), quit" },
  };
  return help;
}

}
