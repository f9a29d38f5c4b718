// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowCasterList
 * @brief   The visible opaque props of a renderer from frame to frame.
 *
 * An update walks the renderer's props, assemblies down to their leaves, refreshes the entry of each,
 * and writes what is new to the buffer.
 */

#ifndef vtkShadowCasterList_h
#define vtkShadowCasterList_h

#include "vtkMatrix4x4.h" // For members
#include "vtkNew.h"       // For members
#include "vtkShadowCasterBuffer.h"
#include "vtkShadowCasterEntry.h"
#include "vtkShadowCasterSource.h"
#include "vtkShadowScreen.h"
#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <array>   // For the origin
#include <utility> // For the rises
#include <vector>  // For the entries

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkProp3D;
class vtkRenderer;

class vtkShadowCasterList
{
public:
  using Body = vtkShadowCasters::Body;

  std::vector<vtkShadowCasterEntry> Entries;
  vtkShadowCasterBuffer Buffer;
  std::vector<Body> Bodies;
  /// Of the coordinates in the buffer, in world coordinates.
  std::array<double, 3> Origin{};

  /// Finds for flat casters whether they have receivers (see vtkShadowCasterEntry::HasReceivers).
  vtkShadowCasterEntry::Change Update(vtkRenderer* renderer, bool findReceivers);

  /// See vtkShadowCasters::GetLargestRise.
  double GetLargestRise(const vtkProp* prop) const;

  /// Makes the next Update look for receivers again, whatever it finds; all count until then.
  void ForgetReceivers();

private:
  void Note(const vtkShadowCasterEntry::Change& change);
  void VisitProps(vtkRenderer* renderer);
  void VisitProp(vtkProp* prop);
  void VisitLeaf(vtkProp* leaf, vtkMatrix4x4* matrix, vtkProp* top);
  vtkShadowCasterEntry& FindEntry(vtkProp3D* prop);
  void RemoveEntries(std::size_t first, std::size_t last);
  void FindScreen(vtkRenderer* renderer);
  void PlaceEntries();
  bool MoveOrigin();
  void CollectBodies();
  void FindReceiversOfPlanes();
  void CollectRises();
  bool HasReceivers(const Body& plane, int lightSide, const Body& all) const;

  std::size_t Cursor = 0;
  vtkShadowCasterSource Source;
  bool HasOrigin = false;
  std::vector<float> Scratch;
  vtkShadowScreen Screen;
  vtkNew<vtkMatrix4x4> Matrix;
  vtkShadowCasterEntry::Change Changes; // of this update
  bool MustCollect = false;
  std::vector<std::pair<const vtkProp*, double>> Rises; // of flat props, sorted
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowCasterList.h
