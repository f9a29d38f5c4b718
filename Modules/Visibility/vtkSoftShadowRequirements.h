// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowRequirements
 * @brief   What a technique needs of a frame.
 */

#ifndef vtkSoftShadowRequirements_h
#define vtkSoftShadowRequirements_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN

struct vtkSoftShadowRequirements
{
  /// What the pyramid of the whole light's map may prove without changing the technique's result.
  enum ProofType
  {
    PROVES_NOTHING = 0,
    PROVES_LIT = 1,
    PROVES_LIT_AND_BLOCKED = 2
  };

  /// A depth map from every emitter's centre.
  bool EmitterMap = true;
  /// Texels along an edge of that map; 0: the pass's MapSize.
  int EmitterMapSize = 0;
  /// That map is rasterised conservatively.
  bool ConservativeMap = false;
  /// The pyramid of that map.
  bool Pyramid = false;
  /// What may be proved from that map or, where there is none, from one that serves the proofs alone.
  int Proof = PROVES_LIT_AND_BLOCKED;
  /// Emitters are weighted by N(0, 0.5) over their window; the parts' weights follow.
  bool GaussianWeights = false;
  /// Split cuts the lights. If not, it changes nothing.
  bool CutLights = true;
  /// Prepare is called for the emitters whose maps are all held at a time, before Add is for the first.
  bool Preparation = false;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkSoftShadowRequirements.h
