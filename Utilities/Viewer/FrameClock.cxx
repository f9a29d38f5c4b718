// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FrameClock.h"

#include <cstdio>

namespace softshadows
{

//--------------------------------------------------------------------------------------------------
void FrameClock::Begin()
{
  this->Start = std::chrono::steady_clock::now();
}

//--------------------------------------------------------------------------------------------------
bool FrameClock::End(vtkSoftShadowPass* pass)
{
  const std::chrono::duration<double, std::milli> taken =
    std::chrono::steady_clock::now() - this->Start;
  const vtkSoftShadowStatistics& statistics = pass->GetStatistics();
  if (statistics.VisibilityFrames == this->VisibilityFrames)
  {
    return false;
  }
  this->VisibilityFrames = statistics.VisibilityFrames;
  this->Milliseconds = taken.count();
  this->ShadowMilliseconds = 0.0;
  for (const auto& [name, milliseconds] : statistics.Milliseconds)
  {
    this->ShadowMilliseconds += name == "shading" ? 0.0 : milliseconds;
  }
  const vtkTypeInt64 builds = statistics.ShaderBuilds + statistics.MapperShaderBuilds;
  this->BuiltShaders = builds != this->ShaderBuilds;
  this->ShaderBuilds = builds;
  return true;
}

//--------------------------------------------------------------------------------------------------
std::string FrameClock::Spell() const
{
  char text[96];
  std::snprintf(text, sizeof(text), "%.1f ms a frame, %.1f ms of it shadows%s", this->Milliseconds,
    this->ShadowMilliseconds, this->BuiltShaders ? " (first: shaders built)" : "");
  return text;
}

}
