// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which key does what in the viewer: one table for the keys and for the help.
 */

#ifndef KeyBindings_h
#define KeyBindings_h

#include "ViewerAction.h"

#include <string>
#include <vector>

namespace softshadows
{

struct KeyBinding
{
  std::string Key; ///< Tk's name of the key as VTK gives it: "t", "F1", "Left".
  ViewerAction Does;
};

/// A line of the help: what to press, and what it does.
struct HelpLine
{
  std::string Keys; ///< Empty: Text is a heading.
  std::string Text;
};

const std::vector<KeyBinding>& GetKeyBindings();

/// None for keys without a binding.
ViewerAction FindAction(const std::string& key);

const std::vector<HelpLine>& GetHelp();

}

#endif
