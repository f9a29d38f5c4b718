// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowQueries
 * @brief   Occlusion queries of one window, by number, made when they are first asked for.
 */

#ifndef vtkShadowQueries_h
#define vtkShadowQueries_h

#include "vtkRenderingSoftShadowsCoreModule.h" // For export macro
#include "vtkShadowContextWatch.h"             // For members
#include "vtkSoftShadowsABI.h"                 // For the ABI namespace

#include <cstddef> // For sizes
#include <vector>  // For names

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;

class VTKRENDERINGSOFTSHADOWSCORE_EXPORT vtkShadowQueries
{
public:
  vtkShadowQueries();
  ~vtkShadowQueries();
  vtkShadowQueries(const vtkShadowQueries&) = delete;
  vtkShadowQueries& operator=(const vtkShadowQueries&) = delete;

  ///@{
  /// What is drawn in between counts for the query of this number. The window's context is current.
  void Begin(vtkOpenGLRenderWindow* window, size_t index);
  void End();
  ///@}

  /// The OpenGL name of a query that was begun; 0 if it was not, or was released since.
  unsigned int GetName(size_t index) const;

  /// Deletes all of them. The window's end and the destructor do so by themselves.
  void Release() { this->Watch.Free(); }

private:
  std::vector<unsigned int> Names;
  vtkShadowContextWatch Watch;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowQueries.h
