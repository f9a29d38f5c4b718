// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowServices
 * @brief   All that a technique is given: what it estimates visibility from, and what it uses for it.
 *
 * Uniforms of the shared snippets, drawing over the pixels that are marked, times and counts. Copies tell
 * the same timers and statistics. What cannot be had is told to vtkShadowFailures.
 */

#ifndef vtkSoftShadowServices_h
#define vtkSoftShadowServices_h

#include "vtkRenderingSoftShadowsVisibilityModule.h" // For export macro
#include "vtkSoftShadowContext.h"
#include "vtkSoftShadowSamples.h" // For samples
#include "vtkSoftShadowsABI.h"    // For the ABI namespace

#include <functional> // For points
#include <string>     // For names
#include <utility>    // For counts
#include <vector>     // For points

VTK_ABI_NAMESPACE_BEGIN
class vtkShaderProgram;
class vtkShadowShader;
class vtkShadowMapStore;
class vtkSoftShadowFits;
class vtkSoftShadowPixelCount;
class vtkSoftShadowTimers;
struct vtkSoftShadowStatistics;

class VTKRENDERINGSOFTSHADOWSVISIBILITY_EXPORT vtkSoftShadowServices : public vtkSoftShadowContext
{
public:
  /// Whom they ask and tell; all live longer.
  struct Tools
  {
    vtkSoftShadowTimers* Timers = nullptr;
    vtkSoftShadowStatistics* Statistics = nullptr;
    vtkSoftShadowPixelCount* Pixels = nullptr;
    vtkShadowMapStore* Store = nullptr;
    vtkSoftShadowFits* Fits = nullptr;
  };
  explicit vtkSoftShadowServices(const Tools& tools);

  /**
   * Sets the uniforms of the snippets vtkShadowReceiver and vtkShadowLight and binds the receivers.
   * Needs Receivers->Deactivate.
   */
  void SetReceiverUniforms(vtkShaderProgram* program) const;

  /// Sets the uniforms of vtkShadowDepthMap and vtkShadowKernel for a view, but for the sampler.
  void SetMapUniforms(vtkShaderProgram* program, const vtkShadowMapView& view, int mapSize) const;

  /// The same for the emitter's own map.
  void SetMapUniforms(vtkShaderProgram* program) const;

  /// The view of the emitter's own map.
  const vtkShadowMapView& GetMapView() const;

  /// The views that fit points of the emitter, from the points themselves.
  vtkSoftShadowSamples FitSamples(const std::vector<vtkShadowLightSampling::Sample>& points) const;

  /**
   * The same, kept until the emitter, what casts or settings (a time) changes: a set of the emitter's
   * points, told apart by its number. points are made only if they must be.
   */
  const vtkSoftShadowSamples& FitSamples(int set, vtkMTimeType settings,
    const std::function<std::vector<vtkShadowLightSampling::Sample>()>& points) const;

  /**
   * Makes maps of the views valid and counts them: a texture of the emitter's, told apart by its number.
   * It stays valid until the next emitter, and is kept beyond as memory allows. Null if it cannot be had.
   */
  vtkShadowDepthMaps* BakeMaps(
    const std::vector<vtkShadowMapView>& views, int mapSize, int texture = 0) const;

  /// Gives such a texture back.
  void ReleaseMaps(int texture) const;

  /**
   * Sets the uniforms of vtkShadowSamples and vtkShadowDepthMap, but for the sampler: count views,
   * at most VTK_SOFT_SHADOW_SAMPLES_PER_DRAW, with their weights, whose maps of mapSize texels lie
   * in the layers from firstLayer on. filterSize is the edge of the percentage-closer filter.
   */
  void SetSampleUniforms(vtkShaderProgram* program, const vtkShadowMapView* views,
    const float* weights, size_t count, size_t firstLayer, int mapSize, int filterSize) const;

  /// Taps of a pixel with the uniforms above: of a filter and of what tells creases.
  static double CountSampleTaps(size_t count, int filterSize);

  /**
   * Sets viewToBase and baseToMaps of the views, at most VTK_SOFT_SHADOW_SAMPLES_PER_DRAW: a receiver is
   * brought into the first one's map, and from there into each with three rows of a matrix. Points
   * of one light lie in a plane and look at right angles to it, or are directions: their map
   * coordinates are affine images of each other.
   */
  void SetAffineMapUniforms(
    vtkShaderProgram* program, const vtkShadowMapView* views, size_t count) const;

  /// View to map coordinates, column-major as OpenGL takes it, composed in double.
  void ViewToMap(const vtkShadowMapView& view, float matrix[16]) const;

  /**
   * Draws the technique's shader over the marked pixels and counts the pixels that it filters. Given the
   * taps that a pixel takes at most, long work is drawn in several draws (vtkShadowBands).
   */
  void DrawMarked(vtkShadowShader& shader, double tapsPerPixel = 0.0) const;

  /// Whether so many bytes are more than MapMemory.
  bool ExceedsMapMemory(vtkTypeInt64 bytes) const { return bytes > this->MapMemory; }

  /// How many maps of that size fit a share of MapMemory and the layers of a texture, at least 1.
  size_t GetMapsPerBatch(int mapSize, int shares = 1) const;

  ///@{
  /// Adds to the counts: of maps that were baked, each of that size or of so many texels together; of
  /// textures that were made.
  void CountBakes(int maps, int mapSize) const;
  void CountMaps(int maps, vtkTypeInt64 texels) const;
  void CountAllocations(int textures) const;
  ///@}

  /**
   * Times what follows under this name (a literal) in the statistics' milliseconds; repeated names
   * add up. What a technique does before its first step, and one that names none, counts
   * as "visibility". What is done on the processor is timed by the clock.
   */
  void BeginStep(const char* name, bool onProcessor = false) const;

  /// What a technique counts beyond the statistics' own, by name.
  void SetCounts(std::vector<std::pair<std::string, vtkTypeInt64>> counts) const;

  /// The maps' store, for who bakes for others.
  vtkShadowMapStore& GetStore() const { return *this->Used.Store; }

  /// Which textures of an emitter are not its technique's own: maps from the centres of faces and parts.
  enum MapKind
  {
    FACE_MAPS = 0,
    PART_MAPS = 1,
    FIRST_OF_TECHNIQUE = 2
  };

private:
  Tools Used;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkSoftShadowServices.h
