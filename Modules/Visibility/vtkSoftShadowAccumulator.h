// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowAccumulator
 * @brief   The textures of a running mean over points of the lights, and what is drawn into them.
 *
 * A layer per casting light, the viewport's size, 32-bit floats:
 *  - base: the technique's own visibility, with which it all starts; negative where there is none;
 *  - sum: of the hard shadows from points, times their weights;
 *  - held: an earlier mean to compare with;
 *  - half, held half: the means of the first half of the points of sum and held, while maps are
 *    compared.
 */

#ifndef vtkSoftShadowAccumulator_h
#define vtkSoftShadowAccumulator_h

#include "vtkNew.h"               // For members
#include "vtkShadowFramebuffer.h" // For members
#include "vtkShadowShader.h"      // For shaders
#include "vtkSmartPointer.h"      // For members
#include "vtkSoftShadowsABI.h"    // For the ABI namespace
#include "vtkType.h"              // For vtkTypeInt64

#include <vector> // For tiles

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShadowReceivers;
class vtkShadowTextureArray;
class vtkWindow;

class vtkSoftShadowAccumulator
{
public:
  vtkSoftShadowAccumulator();
  ~vtkSoftShadowAccumulator();
  vtkSoftShadowAccumulator(const vtkSoftShadowAccumulator&) = delete;
  vtkSoftShadowAccumulator& operator=(const vtkSoftShadowAccumulator&) = delete;

  /// Pixels along the edge of a tile.
  static constexpr int TileSize = 32;

  /**
   * Begins with the visibilities given, as many layers as that texture has. Returns the number of
   * allocations, -1 if there is no memory. Restores the framebuffer.
   */
  int Begin(vtkOpenGLRenderWindow* window, vtkShadowTextureArray* visibility);

  /// Clears the sums.
  void Clear(vtkOpenGLRenderWindow* window);

  /// Binds the sum of a light for additive drawing over the whole viewport. False if it cannot be.
  bool BeginSum(vtkOpenGLRenderWindow* window, int layer);

  /// Copies the mean, scale times the sum, to held.
  void Hold(vtkOpenGLRenderWindow* window, int layer, float scale);

  /// Copies the mean to half.
  void HoldHalf(vtkOpenGLRenderWindow* window, int layer, float scale);

  /// Of all lights, half becomes held half; what was there is to be written anew.
  void KeepHalves();

  /// Frees half and held half.
  void ReleaseHalves(vtkWindow* window);

  /// Writes (1 - share) rest + share * scale * sum to the visibilities; the rest is held or base.
  void Show(vtkOpenGLRenderWindow* window, vtkShadowTextureArray* visibility, int layer,
    float share, float scale, bool fromHeld);

  /// What of the change of the mean is measured.
  enum ChangeType
  {
    ALL = 0,   ///< its square: what is by chance and what is not
    COMMON = 1 ///< with half of what is by chance: the product of both halves' changes has none
  };

  /**
   * Per tile, the mean of the change of the mean, scale * sum - held, over pixels that are not at
   * silhouettes (1 / depth differs by more than one percent from the mean of two opposite neighbours',
   * or one of these shows no surface). Waits for the GPU; a value per 1024 pixels.
   */
  std::vector<float> ReadChanges(vtkOpenGLRenderWindow* window, vtkShadowReceivers* receivers,
    int layer, float scale, ChangeType change);

  vtkTypeInt64 GetBytes() const;
  int GetNumberOfBuilds() const;

  /// Frees the textures, and keeps the shaders for the next time.
  void ReleaseTextures(vtkWindow* window);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  enum TextureName
  {
    BASE = 0,
    SUM = 1,
    HELD = 2,
    HALF = 3,
    HELD_HALF = 4,
    NUMBER_OF_TEXTURES = 5
  };

  vtkSmartPointer<vtkShadowTextureArray> Textures[NUMBER_OF_TEXTURES];
  vtkNew<vtkShadowTextureArray> Tiles;
  vtkShadowShader MixShader;
  vtkShadowShader TilesShader;
  vtkShadowFramebuffer Framebuffer;

  bool Bind(vtkOpenGLRenderWindow* window, vtkShadowTextureArray* target, int layer);
  void Mix(vtkOpenGLRenderWindow* window, vtkShadowTextureArray* target,
    vtkShadowTextureArray* first, vtkShadowTextureArray* second, int layer, float firstShare,
    float secondShare);
};

VTK_ABI_NAMESPACE_END
#endif
