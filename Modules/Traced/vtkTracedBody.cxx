// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedBody.h"

#include "vtkTracedDevice.h"
#include "vtkTracedEmbree.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkTracedBody::vtkTracedBody(std::shared_ptr<vtkTracedDevice> device)
  : Device(std::move(device))
{
}

//------------------------------------------------------------------------------
vtkTracedBody::~vtkTracedBody()
{
  this->ReleaseScene();
}

//------------------------------------------------------------------------------
void vtkTracedBody::MakeScene()
{
  this->ReleaseScene();
  this->Scene = rtcNewScene(this->Device->GetHandle());
  rtcSetSceneFlags(this->Scene, RTC_SCENE_FLAG_ROBUST);
}

//------------------------------------------------------------------------------
void vtkTracedBody::CommitScene()
{
  rtcCommitScene(this->Scene);
  if (this->Device->HasFailed())
  {
    this->ReleaseScene();
  }
}

//------------------------------------------------------------------------------
void vtkTracedBody::ReleaseScene()
{
  if (this->Scene)
  {
    rtcReleaseScene(this->Scene);
    this->Scene = nullptr;
  }
}
VTK_ABI_NAMESPACE_END
