// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The viewer's menu, help and status as boxes on the screen: what stands where and what a click on
 * it does. Plain values; MenuPainter draws them.
 */

#ifndef MenuLayout_h
#define MenuLayout_h

#include "ViewerAction.h"
#include "ViewerState.h"

#include <array>
#include <string>
#include <vector>

namespace softshadows
{

/// Pixels; the origin is the window's lower left corner.
struct MenuRect
{
  int X = 0;
  int Y = 0;
  int Width = 0;
  int Height = 0;

  bool Contains(int x, int y) const
  {
    return x >= this->X && x < this->X + this->Width && y >= this->Y && y < this->Y + this->Height;
  }
};

struct MenuBox
{
  enum class Look
  {
    Panel,    ///< The ground that others stand on.
    Title,    ///< Large text.
    Heading,  ///< Of a section.
    Text,     ///< Plain.
    Faint,    ///< An explanation.
    Value,    ///< A number or a name that can be changed.
    Button,   ///< To be clicked.
    Chosen,   ///< A button whose choice is the one that holds.
    Selected, ///< The ground of the selected setting.
    Thumb     ///< How far a list is scrolled.
  };
  enum class Align
  {
    Left,
    Center,
    Right
  };

  MenuRect Place;
  Look Is = Look::Text;
  std::string Text;
  Align Aligned = Align::Left;
  ViewerAction Click;
};

/// What is shown beside the state.
struct MenuStatus
{
  std::array<std::string, 2> Lines; ///< Times and errors.
  std::string Message;              ///< Of the last thing done, such as a file that was saved.
};

/// Sizes in pixels, from the window's height.
struct MenuScale
{
  explicit MenuScale(int windowHeight);

  int Font;
  int Row;
  int Gap;
  int PanelWidth;
  int StatusHeight;
};

/// Where the scene is drawn: what menu and status leave of a window.
MenuRect GetSceneRoom(const ViewerState& state, int windowWidth, int windowHeight);

class MenuLayout
{
public:
  MenuLayout(const ViewerState& state, const MenuStatus& status, int width, int height);

  /// From the ground up.
  const std::vector<MenuBox>& GetBoxes() const { return this->Boxes; }
  const MenuScale& GetScale() const { return this->Scale; }

  /// Whether a point is on a panel, which keeps clicks from the scene.
  bool Covers(int x, int y) const;

  /// What a click there asks for.
  ViewerAction GetAction(int x, int y) const;

private:
  const ViewerState& State;
  MenuScale Scale;
  int Width;
  int Height;
  std::vector<MenuBox> Boxes;
  int Top = 0; ///< Where the next row of the menu ends.

  void AddMenu();
  void AddTechniques();
  void AddSettings(int rows);
  void AddSetting(const TechniqueOption& option, bool selected, int room);
  void AddLight();
  void AddStatus(const MenuStatus& status);
  void AddHelp();

  MenuRect TakeRow(int height);
  MenuRect TakeRow() { return this->TakeRow(this->Scale.Row); }
  void AddHeading(const std::string& text, const std::string& button, const ViewerAction& click);
  void AddNote(const std::string& text, int lines);
  void AddButtons(const std::vector<MenuBox>& buttons, int perRow);
  void AddSpinner(const MenuRect& place, const std::string& value, const ViewerAction& less,
    const ViewerAction& more);
  int GetRowsBesideSettings() const;
};

/// Cuts a text at spaces into lines of at most so many letters; longer words are cut.
std::vector<std::string> WrapText(const std::string& text, int letters);

}

#endif
