// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReferenceSource.h
 * @brief Where a run gets its ray-traced references from.
 */

#ifndef SoftShadowsBenchmark_ReferenceSource_h
#define SoftShadowsBenchmark_ReferenceSource_h

#include "VisibilityFile.h"

#include <functional> // For the source
#include <string>     // For the scene

class vtkRenderer;

namespace softshadows
{

/// The exact visibility with SamplesPerAxis^2 rays per light and pixel.
struct ReferenceRequest
{
  std::string Scene;
  int Width = 0;
  int Height = 0;
  /// 1: of the lights' centres, for hard shadows.
  int SamplesPerAxis = 1;
  /// Lights are weighted by N(0, 0.5) over their windows; else they are uniform.
  bool Gaussian = false;
};

/// Of what the renderer holds. Calls progress with the share that is done, in [0, 1]. Throws
/// std::exception if there is none.
using ReferenceSource = std::function<VisibilityImage(vtkRenderer* renderer,
  const ReferenceRequest& request, const std::function<void(double)>& progress)>;

/// Traces the reference anew.
VisibilityImage TraceReference(vtkRenderer* renderer, const ReferenceRequest& request,
  const std::function<void(double)>& progress);

}

#endif
