// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowFits
 * @brief   Keeps the views that fit points of emitters until casters, emitter or settings change.
 */

#ifndef vtkSoftShadowFits_h
#define vtkSoftShadowFits_h

#include "vtkShadowEmitter.h"     // For emitters
#include "vtkSoftShadowSamples.h" // For samples
#include "vtkSoftShadowsABI.h"    // For the ABI namespace
#include "vtkType.h"              // For times

#include <functional> // For points
#include <map>        // For fits
#include <utility>    // For keys
#include <vector>     // For points

VTK_ABI_NAMESPACE_BEGIN
class vtkLight;
class vtkRenderer;
struct vtkSoftShadowContext;

class vtkSoftShadowFits
{
public:
  using MakePoints = std::function<std::vector<vtkShadowLightSampling::Sample>()>;

  /// Forgets what belongs to lights that the renderer no longer has.
  void Begin(vtkRenderer* renderer);

  /// A set of the emitter's points, told apart by its number; points are made only if they must be.
  const vtkSoftShadowSamples& Get(
    const vtkSoftShadowContext& context, int set, vtkMTimeType settings, const MakePoints& points);

private:
  struct EmitterFits
  {
    vtkShadowEmitter Emitter;
    vtkMTimeType BodiesTime = 0;
    vtkMTimeType SettingsTime = 0;
    std::map<int, vtkSoftShadowSamples> Sets;
  };
  std::map<std::pair<const vtkLight*, int>, EmitterFits> Emitters; // by light and part
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkSoftShadowFits.h
