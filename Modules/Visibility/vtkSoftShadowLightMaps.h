// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowLightMaps
 * @brief   The emitters of one light, the views that fit them and their depth maps.
 *
 * A light has one face, or the six of an omni light; a face has one part, or those it is split
 * into. The face's own map serves the proofs and, unsplit, the technique. Parts have maps of their
 * own, baked in batches that fit the memory allowed: a single batch stays valid from frame to
 * frame.
 */

#ifndef vtkSoftShadowLightMaps_h
#define vtkSoftShadowLightMaps_h

#include "vtkNew.h"            // For members
#include "vtkShadowMapView.h"  // For views
#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkType.h"           // For times

#include <vector> // For parts

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
class vtkShadowCasters;
class vtkShadowDepthMaps;
class vtkShadowDepthPyramid;
class vtkShadowMapFitter;
class vtkWindow;

class vtkSoftShadowLightMaps
{
public:
  vtkSoftShadowLightMaps();
  ~vtkSoftShadowLightMaps();
  vtkSoftShadowLightMaps(const vtkSoftShadowLightMaps&) = delete;
  vtkSoftShadowLightMaps& operator=(const vtkSoftShadowLightMaps&) = delete;

  /// An emitter with the view that fits it, if anything blocks it.
  struct Part
  {
    vtkShadowEmitter Emitter;
    vtkShadowMapView View;
    bool HasCasters = false;
  };

  struct Face : Part
  {
    int Layer = 0; // in FaceMaps, if it has casters
    int Axis = -1; // of the cube, which a face of an omni light looks along
    std::vector<Part> Parts;
  };

  /// Fits all views anew if the emitter, the casters, the split or the weights changed.
  void Fit(const vtkShadowEmitter& emitter, const vtkShadowMapFitter& fitter,
    vtkMTimeType castersTime, int split, bool gaussian);

  /// Bakes the faces' maps, and the pyramid over them if asked to. Returns the number of maps
  /// baked; vtkShadowFailures is told what cannot be had.
  int BakeFaces(
    vtkRenderer* renderer, vtkShadowCasters* casters, int mapSize, bool conservative, bool pyramid);

  /**
   * Makes the map of a part valid and returns its layer in the part maps, -1 if it cannot be had. count is the number of
   * layers that may be held at a time; baked is increased by the number of maps drawn. With pyramid
   * the part maps' pyramid is brought up to date.
   */
  int BakePart(vtkRenderer* renderer, vtkShadowCasters* casters, size_t face, size_t part,
    int mapSize, bool conservative, size_t count, bool pyramid, int& baked);

  const std::vector<Face>& GetFaces() const { return this->Faces; }
  /// See vtkShadowMapFitter::CountTooNear; of all faces.
  int GetNumberTooNear() const { return this->NumberTooNear; }
  vtkShadowDepthMaps* GetFaceMaps() { return this->FaceMaps; }
  vtkShadowDepthMaps* GetPartMaps() { return this->PartMaps; }
  vtkShadowDepthPyramid* GetFacePyramid() { return this->FacePyramid; }
  vtkShadowDepthPyramid* GetPartPyramid() { return this->PartPyramid; }

  vtkTypeInt64 GetBytes();
  vtkTypeInt64 GetNumberOfDrawCalls();
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::vector<Face> Faces;
  int NumberTooNear = 0;
  vtkShadowEmitter Emitter;
  vtkMTimeType CastersTime = 0;
  int Split = 0;
  bool Gaussian = false;
  vtkNew<vtkShadowDepthMaps> FaceMaps;
  vtkNew<vtkShadowDepthMaps> PartMaps;
  vtkNew<vtkShadowDepthPyramid> FacePyramid;
  vtkNew<vtkShadowDepthPyramid> PartPyramid;
};

VTK_ABI_NAMESPACE_END
#endif
