// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GLStateSnapshot.h
 * @brief The OpenGL state that a pass must leave as it found it.
 */

#ifndef SoftShadowsTesting_GLStateSnapshot_h
#define SoftShadowsTesting_GLStateSnapshot_h

#include <string>  // For names
#include <utility> // For pairs
#include <vector>  // For values

class vtkOpenGLRenderWindow;

namespace SoftShadowsTesting
{

class GLStateSnapshot
{
public:
  /// Reads the state of the window's context from OpenGL itself, not from VTK's cache.
  explicit GLStateSnapshot(vtkOpenGLRenderWindow* window);

  /// One line for each value that differs: its name, this value, the other value. Empty: the same.
  std::string DifferenceTo(const GLStateSnapshot& other) const;

private:
  std::vector<std::pair<std::string, std::vector<double>>> Values;
};

/// One line for each switch that VTK's cache holds for something else than it is. Empty: all right.
std::string StateCacheErrors(vtkOpenGLRenderWindow* window);

}

#endif
