// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MenuLayout.h"

#include "KeyBindings.h"
#include "LightMotion.h"

#include <algorithm>
#include <cmath>

namespace softshadows
{
namespace
{

using Kind = ViewerAction::Kind;
using Look = MenuBox::Look;
using Align = MenuBox::Align;

constexpr int NoteLines = 2;
constexpr int StatusLines = 2;
constexpr int TechniquesPerRow = 3;
constexpr int ViewsPerRow = 3;

//--------------------------------------------------------------------------------------------------
MenuBox Button(const std::string& text, const ViewerAction& click, bool chosen = false)
{
  return { {}, chosen ? Look::Chosen : Look::Button, text, Align::Center, click };
}

//--------------------------------------------------------------------------------------------------
int RowsOf(std::size_t buttons, int perRow)
{
  return (static_cast<int>(buttons) + perRow - 1) / perRow;
}

//--------------------------------------------------------------------------------------------------
std::string Capitalised(std::string text)
{
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
  {
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  }
  return text;
}

}

//--------------------------------------------------------------------------------------------------
std::vector<std::string> WrapText(const std::string& text, int letters)
{
  const auto most = static_cast<std::size_t>(std::max(1, letters));
  std::vector<std::string> lines;
  std::size_t start = 0;
  while (start < text.size())
  {
    std::size_t end = std::min(text.size(), start + most);
    if (end < text.size())
    {
      const std::size_t space = text.rfind(' ', end);
      end = space != std::string::npos && space > start ? space : end;
    }
    lines.push_back(text.substr(start, end - start));
    start = end < text.size() && text[end] == ' ' ? end + 1 : end;
  }
  return lines;
}

//--------------------------------------------------------------------------------------------------
MenuScale::MenuScale(int windowHeight)
{
  constexpr double wellReadHeight = 760.0;
  const double scale = std::clamp(windowHeight / wellReadHeight, 0.88, 2.5);
  this->Font = static_cast<int>(std::lround(14.0 * scale));
  this->Row = static_cast<int>(std::lround(22.0 * scale));
  this->Gap = static_cast<int>(std::lround(6.0 * scale));
  this->PanelWidth = static_cast<int>(std::lround(290.0 * scale));
  this->StatusHeight = StatusLines * (this->Row - this->Gap / 2) + this->Gap;
}

//--------------------------------------------------------------------------------------------------
MenuRect GetSceneRoom(const ViewerState& state, int windowWidth, int windowHeight)
{
  const MenuScale scale(windowHeight);
  const int left = state.IsMenuOpen() ? std::min(scale.PanelWidth, windowWidth - 1) : 0;
  const int bottom = std::min(scale.StatusHeight, windowHeight - 1);
  return { left, bottom, windowWidth - left, windowHeight - bottom };
}

//--------------------------------------------------------------------------------------------------
MenuLayout::MenuLayout(const ViewerState& state, const MenuStatus& status, int width, int height)
  : State(state)
  , Scale(height)
  , Width(width)
  , Height(height)
{
  if (state.IsMenuOpen())
  {
    this->AddMenu();
  }
  this->AddStatus(status);
  if (state.IsHelpOpen())
  {
    this->AddHelp();
  }
}

//--------------------------------------------------------------------------------------------------
bool MenuLayout::Covers(int x, int y) const
{
  return std::any_of(this->Boxes.begin(), this->Boxes.end(),
    [x, y](const MenuBox& box) { return box.Is == Look::Panel && box.Place.Contains(x, y); });
}

//--------------------------------------------------------------------------------------------------
ViewerAction MenuLayout::GetAction(int x, int y) const
{
  for (auto box = this->Boxes.rbegin(); box != this->Boxes.rend(); ++box)
  {
    if (box->Place.Contains(x, y) && (box->Click.Is != Kind::None || box->Is == Look::Panel))
    {
      return box->Click;
    }
  }
  return {};
}

//--------------------------------------------------------------------------------------------------
MenuRect MenuLayout::TakeRow(int height)
{
  this->Top -= height;
  const int margin = 2 * this->Scale.Gap;
  return { margin, this->Top, this->Scale.PanelWidth - 2 * margin, height };
}

//--------------------------------------------------------------------------------------------------
void MenuLayout::AddHeading(
  const std::string& text, const std::string& button, const ViewerAction& click)
{
  this->Top -= this->Scale.Gap;
  const MenuRect row = this->TakeRow();
  this->Boxes.push_back({ row, Look::Heading, text, Align::Left, {} });
  if (!button.empty())
  {
    const int wide = row.Width / 3;
    this->Boxes.push_back({ { row.X + row.Width - wide, row.Y + 1, wide, row.Height - 2 },
      Look::Button, button, Align::Center, click });
  }
}

//--------------------------------------------------------------------------------------------------
void MenuLayout::AddNote(const std::string& text, int lines)
{
  constexpr double letterWidth = 0.53; // of the font's size, on average
  const int high = this->Scale.Row - this->Scale.Gap / 2;
  const int room = this->Scale.PanelWidth - 4 * this->Scale.Gap;
  std::vector<std::string> wrapped =
    WrapText(Capitalised(text), static_cast<int>(room / (letterWidth * 0.9 * this->Scale.Font)));
  wrapped.resize(lines);
  for (const std::string& line : wrapped)
  {
    this->Boxes.push_back({ this->TakeRow(high), Look::Faint, line, Align::Left, {} });
  }
}

//--------------------------------------------------------------------------------------------------
void MenuLayout::AddButtons(const std::vector<MenuBox>& buttons, int perRow)
{
  MenuRect row;
  for (std::size_t i = 0; i < buttons.size(); ++i)
  {
    const int column = static_cast<int>(i) % perRow;
    if (column == 0)
    {
      row = this->TakeRow();
    }
    const int left = row.X + column * (row.Width + 2) / perRow;
    const int right = row.X + (column + 1) * (row.Width + 2) / perRow - 2;
    MenuBox button = buttons[i];
    button.Place = { left, row.Y + 1, right - left, row.Height - 2 };
    this->Boxes.push_back(button);
  }
}

//--------------------------------------------------------------------------------------------------
void MenuLayout::AddSpinner(const MenuRect& place, const std::string& value,
  const ViewerAction& less, const ViewerAction& more)
{
  const int edge = place.Height;
  this->Boxes.push_back(
    { { place.X, place.Y + 1, edge, place.Height - 2 }, Look::Button, "<", Align::Center, less });
  this->Boxes.push_back({ { place.X + edge, place.Y, place.Width - 2 * edge, place.Height },
    Look::Value, value, Align::Center, more });
  this->Boxes.push_back({ { place.X + place.Width - edge, place.Y + 1, edge, place.Height - 2 },
    Look::Button, ">", Align::Center, more });
}

//--------------------------------------------------------------------------------------------------
int MenuLayout::GetRowsBesideSettings() const
{
  const int light = this->State.HasLight() ? 5 : 0;
  return 1 + 1 + 1 + RowsOf(GetTechniques().size(), TechniquesPerRow) + 1 + light + 1 +
    RowsOf(this->State.GetViews().size(), ViewsPerRow) + 3;
}

//--------------------------------------------------------------------------------------------------
void MenuLayout::AddMenu()
{
  const MenuScale& scale = this->Scale;
  this->Boxes.push_back(
    { { 0, 0, scale.PanelWidth, this->Height }, Look::Panel, "", Align::Left, {} });
  this->Top = this->Height - scale.Gap;
  const MenuRect title = this->TakeRow();
  this->Boxes.push_back({ title, Look::Title, "SoftShadows", Align::Left, {} });
  const int wide = title.Width / 4;
  this->Boxes.push_back(
    { { title.X + title.Width - 2 * wide - 2, title.Y + 1, wide, title.Height - 2 }, Look::Button,
      "help  h", Align::Center, { Kind::ToggleHelp, 0, "" } });
  this->Boxes.push_back({ { title.X + title.Width - wide, title.Y + 1, wide, title.Height - 2 },
    Look::Button, "hide  m", Align::Center, { Kind::ToggleMenu, 0, "" } });

  this->AddTechniques();
  constexpr int notes = 3 * NoteLines; // of technique, setting and view
  constexpr int headings = 5;
  const int room = this->Height - this->GetRowsBesideSettings() * scale.Row -
    notes * (scale.Row - scale.Gap / 2) - (headings + 3) * scale.Gap;
  this->AddSettings(std::max(1, room / scale.Row));
  this->AddLight();

  this->AddHeading("Show  (v)", "", {});
  std::vector<MenuBox> views;
  for (const DebugView& view : this->State.GetViews())
  {
    const int place = static_cast<int>(views.size());
    views.push_back(
      Button(view.Name, { Kind::ChooseView, place, "" }, place == this->State.GetViewPlace()));
  }
  this->AddButtons(views, ViewsPerRow);
  this->AddNote(this->State.GetView().Meaning, NoteLines);
  this->AddButtons({ Button("converge at rest  p", { Kind::ToggleProgressive, 0, "" },
                     this->State.IsProgressive()) },
    1);

  this->AddHeading("Save", "", {});
  this->AddButtons({ Button("picture  F2", { Kind::SavePicture, 0, "" }),
                     Button("visibility  F3", { Kind::SaveVisibility, 0, "" }),
                     Button("scene  F4", { Kind::SaveScene, 0, "" }) },
    3);
}

//--------------------------------------------------------------------------------------------------
void MenuLayout::AddTechniques()
{
  this->AddHeading("Technique  (1 - 9)", "", {});
  std::vector<MenuBox> buttons;
  for (const Technique& technique : GetTechniques())
  {
    const int place = static_cast<int>(buttons.size());
    buttons.push_back(Button(technique.Name, { Kind::ChooseTechnique, place, "" },
      place == this->State.GetTechniquePlace()));
  }
  this->AddButtons(buttons, TechniquesPerRow);
  this->AddNote(this->State.GetTechnique().Meaning, NoteLines);
}

//--------------------------------------------------------------------------------------------------
void MenuLayout::AddSettings(int rows)
{
  this->AddHeading("Settings  (arrow keys)", "", {});
  std::vector<MenuBox> qualities;
  for (const QualityClass& quality : GetQualities())
  {
    const int place = static_cast<int>(qualities.size());
    if (!this->State.HasQuality(place))
    {
      qualities.push_back({ {}, Look::Faint, quality.Name + ": none", Align::Center, {} });
      continue;
    }
    qualities.push_back(Button(
      quality.Name, { Kind::ChooseQuality, place, "" }, place == this->State.GetQualityPlace()));
  }
  this->AddButtons(qualities, static_cast<int>(qualities.size()));
  const std::vector<const TechniqueOption*> settings = this->State.GetSettings();
  const int count = static_cast<int>(settings.size());
  const int shown = std::min(rows, count);
  // The selected one stays in the middle of the list while there is more on both sides.
  const int first = std::clamp(this->State.GetSelection() - shown / 2, 0, count - shown);
  const int bar = shown < count ? this->Scale.Gap : 0;
  const int top = this->Top;
  for (int i = first; i < first + shown; ++i)
  {
    this->AddSetting(*settings[i], i == this->State.GetSelection(), bar);
  }
  if (bar > 0)
  {
    const int whole = top - this->Top;
    const int right = this->Scale.PanelWidth - 2 * this->Scale.Gap;
    this->Boxes.push_back(
      { { right - bar / 2, top - whole * (first + shown) / count, bar / 2, whole * shown / count },
        Look::Thumb, "", Align::Left, {} });
  }
  const TechniqueOption& selected = *settings[this->State.GetSelection()];
  this->AddNote(selected.Meaning, NoteLines);
}

//--------------------------------------------------------------------------------------------------
void MenuLayout::AddSetting(const TechniqueOption& option, bool selected, int room)
{
  MenuRect row = this->TakeRow();
  row.Width -= room;
  if (selected)
  {
    this->Boxes.push_back({ row, Look::Selected, "", Align::Left, {} });
  }
  const int labelWidth = row.Width * 45 / 100;
  const double value = this->State.GetOption(option.Name);
  const bool isDefault = value == this->State.GetDefault(option.Name);
  this->Boxes.push_back({ { row.X, row.Y, labelWidth, row.Height }, Look::Text,
    " " + option.Name + (isDefault ? "" : " *"), Align::Left,
    { Kind::SelectOption, 0, option.Name } });
  this->AddSpinner({ row.X + labelWidth, row.Y, row.Width - labelWidth, row.Height },
    option.Spell(value), { Kind::StepOption, -1, option.Name },
    { Kind::StepOption, 1, option.Name });
}

//--------------------------------------------------------------------------------------------------
void MenuLayout::AddLight()
{
  if (!this->State.HasLight())
  {
    return;
  }
  const std::size_t count = this->State.GetScene().Lights.size();
  const LightDescription& light = this->State.GetLight();
  const std::string which = count > 1
    ? "Light " + std::to_string(this->State.GetLightPlace() + 1) + " of " + std::to_string(count)
    : "Light";
  this->AddHeading(which, count > 1 ? "next  l" : "", { Kind::StepLight, 1, "" });
  MenuRect row = this->TakeRow();
  const int labelWidth = row.Width * 3 / 10;
  this->Boxes.push_back(
    { { row.X, row.Y, labelWidth, row.Height }, Look::Text, " size  + -", Align::Left, {} });
  this->AddSpinner({ row.X + labelWidth, row.Y, row.Width - labelWidth, row.Height },
    SpellLightSize(light), { Kind::ScaleLight, -1, "" }, { Kind::ScaleLight, 1, "" });
  std::vector<MenuBox> moves = { Button("left  a", { Kind::TurnLight, -1, "" }),
    Button("right  d", { Kind::TurnLight, 1, "" }), Button("up  w", { Kind::RaiseLight, 1, "" }),
    Button("down  s", { Kind::RaiseLight, -1, "" }) };
  this->AddButtons(moves, 4);
  std::vector<MenuBox> more = { Button("nearer  n", { Kind::ApproachLight, 1, "" }),
    Button("farther  f", { Kind::ApproachLight, -1, "" }),
    Button("reset  L", { Kind::ResetLight, 0, "" }) };
  this->AddButtons(more, 3);
  row = this->TakeRow();
  this->Boxes.push_back({ row, Look::Faint, "or drag the yellow ball", Align::Left, {} });
  const int wide = row.Width / 3;
  this->Boxes.push_back({ { row.X + row.Width - wide, row.Y + 1, wide, row.Height - 2 },
    this->State.IsHandleShown() ? Look::Chosen : Look::Button, "ball  g", Align::Center,
    { Kind::ToggleHandle, 0, "" } });
}

//--------------------------------------------------------------------------------------------------
void MenuLayout::AddStatus(const MenuStatus& status)
{
  const MenuScale& scale = this->Scale;
  const int left = this->State.IsMenuOpen() ? scale.PanelWidth : 0;
  const int high = scale.Row - scale.Gap / 2;
  const MenuRect bar = { left, 0, this->Width - left, scale.StatusHeight };
  this->Boxes.push_back({ bar, Look::Panel, "", Align::Left, {} });
  int y = scale.StatusHeight - scale.Gap / 2;
  for (const std::string& line : status.Lines)
  {
    y -= high;
    this->Boxes.push_back({ { left + 2 * scale.Gap, y, bar.Width - 4 * scale.Gap, high },
      Look::Text, line, Align::Left, {} });
  }
  if (!status.Message.empty())
  {
    const MenuRect place = { left, bar.Height + scale.Gap, this->Width - left, scale.Row };
    this->Boxes.push_back({ place, Look::Panel, "", Align::Left, {} });
    this->Boxes.push_back(
      { { place.X + 2 * scale.Gap, place.Y, place.Width - 4 * scale.Gap, place.Height },
        Look::Heading, status.Message, Align::Left, {} });
  }
}

//--------------------------------------------------------------------------------------------------
void MenuLayout::AddHelp()
{
  const MenuScale& scale = this->Scale;
  const std::vector<HelpLine>& lines = GetHelp();
  const int left = this->State.IsMenuOpen() ? scale.PanelWidth : 0;
  const int high = scale.Row;
  const int wide = std::min(this->Width - left - 2 * scale.Gap, 2 * scale.PanelWidth);
  const int all = static_cast<int>(lines.size() + 2) * high;
  const MenuRect panel = { left + (this->Width - left - wide) / 2,
    std::max(0, (this->Height - all) / 2), wide, all };
  const ViewerAction close = { Kind::ToggleHelp, 0, "" };
  this->Boxes.push_back({ panel, Look::Panel, "", Align::Left, close });
  const int keysWidth = wide * 30 / 100;
  int y = panel.Y + panel.Height - high / 2;
  for (const HelpLine& line : lines)
  {
    y -= high;
    const int x = panel.X + 2 * scale.Gap;
    if (line.Keys.empty())
    {
      this->Boxes.push_back({ { x, y, wide, high }, Look::Heading, line.Text, Align::Left, {} });
      continue;
    }
    this->Boxes.push_back({ { x, y, keysWidth, high }, Look::Value, line.Keys, Align::Left, {} });
    this->Boxes.push_back(
      { { x + keysWidth, y, wide - keysWidth, high }, Look::Text, line.Text, Align::Left, {} });
  }
  this->Boxes.push_back({ { panel.X, panel.Y, wide, high + high / 2 }, Look::Faint,
    "click or press h to close", Align::Center, {} });
}

}
