// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedScene
 * @brief   Everything that casts, as a scene of Embree's that rays are shot into.
 *
 * Every caster has bodies of its own, of which this holds instances: a rigid motion rebuilds the tree over
 * the instances alone.
 *
 * Local coordinates are Scale * (world - Origin), subtracted in double: the origin is that of the casters,
 * the scale a power of two that brings the scene to the size of about 1.
 */

#ifndef vtkTracedScene_h
#define vtkTracedScene_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkTracedCaster.h"
#include "vtkTracedShaft.h"
#include "vtkTracedVector.h"
#include "vtkType.h" // For times

#include <cstdint> // For numbers
#include <map>     // For casters
#include <memory>  // For casters
#include <string>  // For the report
#include <vector>  // For instances

struct RTCGeometryTy;
struct RTCSceneTy;

VTK_ABI_NAMESPACE_BEGIN
class vtkShadowCasters;
class vtkTracedDevice;

class vtkTracedScene
{
public:
  vtkTracedScene() = default;
  ~vtkTracedScene();
  vtkTracedScene(const vtkTracedScene&) = delete;
  void operator=(const vtkTracedScene&) = delete;

  /// What Update did since construction.
  struct Counts
  {
    vtkTypeInt64 BodiesBuilt = 0;
    vtkTypeInt64 BodiesRefitted = 0;
    /// Times the tree over the instances was built.
    vtkTypeInt64 ScenesBuilt = 0;
  };

  /**
   * Brings the scene up to date with the casters; nothing is done while their time stays the same. False,
   * which vtkShadowFailures is told, if Embree has not what it takes: then nothing can be shot at.
   */
  bool Update(vtkShadowCasters* casters);

  /// Gives everything back.
  void Clear();

  RTCSceneTy* GetHandle() const { return this->Handle; }

  ///@{
  /// World to local coordinates and back.
  vtkTracedVector ToLocal(const vtkTracedVector& world) const
  {
    return this->Scale * (world - this->Origin);
  }
  vtkTracedVector ToWorld(const vtkTracedVector& local) const
  {
    return (1.0 / this->Scale) * local + this->Origin;
  }
  double GetScale() const { return this->Scale; }
  ///@}

  /// The coordinates of an instance's body to local ones.
  const vtkTracedMap& GetToLocal(unsigned int instance) const { return this->ToLocals[instance]; }

  /// Around every instance, in local coordinates.
  const std::vector<vtkTracedBox>& GetBoxes() const { return this->Boxes; }

  /// How far from the origin anything is at most, in local coordinates.
  double GetReach() const { return this->Reach; }

  /// Why casters cast nothing, a sentence without its dot per reason; empty if all do.
  const std::vector<std::string>& GetReasons() const { return this->Reasons; }

  const Counts& GetCounts() const { return this->Work; }
  vtkTypeInt64 GetBytes() const;

private:
  struct Instance
  {
    RTCGeometryTy* Geometry = nullptr;
    unsigned int Number = 0;
  };

  struct Entry
  {
    std::unique_ptr<vtkTracedCaster> Caster;
    std::vector<Instance> Instances;
    bool IsSeen = false;
  };

  bool Begin();
  bool FindFrame(vtkShadowCasters* casters);
  bool UpdateEntries(vtkShadowCasters* casters, bool framed);
  void Place(Entry& entry);
  void Place(const vtkTracedPlacement& placement, Instance& instance);
  void Attach(Instance& instance);
  void Detach(const Instance& instance);
  void FindBoxes();
  void FindReasons();

  std::shared_ptr<vtkTracedDevice> Device;
  RTCSceneTy* Handle = nullptr;
  std::map<std::uint64_t, Entry> Entries; // by the shapes' numbers
  std::vector<vtkTracedMap> ToLocals;     // by the instances' numbers
  std::vector<unsigned int> FreeNumbers;
  std::vector<vtkTracedBox> Boxes;
  double Reach = 0.0;
  vtkTracedVector Origin{};
  double Scale = 1.0;
  vtkMTimeType CastersTime = 0;
  std::vector<std::string> Reasons;
  Counts Work;
};

VTK_ABI_NAMESPACE_END
#endif
