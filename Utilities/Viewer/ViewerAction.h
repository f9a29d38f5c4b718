// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a key or a click in the viewer asks for.
 */

#ifndef ViewerAction_h
#define ViewerAction_h

#include <string>

namespace softshadows
{

struct ViewerAction
{
  enum class Kind
  {
    None,
    ///@{
    /// Changes of the ViewerState.
    ChooseTechnique, ///< Step: place in the table of techniques.
    StepTechnique,   ///< Step: how many places on, around the end.
    SelectOption,    ///< Name.
    StepSelection,   ///< Step: how many rows of the settings on.
    StepOption,      ///< Name, or empty: the selected one. Step: how many steps up.
    ChooseQuality,   ///< Step: place in GetQualities().
    StepQuality,
    ChooseView, ///< Step: place among the technique's views.
    StepView,
    StepLight,
    ScaleLight,    ///< Step: above 0 larger.
    TurnLight,     ///< Step: around the axis that points up, above 0 to the right.
    RaiseLight,    ///< Step: above 0 higher.
    ApproachLight, ///< Step: above 0 nearer.
    ResetLight,
    ToggleHelp,
    ToggleMenu,
    ToggleHandle,
    ToggleProgressive,
    ///@}
    ///@{
    /// For the window.
    ResetCamera,
    SavePicture,
    SaveVisibility,
    SaveScene,
    Quit
    ///@}
  };

  Kind Is = Kind::None;
  int Step = 0;
  std::string Name;
};

inline bool operator==(const ViewerAction& a, const ViewerAction& b)
{
  return a.Is == b.Is && a.Step == b.Step && a.Name == b.Name;
}

}

#endif
