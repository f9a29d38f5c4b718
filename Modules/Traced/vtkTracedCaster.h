// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedCaster
 * @brief   The bodies of one caster and where they are: the one builder of what rays can hit.
 *
 * | Caster | Bodies |
 * | --- | --- |
 * | triangles, also with clipping planes and textures with alpha | a mesh in model coordinates |
 * | points and lines wider than a pixel, as wide as they are drawn | spheres, tubes, squares and bands in the world |
 * | glyphs | a mesh per source, placed once per glyph |
 * | spheres and sticks that are imposters | spheres and tubes in model coordinates |
 *
 * What only a shader or an unknown mapper knows has no bodies, and a reason instead.
 */

#ifndef vtkTracedCaster_h
#define vtkTracedCaster_h

#include "vtkShadowCasterShape.h"
#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkTracedBody.h"
#include "vtkTracedRounds.h"

#include <memory> // For bodies
#include <string> // For the reason
#include <vector> // For placements

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkPolyData;
class vtkTracedMesh;

class vtkTracedCaster
{
public:
  explicit vtkTracedCaster(std::shared_ptr<vtkTracedDevice> device);
  ~vtkTracedCaster();
  vtkTracedCaster(const vtkTracedCaster&) = delete;
  void operator=(const vtkTracedCaster&) = delete;

  struct Work
  {
    bool Moved = false; // placements are others
    int Built = 0;      // bodies
    int Refitted = 0;
  };

  /// Takes over what changed of a shape.
  Work Update(const vtkShadowCasterShape& shape);

  const std::vector<vtkTracedPlacement>& GetPlacements() const { return this->Placements; }

  /// Why it casts nothing; empty if it casts.
  const std::string& GetReason() const { return this->Reason; }

  vtkTypeInt64 GetBytes() const;

private:
  void Build(const vtkShadowCasterShape& shape, Work& work);
  void BuildTriangles(
    const vtkShadowCasterShape& shape, const vtkShadowCasterGeometry& triangles, Work& work);
  void BuildStrokes(const vtkShadowCasterShape& shape, Work& work);
  void BuildFromMapper(const vtkShadowCasterShape& shape, Work& work);
  void BuildGlyphs(vtkActor* actor, Work& work);
  void TakeRounds(
    std::vector<vtkTracedRounds::Round> rounds, const vtkTracedVector& center, Work& work);
  void Place(const vtkShadowCasterShape& shape);

  std::shared_ptr<vtkTracedDevice> Device;
  vtkMTimeType Time = 0;
  std::array<double, 16> Matrix{};
  bool IsBaked = false; // the matrix is in the mesh
  bool IsFixed = false; // bodies are in the world: a motion makes them anew
  std::shared_ptr<vtkTracedMesh> Mesh;
  std::shared_ptr<vtkTracedRounds> Rounds;
  std::vector<std::shared_ptr<vtkTracedMesh>> Sources; // of glyphs
  std::vector<vtkTracedPlacement> Glyphs;              // in model coordinates
  std::vector<vtkTracedPlacement> Placements;
  std::string Reason;
};

VTK_ABI_NAMESPACE_END
#endif
