// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedBody
 * @brief   What is placed in the scene, once or many times: a scene of Embree's of its own.
 */

#ifndef vtkTracedBody_h
#define vtkTracedBody_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkTracedVector.h"
#include "vtkType.h" // For sizes

#include <memory> // For the device

struct RTCSceneTy;

VTK_ABI_NAMESPACE_BEGIN
class vtkTracedDevice;

class vtkTracedBody
{
public:
  explicit vtkTracedBody(std::shared_ptr<vtkTracedDevice> device);
  virtual ~vtkTracedBody();
  vtkTracedBody(const vtkTracedBody&) = delete;
  void operator=(const vtkTracedBody&) = delete;

  /// Null if there is nothing to be hit.
  RTCSceneTy* GetScene() const { return this->Scene; }

  /// Of the coordinates here, in those that the body was given in.
  const vtkTracedVector& GetCenter() const { return this->Center; }

  virtual vtkTypeInt64 GetBytes() const = 0;

protected:
  void MakeScene();
  /// Fits the tree to what was added; without the memory for it the body is empty.
  void CommitScene();
  void ReleaseScene();

  std::shared_ptr<vtkTracedDevice> Device;
  RTCSceneTy* Scene = nullptr;
  vtkTracedVector Center{};
};

/// A body and where it is.
struct vtkTracedPlacement
{
  std::shared_ptr<const vtkTracedBody> Body;
  /// The body's coordinates to world coordinates.
  vtkTracedMap ToWorld;
};

VTK_ABI_NAMESPACE_END
#endif
