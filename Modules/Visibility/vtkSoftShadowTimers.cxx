// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowTimers.h"

#include "vtkOpenGLRenderTimer.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkSoftShadowTimers::vtkSoftShadowTimers() = default;

//------------------------------------------------------------------------------
vtkSoftShadowTimers::~vtkSoftShadowTimers() = default;

//------------------------------------------------------------------------------
bool vtkSoftShadowTimers::IsReady()
{
  for (size_t i = 0; i < this->Used; ++i)
  {
    if (!this->Steps[i].Timer->Ready())
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
const std::vector<std::pair<std::string, double>>& vtkSoftShadowTimers::Collect()
{
  if (this->Pending && this->IsReady())
  {
    this->Pending = false;
    this->Milliseconds.clear();
    for (size_t i = 0; i < this->Used; ++i)
    {
      const Step& step = this->Steps[i];
      const double milliseconds = step.OnProcessor
        ? step.ProcessorMilliseconds
        : static_cast<double>(step.Timer->GetElapsedMilliseconds());
      const std::string name = step.Name;
      auto entry = std::find_if(this->Milliseconds.begin(), this->Milliseconds.end(),
        [&name](const std::pair<std::string, double>& other) { return other.first == name; });
      if (entry == this->Milliseconds.end())
      {
        this->Milliseconds.emplace_back(name, milliseconds);
      }
      else
      {
        entry->second += milliseconds;
      }
    }
  }
  return this->Milliseconds;
}

//------------------------------------------------------------------------------
void vtkSoftShadowTimers::BeginFrame()
{
  this->Collect();
  this->Timing = !this->Pending && vtkOpenGLRenderTimer::IsSupported();
  if (this->Timing)
  {
    this->Used = 0;
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowTimers::EndStep()
{
  if (this->Used > 0)
  {
    Step& step = this->Steps[this->Used - 1];
    step.Timer->Stop();
    step.ProcessorMilliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - this->StepStart)
        .count();
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowTimers::BeginStep(const char* name, bool onProcessor)
{
  if (!this->Timing)
  {
    return;
  }
  this->EndStep();
  if (this->Used == this->Steps.size())
  {
    this->Steps.emplace_back();
    this->Steps.back().Timer = std::make_unique<vtkOpenGLRenderTimer>();
  }
  Step& step = this->Steps[this->Used++];
  step.Name = name;
  step.OnProcessor = onProcessor;
  step.Timer->Reset();
  step.Timer->Start();
  this->StepStart = std::chrono::steady_clock::now();
}

//------------------------------------------------------------------------------
void vtkSoftShadowTimers::EndFrame()
{
  if (this->Timing)
  {
    this->EndStep();
    this->Pending = this->Used > 0;
    this->Timing = false;
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowTimers::ReleaseGraphicsResources()
{
  for (Step& step : this->Steps)
  {
    step.Timer->ReleaseGraphicsResources();
  }
  this->Steps.clear();
  this->Used = 0;
  this->Pending = this->Timing = false;
}
VTK_ABI_NAMESPACE_END
