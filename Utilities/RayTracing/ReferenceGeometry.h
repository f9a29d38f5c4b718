// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReferenceGeometry
 * @brief   The triangles of a renderer's opaque surfaces, in double precision.
 *
 * Read: visible opaque actors (also parts of assemblies) with surface representation; polygons and
 * triangle strips of polygonal and composite data (block visibility and opacity respected). Not read:
 * glyph mappers, lines, vertices, clipping planes, textures with alpha, shader replacements.
 *
 * Coordinates are local: local = Scale * (world - Origin), so that the scene lies in the unit ball.
 * Points are exact numbers, in single precision too. The subtraction happens in double before
 * anything is rounded: moving or scaling the scene changes nothing that its points themselves tell.
 */

#ifndef SoftShadowsRayTracing_ReferenceGeometry_h
#define SoftShadowsRayTracing_ReferenceGeometry_h

#include "ReferenceVector.h"

#include <vector> // For the arrays

class vtkProp;
class vtkRenderer;

namespace softshadows
{

class ReferenceGeometry
{
public:
  struct Triangle
  {
    std::array<unsigned int, 3> Points;
    unsigned int Object = 0;
  };

  /// One actor (or part of an assembly).
  struct Object
  {
    /// The prop in the renderer's list that it belongs to.
    vtkProp* Prop = nullptr;
    bool Casts = true;
    bool Receives = true;
  };

  explicit ReferenceGeometry(vtkRenderer* renderer);

  Vector ToLocal(const Vector& world) const { return this->Scale * (world - this->Origin); }

  /// Twice the triangle's area times its unit normal, in local units.
  Vector AreaVector(const Triangle& triangle) const;

  Vector Origin = { { 0.0, 0.0, 0.0 } };
  double Scale = 1.0;
  std::vector<Vector> Points;
  std::vector<Triangle> Triangles;
  std::vector<Object> Objects;
};

}

#endif
