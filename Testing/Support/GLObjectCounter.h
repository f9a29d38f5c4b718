// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GLObjectCounter.h
 * @brief How many OpenGL objects there are, for tests that nothing leaks.
 *
 * OpenGL lists no objects, but answers whether a name is one: all names that can be are asked.
 */

#ifndef SoftShadowsTesting_GLObjectCounter_h
#define SoftShadowsTesting_GLObjectCounter_h

#include <iosfwd> // For messages

class vtkOpenGLRenderWindow;

namespace SoftShadowsTesting
{

struct GLObjectCounts
{
  int Textures = 0;
  int Buffers = 0;
  int Framebuffers = 0;
  int Renderbuffers = 0;
  int VertexArrays = 0;
  int Programs = 0;
  int Shaders = 0;
  int Queries = 0;
  /// Texture units that VTK's manager holds as taken.
  int TextureUnits = 0;

  bool operator==(const GLObjectCounts& other) const;
  bool operator!=(const GLObjectCounts& other) const { return !(*this == other); }
};

std::ostream& operator<<(std::ostream& os, const GLObjectCounts& counts);

/// Counts the objects of the window's context.
GLObjectCounts CountGLObjects(vtkOpenGLRenderWindow* window);

}

#endif
