// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowStatistics
 * @brief   What a soft-shadow pass did: counts since construction and times of the last frame.
 */

#ifndef vtkSoftShadowStatistics_h
#define vtkSoftShadowStatistics_h

#include "vtkRenderingSoftShadowsVisibilityModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                       // For the ABI namespace
#include "vtkType.h"                                 // For vtkTypeInt64

#include <string>  // For names
#include <utility> // For pairs
#include <vector>  // For lists

VTK_ABI_NAMESPACE_BEGIN

struct VTKRENDERINGSOFTSHADOWSVISIBILITY_EXPORT vtkSoftShadowStatistics
{
  ///@{
  /// Totals since construction.
  vtkTypeInt64 Frames = 0;
  /// Frames whose receivers and visibility were drawn; the others reused the last ones.
  vtkTypeInt64 VisibilityFrames = 0;
  /// Frames that added points to the running mean of progressive mode.
  vtkTypeInt64 ProgressiveFrames = 0;
  /// Frames whose visibility was estimated once more because it was read, for SmoothTerminator.
  vtkTypeInt64 DataFrames = 0;
  vtkTypeInt64 MapsBaked = 0;
  /// Texels of the maps that were baked.
  vtkTypeInt64 TexelsDrawn = 0;
  /// Draw calls into depth maps.
  vtkTypeInt64 DrawCalls = 0;
  /// Draws over screens and pyramids for visibility; a step's are more than one where its work is long.
  vtkTypeInt64 VisibilityDraws = 0;
  /// Times a program of a technique was built.
  vtkTypeInt64 ShaderBuilds = 0;
  /// Times a mapper asked the pass for its part of a program.
  vtkTypeInt64 MapperShaderBuilds = 0;
  /// Times a texture or a buffer was made or resized.
  vtkTypeInt64 Allocations = 0;
  ///@}

  ///@{
  /// The last frame that drew visibility.
  /// Pixels and lights that a technique had to filter: neither proved lit nor proved blocked.
  vtkTypeInt64 PixelsFiltered = 0;
  int LightsCasting = 0;
  int LightsLit = 0;
  /// What a technique counts beyond this, by name.
  std::vector<std::pair<std::string, vtkTypeInt64>> TechniqueCounts;
  ///@}

  ///@{
  /// Now.
  /// Points of each light in the running mean.
  int ProgressivePoints = 0;
  int Casters = 0;
  int MapperCasters = 0;
  vtkTypeInt64 Triangles = 0;
  vtkTypeInt64 BytesHeld = 0;
  ///@}

  /// Milliseconds per step of the newest frame whose timer queries have come back, in frame order.
  std::vector<std::pair<std::string, double>> Milliseconds;

  /// All counts by name, in the order above.
  std::vector<std::pair<std::string, vtkTypeInt64>> GetCounts() const;

  ///@{
  /// The count, or the step's milliseconds, of that name; -1 if there is none.
  vtkTypeInt64 FindCount(const std::string& name) const;
  double FindMilliseconds(const std::string& step) const;
  ///@}
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkSoftShadowStatistics.h
