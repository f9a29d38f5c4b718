// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowContextWatch
 * @brief   Frees what its owner holds in a window, in that window's context and before it goes.
 *
 * OpenGL names are numbers that mean something else in every context. An owner of such names enters
 * the window that it makes them in. Its function is called once afterwards, with that context current:
 * when the window closes or dies, when another window is entered, by Free, or by the destructor,
 * whichever comes first.
 */

#ifndef vtkShadowContextWatch_h
#define vtkShadowContextWatch_h

#include "vtkRenderingSoftShadowsCoreModule.h" // For export macro
#include "vtkSmartPointer.h"                   // For members
#include "vtkSoftShadowsABI.h"                 // For the ABI namespace

#include <functional> // For the function

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkTextureObject;

class VTKRENDERINGSOFTSHADOWSCORE_EXPORT vtkShadowContextWatch
{
public:
  /// Deletes all names held in the window and forgets them.
  using Function = std::function<void(vtkOpenGLRenderWindow*)>;

  explicit vtkShadowContextWatch(Function function);
  ~vtkShadowContextWatch();
  vtkShadowContextWatch(const vtkShadowContextWatch&) = delete;
  vtkShadowContextWatch& operator=(const vtkShadowContextWatch&) = delete;

  /// What is made from now on lies in this window, whose context is current. Frees what lies in another.
  void Enter(vtkOpenGLRenderWindow* window);

  /// Calls the function if a window has been entered, and leaves that.
  void Free();

  /// The window that was entered; null if there is none, also while the function runs.
  vtkOpenGLRenderWindow* GetWindow() const { return this->Window; }

private:
  class Sentinel;

  Function FreeFunction;
  vtkOpenGLRenderWindow* Window = nullptr; // not owned: tells before it dies
  vtkSmartPointer<vtkTextureObject> Registered;

  void Leave();
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowContextWatch.h
