// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowStatistics.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

template <typename Value>
Value FindByName(const std::vector<std::pair<std::string, Value>>& list, const std::string& name)
{
  const auto found = std::find_if(
    list.begin(), list.end(), [&name](const auto& entry) { return entry.first == name; });
  return found != list.end() ? found->second : Value(-1);
}

} // namespace

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, vtkTypeInt64>> vtkSoftShadowStatistics::GetCounts() const
{
  std::vector<std::pair<std::string, vtkTypeInt64>> counts = { { "frames", this->Frames },
    { "visibility_frames", this->VisibilityFrames },
    { "progressive_frames", this->ProgressiveFrames }, { "data_frames", this->DataFrames },
    { "maps_baked", this->MapsBaked }, { "texels_drawn", this->TexelsDrawn },
    { "draw_calls", this->DrawCalls }, { "visibility_draws", this->VisibilityDraws },
    { "shader_builds", this->ShaderBuilds }, { "mapper_shader_builds", this->MapperShaderBuilds },
    { "allocations", this->Allocations }, { "pixels_filtered", this->PixelsFiltered },
    { "lights_casting", this->LightsCasting }, { "lights_lit", this->LightsLit },
    { "progressive_points", this->ProgressivePoints }, { "casters", this->Casters },
    { "mapper_casters", this->MapperCasters }, { "triangles", this->Triangles },
    { "bytes_held", this->BytesHeld } };
  counts.insert(counts.end(), this->TechniqueCounts.begin(), this->TechniqueCounts.end());
  return counts;
}
//------------------------------------------------------------------------------
vtkTypeInt64 vtkSoftShadowStatistics::FindCount(const std::string& name) const
{
  return FindByName(this->GetCounts(), name);
}

//------------------------------------------------------------------------------
double vtkSoftShadowStatistics::FindMilliseconds(const std::string& step) const
{
  return FindByName(this->Milliseconds, step);
}
VTK_ABI_NAMESPACE_END
