// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowCasterSource
 * @brief   How one prop can be drawn into a depth map, and when what it shows has changed.
 *
 * The only place that knows kinds of props, mappers and data sets.
 */

#ifndef vtkShadowCasterSource_h
#define vtkShadowCasterSource_h

#include "vtkNew.h"            // For members
#include "vtkPropCollection.h" // For members
#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <cstdint> // For signatures
#include <vector>  // For pieces

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkPolyData;
class vtkProp3D;
class vtkShadowCasterSignature;

struct vtkShadowCasterSource
{
  enum RouteType
  {
    /// Nothing opaque to draw.
    NONE,
    /// Its polygons and strips are all there is to see.
    BUFFER,
    /// Only its own mapper knows what it looks like.
    MAPPER
  };

  int Route = NONE;
  /// The visible polygonal data, valid until the pipeline changes. All of it, if IsHull.
  std::vector<vtkPolyData*> Pieces;
  /// What is drawn lies within the triangles of the pieces (and its strokes), whichever the route.
  bool IsHull = false;
  /// The mapper draws the pieces as they are, but for clipping planes and textures.
  bool IsKnown = false;
  /// Points or lines are wider than a pixel: they are drawn as vtkShadowStrokes.
  bool HasStrokes = false;
  /// Changes whenever what the prop casts may have; its matrix is not part of it.
  std::uint64_t Signature = 0;
  /// Changes whenever the prop may show other fragments, which sides are culled included.
  std::uint64_t Look = 0;

  /// Brings the prop's pipeline up to date and looks at it. Reuses the memory of the last call.
  void Inspect(vtkProp3D* prop);

  /**
   * Bounds in model coordinates of everything the prop's mapper draws. False if there are none.
   */
  static bool GetModelBounds(vtkProp3D* prop, double bounds[6]);

private:
  void InspectActor(vtkActor* actor);
  void AddParts(vtkProp3D* prop, vtkShadowCasterSignature& signature);

  vtkNew<vtkPropCollection> Actors; // of the prop at hand
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowCasterSource.h
