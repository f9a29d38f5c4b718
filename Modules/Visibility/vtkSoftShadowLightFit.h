// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowLightFit
 * @brief   The emitters of one light and the views that fit them.
 *
 * A light has one face, or the six of an omni light; a face has one part, or those it is split into. The
 * face's own map serves the proofs and, unsplit, the technique. Parts have maps of their own, in batches
 * that fit the memory allowed.
 */

#ifndef vtkSoftShadowLightFit_h
#define vtkSoftShadowLightFit_h

#include "vtkShadowMapView.h"  // For views
#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkType.h"           // For times

#include <vector> // For parts

VTK_ABI_NAMESPACE_BEGIN
class vtkShadowMapFitter;

class vtkSoftShadowLightFit
{
public:
  /// An emitter with the view that fits it, if anything blocks it.
  struct Part
  {
    vtkShadowEmitter Emitter;
    vtkShadowMapView View;
    bool HasCasters = false;
  };

  struct Face : Part
  {
    int Layer = 0; // of the faces' maps, if it has casters
    int Axis = -1; // of the cube, which a face of an omni light looks along
    std::vector<Part> Parts;
  };

  /// Fits all views anew if the emitter, the casters, the split or the weights changed.
  void Fit(const vtkShadowEmitter& emitter, const vtkShadowMapFitter& fitter,
    vtkMTimeType castersTime, int split, bool gaussian);

  /// The views of the faces that have casters, by layer.
  std::vector<vtkShadowMapView> GetFaceViews() const;

  /// The number of parts with casters.
  size_t GetNumberOfParts() const;

  /**
   * The views of the parts that are held together with one of them, of batches of count. layer: which of
   * them it is.
   */
  std::vector<vtkShadowMapView> GetBatch(
    size_t face, size_t part, size_t count, size_t& layer) const;

  const std::vector<Face>& GetFaces() const { return this->Faces; }
  /// See vtkShadowMapFitter::CountTooNear; of all faces.
  int GetNumberTooNear() const { return this->NumberTooNear; }

private:
  std::vector<Face> Faces;
  int NumberTooNear = 0;
  vtkShadowEmitter Emitter;
  vtkMTimeType CastersTime = 0;
  int Split = 0;
  bool Gaussian = false;
};

VTK_ABI_NAMESPACE_END
#endif
