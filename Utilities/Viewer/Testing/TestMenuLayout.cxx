// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The menu's boxes: all on the screen, none over another, each doing what it says.
#include "MenuLayout.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace softshadows;
using Kind = ViewerAction::Kind;
using Look = MenuBox::Look;

namespace
{

//--------------------------------------------------------------------------------------------------
SceneDescription MakeScene()
{
  SceneDescription scene;
  scene.Lights.resize(2);
  return scene;
}

//--------------------------------------------------------------------------------------------------
bool IsInside(const MenuRect& inner, int width, int height)
{
  return inner.X >= 0 && inner.Y >= 0 && inner.X + inner.Width <= width &&
    inner.Y + inner.Height <= height;
}

//--------------------------------------------------------------------------------------------------
bool Overlap(const MenuRect& a, const MenuRect& b)
{
  return a.X < b.X + b.Width && b.X < a.X + a.Width && a.Y < b.Y + b.Height && b.Y < a.Y + a.Height;
}

//--------------------------------------------------------------------------------------------------
const MenuBox* FindBox(const MenuLayout& layout, const ViewerAction& action)
{
  for (const MenuBox& box : layout.GetBoxes())
  {
    if (box.Click == action)
    {
      return &box;
    }
  }
  return nullptr;
}

//--------------------------------------------------------------------------------------------------
struct WindowSize
{
  int Width;
  int Height;
};

class MenuLayouts : public testing::TestWithParam<WindowSize>
{
protected:
  ViewerState State{ MakeScene(), "pcss" };
  MenuStatus Status{ { "one", "two" }, "" };

  MenuLayout LayOut() const
  {
    return MenuLayout(this->State, this->Status, GetParam().Width, GetParam().Height);
  }
};

}

//--------------------------------------------------------------------------------------------------
TEST_P(MenuLayouts, EveryTechniqueFitsTheWindow)
{
  for (std::size_t place = 0; place < GetTechniques().size(); ++place)
  {
    this->State.SetTechnique(static_cast<int>(place));
    const MenuLayout layout = this->LayOut();
    std::vector<const MenuBox*> clickable;
    for (const MenuBox& box : layout.GetBoxes())
    {
      EXPECT_TRUE(IsInside(box.Place, GetParam().Width, GetParam().Height))
        << GetTechniques()[place].Name << ": " << box.Text << " at " << box.Place.Y;
      if (box.Click.Is == Kind::None)
      {
        continue;
      }
      for (const MenuBox* other : clickable)
      {
        EXPECT_FALSE(Overlap(box.Place, other->Place)) << box.Text << " and " << other->Text;
      }
      clickable.push_back(&box);
    }
  }
}

//--------------------------------------------------------------------------------------------------
TEST_P(MenuLayouts, EverySettingCanBeReached)
{
  for (std::size_t place = 0; place < GetTechniques().size(); ++place)
  {
    this->State.SetTechnique(static_cast<int>(place));
    for (const TechniqueOption* option : this->State.GetSettings())
    {
      this->State.Perform({ Kind::SelectOption, 0, option->Name });
      const MenuLayout layout = this->LayOut();
      EXPECT_TRUE(FindBox(layout, { Kind::StepOption, -1, option->Name })) << option->Name;
      EXPECT_TRUE(FindBox(layout, { Kind::StepOption, 1, option->Name })) << option->Name;
    }
  }
}

//--------------------------------------------------------------------------------------------------
TEST_P(MenuLayouts, AClickDoesWhatItsBoxSays)
{
  const MenuLayout layout = this->LayOut();
  int boxes = 0;
  for (const MenuBox& box : layout.GetBoxes())
  {
    if (box.Click.Is != Kind::None)
    {
      ++boxes;
      const int x = box.Place.X + box.Place.Width / 2;
      const int y = box.Place.Y + box.Place.Height / 2;
      EXPECT_EQ(layout.GetAction(x, y), box.Click) << box.Text;
      EXPECT_TRUE(layout.Covers(x, y)) << box.Text;
    }
  }
  EXPECT_GT(boxes, 30);
}

//--------------------------------------------------------------------------------------------------
TEST_P(MenuLayouts, TheSceneHasTheRestOfTheWindow)
{
  const MenuRect room = GetSceneRoom(this->State, GetParam().Width, GetParam().Height);
  MenuLayout layout = this->LayOut();
  EXPECT_FALSE(layout.Covers(room.X, room.Y));
  EXPECT_FALSE(layout.Covers(room.X + room.Width - 1, room.Y + room.Height - 1));
  EXPECT_TRUE(layout.Covers(room.X - 1, room.Y));
  EXPECT_TRUE(layout.Covers(room.X, room.Y - 1));

  this->State.Perform({ Kind::ToggleMenu, 0, "" });
  EXPECT_EQ(GetSceneRoom(this->State, GetParam().Width, GetParam().Height).Width, GetParam().Width);
  EXPECT_FALSE(this->LayOut().Covers(5, GetParam().Height - 5));
}

//--------------------------------------------------------------------------------------------------
TEST_P(MenuLayouts, AnOpenHelpIsWhollyVisibleAndTakesClicks)
{
  this->State.Perform({ Kind::ToggleHelp, 0, "" });
  const MenuLayout layout = this->LayOut();
  for (const MenuBox& box : layout.GetBoxes())
  {
    EXPECT_TRUE(IsInside(box.Place, GetParam().Width, GetParam().Height)) << box.Text;
  }
  const MenuRect room = GetSceneRoom(this->State, GetParam().Width, GetParam().Height);
  EXPECT_EQ(layout.GetAction(room.X + room.Width / 2, GetParam().Height / 2).Is, Kind::ToggleHelp);
}

//--------------------------------------------------------------------------------------------------
TEST_P(MenuLayouts, MarksWhatHolds)
{
  const auto chosen = [](const MenuLayout& layout)
  {
    std::vector<std::string> names;
    for (const MenuBox& box : layout.GetBoxes())
    {
      if (box.Is == Look::Chosen)
      {
        names.push_back(box.Text);
      }
    }
    return names;
  };
  const std::vector<std::string> names = chosen(this->LayOut());
  EXPECT_EQ(std::count(names.begin(), names.end(), "pcss"), 1);
  EXPECT_EQ(std::count(names.begin(), names.end(), "picture"), 1);
  EXPECT_EQ(std::count(names.begin(), names.end(), "sampled"), 0);
}

INSTANTIATE_TEST_SUITE_P(Windows, MenuLayouts,
  testing::Values(WindowSize{ 800, 600 }, WindowSize{ 1600, 1000 }, WindowSize{ 1200, 800 }),
  [](const testing::TestParamInfo<WindowSize>& each)
  { return std::to_string(each.param.Width) + "x" + std::to_string(each.param.Height); });

//--------------------------------------------------------------------------------------------------
TEST(WrapText, CutsAtSpacesAndLosesNoLetter)
{
  EXPECT_EQ(WrapText("one two three", 7), (std::vector<std::string>{ "one two", "three" }));
  EXPECT_EQ(WrapText("abcdefgh", 3), (std::vector<std::string>{ "abc", "def", "gh" }));
  EXPECT_TRUE(WrapText("", 5).empty());
}
