// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedGlyphs
 * @brief   The glyphs of a vtkGlyph3DMapper: a mesh per source and where it is drawn.
 */

#ifndef vtkTracedGlyphs_h
#define vtkTracedGlyphs_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkTracedBody.h"

#include <memory> // For meshes
#include <vector> // For lists

VTK_ABI_NAMESPACE_BEGIN
class vtkGlyph3DMapper;
class vtkTracedMesh;

struct vtkTracedGlyphs
{
  /**
   * Adds the meshes, and a placement in model coordinates per glyph. False, with nothing added, if the
   * mapper draws what is not known here: composite data, sources that are no polygons.
   */
  static bool Find(vtkGlyph3DMapper* mapper, const std::shared_ptr<vtkTracedDevice>& device,
    std::vector<std::shared_ptr<vtkTracedMesh>>& sources, std::vector<vtkTracedPlacement>& glyphs);
};

VTK_ABI_NAMESPACE_END
#endif
