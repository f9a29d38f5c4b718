// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds and reads the meshes that scenes name: ply, obj, stl, vtp, glb and gltf files.
 */

#ifndef ModelStore_h
#define ModelStore_h

#include "SceneDescription.h"
#include "SceneError.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace softshadows
{

class ModelStore
{
public:
  ModelStore() = default;

  /// Folders in which models are looked for after the scene's own.
  explicit ModelStore(std::vector<std::string> folders)
    : Folders(std::move(folders))
  {
  }

  /**
   * The mesh that a scene in the given folder means: an absolute path as it is, a relative one in
   * that folder, then in the store's folders in their order. Read once, shared ever after. Lines, points
   * and polygons with corners that are not finite are left out. Meshes without normals get smooth ones
   * that keep edges sharper than 60 degrees. Throws SceneError with the model's place: not found, of no
   * known kind, damaged, or without a polygon.
   */
  vtkSmartPointer<vtkPolyData> Load(const ModelShape& model, const std::string& sceneFolder);

  /// One line for each file read so far of which something is not shown: what, and how much of it.
  const std::vector<std::string>& GetNotShown() const { return this->NotShown; }

  /// The endings of the files that can be read, without the dot.
  static const std::vector<std::string>& GetKinds();

private:
  std::vector<std::string> Folders;
  std::map<std::string, vtkSmartPointer<vtkPolyData>> Meshes;
  std::vector<std::string> NotShown;

  std::string Find(const ModelShape& model, const std::string& sceneFolder) const;
};

}

#endif
