// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMarchedRays
 * @brief   A texture of rays to points of an emitter, another subset for each pixel of a pattern.
 *
 * The points are consecutive runs of an Owen-scrambled (0, 2)-sequence: each run is well spread over
 * the light, and so are those of a whole pattern together. Unscrambled the sequence lines up along the
 * diagonals, and edges along them show bands. A texel is a ray: window coordinates of its point in
 * [-1, 1]^2, weight, jitter of its steps in [0, 1); a row of the texture is a pixel of the pattern.
 */

#ifndef vtkMarchedRays_h
#define vtkMarchedRays_h

#include "vtkShadowEmitter.h"     // For the emitter
#include "vtkShadowTextureUnit.h" // For members
#include "vtkSmartPointer.h"      // For members
#include "vtkSoftShadowsABI.h"    // For the ABI namespace
#include "vtkType.h"              // For bytes

#include <vector> // For rays

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

class vtkMarchedRays
{
public:
  vtkMarchedRays();
  ~vtkMarchedRays();
  vtkMarchedRays(const vtkMarchedRays&) = delete;
  vtkMarchedRays& operator=(const vtkMarchedRays&) = delete;

  /**
   * Makes the texture hold count rays for each of pattern x pattern pixels, in the weights of
   * vtkShadowLightSampling::WeightsType, and binds it. Returns its texture unit. Needs Deactivate.
   */
  int Activate(vtkOpenGLRenderWindow* window, const vtkShadowEmitter& emitter, int count,
    int pattern, int weights);
  void Deactivate();

  /// Rays per pixel: 1 if the emitter has no extent.
  int GetCount() const { return this->Count; }
  /// How many of them, the first ones, decide where all of them agree.
  int GetFirstCount() const { return this->FirstCount; }

  /// Bytes of the texture.
  vtkTypeInt64 GetBytes() const
  {
    return static_cast<vtkTypeInt64>(this->Rays.size() * sizeof(float));
  }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkSmartPointer<vtkTextureObject> Texture;
  vtkShadowTextureUnit Unit;
  std::vector<float> Rays; // what the texture holds
  int Count = 0;
  int FirstCount = 0;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkMarchedRays.h
