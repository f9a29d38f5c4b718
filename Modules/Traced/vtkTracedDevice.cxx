// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedDevice.h"

#include "vtkShadowFailures.h"
#include "vtkTracedEmbree.h"

#include <mutex>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
std::shared_ptr<vtkTracedDevice> vtkTracedDevice::Get()
{
  static std::mutex mutex;
  static std::weak_ptr<vtkTracedDevice> shared;
  const std::lock_guard<std::mutex> lock(mutex);
  std::shared_ptr<vtkTracedDevice> device = shared.lock();
  if (!device)
  {
    RTCDevice handle = rtcNewDevice(nullptr);
    if (!handle)
    {
      vtkShadowFailures::Report("Embree has no device on this machine");
      return nullptr;
    }
    device.reset(new vtkTracedDevice(handle));
    shared = device;
  }
  return device;
}

//------------------------------------------------------------------------------
vtkTracedDevice::~vtkTracedDevice()
{
  rtcReleaseDevice(this->Handle);
}

//------------------------------------------------------------------------------
bool vtkTracedDevice::HasFailed()
{
  const RTCError error = rtcGetDeviceError(this->Handle);
  if (error == RTC_ERROR_NONE)
  {
    return false;
  }
  vtkShadowFailures::Report(error == RTC_ERROR_OUT_OF_MEMORY
      ? "no memory for Embree's scene"
      : "Embree's error " + std::to_string(static_cast<int>(error)));
  return true;
}
VTK_ABI_NAMESPACE_END
