// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedDevice
 * @brief   Embree's device, which all passes of a process share while there are any.
 */

#ifndef vtkTracedDevice_h
#define vtkTracedDevice_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <memory> // For the shared device

struct RTCDeviceTy;

VTK_ABI_NAMESPACE_BEGIN

class vtkTracedDevice
{
public:
  /// Null, which vtkShadowFailures is told, if Embree gives none.
  static std::shared_ptr<vtkTracedDevice> Get();

  ~vtkTracedDevice();
  vtkTracedDevice(const vtkTracedDevice&) = delete;
  void operator=(const vtkTracedDevice&) = delete;

  RTCDeviceTy* GetHandle() const { return this->Handle; }

  /// Whether Embree had not what it was asked for since the last call; vtkShadowFailures is told.
  bool HasFailed();

private:
  explicit vtkTracedDevice(RTCDeviceTy* handle)
    : Handle(handle)
  {
  }

  RTCDeviceTy* Handle;
};

VTK_ABI_NAMESPACE_END
#endif
