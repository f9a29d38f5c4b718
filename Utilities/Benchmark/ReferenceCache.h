// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReferenceCache
 * @brief   Ray-traced references in files, found again by the content of their scene.
 */

#ifndef SoftShadowsBenchmark_ReferenceCache_h
#define SoftShadowsBenchmark_ReferenceCache_h

#include "VisibilityFile.h"

#include <functional> // For the progress callback
#include <string>     // For the folder

class vtkRenderer;

namespace softshadows
{

class ReferenceCache
{
public:
  /// The folder is made when the first reference is kept; an empty name keeps none.
  explicit ReferenceCache(std::string folder)
    : Folder(std::move(folder))
  {
  }

  /**
   * The exact visibility with samplesPerAxis^2 rays per light and pixel, of lights that are uniform or
   * weighted by N(0, 0.5) over their windows, from a file if the same
   * scene was traced before. A damaged file is traced anew and replaced.
   */
  VisibilityImage Get(vtkRenderer* renderer, int width, int height, int samplesPerAxis,
    bool gaussian, const std::function<void(double)>& progress);

private:
  std::string Folder;
};

}

#endif
