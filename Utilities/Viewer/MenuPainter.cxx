// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MenuPainter.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cmath>

namespace softshadows
{
namespace
{

using Look = MenuBox::Look;
using MenuColor = std::array<unsigned char, 4>;

//--------------------------------------------------------------------------------------------------
/// Alpha 0: no ground.
MenuColor GroundOf(Look look)
{
  switch (look)
  {
    case Look::Panel:
      return { { 24, 28, 36, 255 } };
    case Look::Button:
      return { { 62, 70, 86, 255 } };
    case Look::Chosen:
      return { { 36, 110, 190, 255 } };
    case Look::Selected:
      return { { 44, 62, 92, 255 } };
    case Look::Thumb:
      return { { 120, 130, 150, 255 } };
    default:
      return { { 0, 0, 0, 0 } };
  }
}

//--------------------------------------------------------------------------------------------------
MenuColor TextOf(Look look)
{
  switch (look)
  {
    case Look::Heading:
      return { { 255, 205, 110, 255 } };
    case Look::Faint:
      return { { 172, 182, 198, 255 } };
    case Look::Value:
      return { { 150, 210, 255, 255 } };
    default:
      return { { 240, 243, 248, 255 } };
  }
}

}

//--------------------------------------------------------------------------------------------------
MenuPainter::MenuPainter(vtkRenderer* renderer)
  : Renderer(renderer)
{
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(this->Grounds);
  mapper->SetScalarModeToUseCellData();
  this->GroundActor->SetMapper(mapper);
  this->GroundActor->GetProperty()->SetDisplayLocationToForeground();
  this->Renderer->AddViewProp(this->GroundActor);
}

//--------------------------------------------------------------------------------------------------
MenuPainter::~MenuPainter()
{
  this->Renderer->RemoveViewProp(this->GroundActor);
  for (const auto& text : this->Texts)
  {
    this->Renderer->RemoveViewProp(text);
  }
}

//--------------------------------------------------------------------------------------------------
void MenuPainter::Update(const MenuLayout& layout)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  this->Grounds->SetPoints(points);
  this->Grounds->SetPolys(quads);
  this->Grounds->GetCellData()->SetScalars(colors);
  this->UsedTexts = 0;
  for (const MenuBox& box : layout.GetBoxes())
  {
    this->AddGround(box);
    this->AddText(box, layout.GetScale().Font);
  }
  this->Grounds->Modified();
  this->SetVisible(this->Visible);
}

//--------------------------------------------------------------------------------------------------
void MenuPainter::SetVisible(bool visible)
{
  this->Visible = visible;
  this->GroundActor->SetVisibility(visible);
  for (std::size_t i = 0; i < this->Texts.size(); ++i)
  {
    this->Texts[i]->SetVisibility(visible && i < this->UsedTexts);
  }
}

//--------------------------------------------------------------------------------------------------
void MenuPainter::AddGround(const MenuBox& box)
{
  const MenuColor color = GroundOf(box.Is);
  if (color[3] == 0)
  {
    return;
  }
  const MenuRect& place = box.Place;
  const double left = place.X;
  const double right = place.X + place.Width;
  const double bottom = place.Y;
  const double top = place.Y + place.Height;
  vtkPoints* points = this->Grounds->GetPoints();
  const vtkIdType corners[4] = { points->InsertNextPoint(left, bottom, 0.0),
    points->InsertNextPoint(right, bottom, 0.0), points->InsertNextPoint(right, top, 0.0),
    points->InsertNextPoint(left, top, 0.0) };
  this->Grounds->GetPolys()->InsertNextCell(4, corners);
  vtkUnsignedCharArray::SafeDownCast(this->Grounds->GetCellData()->GetScalars())
    ->InsertNextTypedTuple(color.data());
}

//--------------------------------------------------------------------------------------------------
void MenuPainter::AddText(const MenuBox& box, int font)
{
  if (box.Text.empty())
  {
    return;
  }
  if (this->UsedTexts == this->Texts.size())
  {
    this->Texts.push_back(vtkSmartPointer<vtkTextActor>::New());
    this->Texts.back()->SetTextScaleModeToNone();
    this->Renderer->AddViewProp(this->Texts.back());
  }
  vtkTextActor* actor = this->Texts[this->UsedTexts++];
  actor->SetInput(box.Text.c_str());
  const MenuColor color = TextOf(box.Is);
  vtkTextProperty* property = actor->GetTextProperty();
  property->SetFontFamilyToArial();
  const double size = box.Is == Look::Title ? 1.25 : (box.Is == Look::Faint ? 0.9 : 1.0);
  property->SetFontSize(static_cast<int>(std::lround(size * font)));
  property->SetBold(box.Is == Look::Title || box.Is == Look::Heading);
  property->SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  property->SetVerticalJustificationToCentered();
  const MenuRect& place = box.Place;
  double x = place.X;
  switch (box.Aligned)
  {
    case MenuBox::Align::Left:
      property->SetJustificationToLeft();
      break;
    case MenuBox::Align::Center:
      property->SetJustificationToCentered();
      x += 0.5 * place.Width;
      break;
    case MenuBox::Align::Right:
      property->SetJustificationToRight();
      x += place.Width;
      break;
  }
  // Whole pixels, or letters blur.
  actor->SetPosition(std::floor(x), std::floor(place.Y + 0.5 * place.Height));
}

}
