// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowTextureUnit.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShadowFailures.h"
#include "vtkSoftShadowsOpenGL.h"
#include "vtkTextureUnitManager.h"

#include <set>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// Units beyond VTK's that are taken, in whichever window: there are many more than are ever needed.
thread_local std::set<int> Spares;

int TakeSpare(int first)
{
  GLint end = 0;
  glGetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &end);
  for (int unit = first; unit < end; ++unit)
  {
    if (Spares.insert(unit).second)
    {
      return unit;
    }
  }
  return -1;
}

// A unit that a sampler may be set to.
int CheckUnit(int unit, vtkTextureUnitManager* units)
{
  if (unit >= 0)
  {
    return unit;
  }
  vtkShadowFailures::Report("no texture unit is left");
  return units->GetNumberOfTextureUnits() - 1;
}
} // namespace

//------------------------------------------------------------------------------
// One beyond VTK's if there is any: VTK takes its own for a moment whenever it makes a texture.
int vtkShadowTextureUnit::Reserve(vtkOpenGLRenderWindow* window)
{
  vtkTextureUnitManager* units = window->GetState()->GetTextureUnitManager();
  const int spare = TakeSpare(units->GetNumberOfTextureUnits());
  this->Window = window;
  this->Target = 0;
  this->Unit = spare >= 0 ? spare : units->Allocate();
  return CheckUnit(this->Unit, units);
}

//------------------------------------------------------------------------------
int vtkShadowTextureUnit::Bind(
  vtkOpenGLRenderWindow* window, unsigned int target, unsigned int texture)
{
  vtkTextureUnitManager* units = window->GetState()->GetTextureUnitManager();
  const int own = units->Allocate();
  this->Window = window;
  this->Target = target;
  this->Unit = own >= 0 ? own : TakeSpare(units->GetNumberOfTextureUnits());
  if (this->Unit >= 0)
  {
    window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
    glBindTexture(target, texture);
  }
  return CheckUnit(this->Unit, units);
}

//------------------------------------------------------------------------------
void vtkShadowTextureUnit::Release()
{
  if (this->Unit < 0)
  {
    return;
  }
  vtkOpenGLState* state = this->Window->GetState();
  if (this->Target)
  {
    state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
    glBindTexture(this->Target, 0);
  }
  vtkTextureUnitManager* units = state->GetTextureUnitManager();
  if (this->Unit >= units->GetNumberOfTextureUnits())
  {
    Spares.erase(this->Unit);
  }
  else
  {
    units->Free(this->Unit);
  }
  this->Unit = -1;
}

//------------------------------------------------------------------------------
bool vtkShadowTextureUnit::IsAnyLeft(vtkOpenGLRenderWindow* window)
{
  vtkTextureUnitManager* units = window->GetState()->GetTextureUnitManager();
  const int unit = units->Allocate();
  if (unit >= 0)
  {
    units->Free(unit);
  }
  return unit >= 0;
}
VTK_ABI_NAMESPACE_END
