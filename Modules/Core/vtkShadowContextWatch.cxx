// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowContextWatch.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <utility>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
// Windows call back before their context goes, but the header of VTK's callbacks is not installed. A
// texture object registers one for itself; this one never has a texture.
class vtkShadowContextWatch::Sentinel : public vtkTextureObject
{
public:
  static Sentinel* New();
  vtkTypeMacro(Sentinel, vtkTextureObject);

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    if (this->Watch)
    {
      this->Watch->Leave();
    }
    this->Superclass::ReleaseGraphicsResources(window);
  }

  vtkShadowContextWatch* Watch = nullptr;
};
vtkStandardNewMacro(vtkShadowContextWatch::Sentinel);

//------------------------------------------------------------------------------
vtkShadowContextWatch::vtkShadowContextWatch(Function function)
  : FreeFunction(std::move(function))
{
}

//------------------------------------------------------------------------------
vtkShadowContextWatch::~vtkShadowContextWatch()
{
  this->Free();
  if (this->Registered)
  {
    static_cast<Sentinel*>(this->Registered.GetPointer())->Watch = nullptr;
  }
}

//------------------------------------------------------------------------------
void vtkShadowContextWatch::Enter(vtkOpenGLRenderWindow* window)
{
  if (this->Window == window)
  {
    return;
  }
  this->Free();
  if (!this->Registered)
  {
    vtkSmartPointer<Sentinel> sentinel = vtkSmartPointer<Sentinel>::New();
    sentinel->Watch = this;
    this->Registered = sentinel;
  }
  this->Registered->SetContext(window);
  this->Window = window;
}

//------------------------------------------------------------------------------
void vtkShadowContextWatch::Free()
{
  if (this->Window)
  {
    // Comes back to Leave, with the window's context current.
    this->Registered->vtkTextureObject::ReleaseGraphicsResources(this->Window);
  }
}

//------------------------------------------------------------------------------
void vtkShadowContextWatch::Leave()
{
  vtkOpenGLRenderWindow* window = std::exchange(this->Window, nullptr);
  if (window)
  {
    this->FreeFunction(window);
  }
}
VTK_ABI_NAMESPACE_END
