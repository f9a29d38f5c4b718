// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What vtkSoftShadowPass tells about a frame: visibilities, depth, statistics, the light report.
#include "vtkSoftShadowPass.h"

#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowPassInternals.h"
#include "vtkSoftShadowsOpenGL.h"

#include <algorithm>
#include <limits>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

// Values outside [0, 1] are rounding, negative ones no value at all.
vtkSmartPointer<vtkImageData> MakeImage(const std::vector<float>& values, int width, int height)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* out = static_cast<float*>(image->GetScalarPointer());
  // Sums of rounded weights may fall short of 0 by a few units in the last place.
  constexpr float noValue = -0.5f;
  std::transform(values.begin(), values.end(), out,
    [](float value)
    {
      return value > noValue ? std::min(std::max(value, 0.0f), 1.0f)
                             : std::numeric_limits<float>::quiet_NaN();
    });
  return image;
}

bool CopyImage(vtkImageData* from, vtkImageData* to)
{
  if (!from || !to)
  {
    return false;
  }
  to->ShallowCopy(from);
  return true;
}

// The value of that name in a list of the statistics.
template <typename Value>
Value FindByName(const std::vector<std::pair<std::string, Value>>& list, const std::string& name)
{
  const auto found = std::find_if(
    list.begin(), list.end(), [&name](const auto& entry) { return entry.first == name; });
  return found != list.end() ? found->second : Value(-1);
}

void ReportLight(std::ostream& os, vtkLight* light, const vtkShadowEmitter& emitter)
{
  const char* const shapes[] = { "a rectangle", "a disk", "a point" };
  if (emitter.Directional && light->GetPositional())
  {
    os << "positional, but so far away that its rays are parallel: ";
  }
  os << (emitter.Directional ? "directional, " : "positional, ") << shapes[emitter.Shape];
  if (emitter.HasExtent())
  {
    os << " of half extent " << emitter.HalfSize[0] << " x " << emitter.HalfSize[1];
  }
  if (emitter.HasCone())
  {
    os << ", cone of " << emitter.ConeAngle << " degrees";
  }
  if (emitter.Omni)
  {
    os << ", to all sides";
  }
}

} // namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkSoftShadowPass::GetVisibilityImage(vtkLight* light)
{
  for (size_t i = 0; i < this->Impl->Lights.size(); ++i)
  {
    if (this->Impl->Lights[i].Light == light)
    {
      return this->GetVisibilityImage(static_cast<int>(i));
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkSoftShadowPass::GetVisibilityImage(int litLight)
{
  Internals& impl = *this->Impl;
  if (litLight < 0 || litLight >= static_cast<int>(impl.Lights.size()))
  {
    return nullptr;
  }
  const int width = impl.Viewport[2];
  const int height = impl.Viewport[3];
  const int layer = impl.Lights[litLight].Layer;
  impl.MakeCurrent();
  if (layer >= 0)
  {
    vtkShadowTextureArray* texture = this->GetDataTexture();
    return texture->GetHandle() ? MakeImage(texture->ReadLayer(layer), width, height) : nullptr;
  }
  // A light that casts nothing reaches every surface.
  vtkSmartPointer<vtkImageData> image = impl.Receivers->ReadDepth();
  if (image)
  {
    auto* values = static_cast<float*>(image->GetScalarPointer());
    std::transform(values, values + static_cast<size_t>(width) * height, values,
      [](float depth) { return depth == depth ? 1.0f : depth; });
  }
  return image;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkSoftShadowPass::GetDepthImage()
{
  this->Impl->MakeCurrent();
  return this->Impl->Receivers->ReadDepth();
}

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::GetVisibilityImage(vtkLight* light, vtkImageData* image)
{
  return CopyImage(this->GetVisibilityImage(light), image);
}

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::GetDepthImage(vtkImageData* image)
{
  return CopyImage(this->GetDepthImage(), image);
}

//------------------------------------------------------------------------------
vtkShadowTextureArray* vtkSoftShadowPass::GetVisibilityTexture()
{
  return this->Impl->Target->GetTexture();
}

//------------------------------------------------------------------------------
int vtkSoftShadowPass::GetVisibilityLayer(vtkLight* light) const
{
  for (const Internals::LitLight& lit : this->Impl->Lights)
  {
    if (lit.Light == light)
    {
      return lit.Layer;
    }
  }
  return -1;
}

//------------------------------------------------------------------------------
const vtkSoftShadowStatistics& vtkSoftShadowPass::GetStatistics()
{
  Internals& impl = *this->Impl;
  vtkSoftShadowStatistics& statistics = impl.Statistics;
  statistics.PixelsFiltered = 0;
  impl.MakeCurrent();
  for (size_t i = 0; i < impl.UsedQueries; ++i)
  {
    GLuint pixels = 0;
    glGetQueryObjectuiv(impl.Queries[i], GL_QUERY_RESULT, &pixels);
    statistics.PixelsFiltered += pixels;
  }
  statistics.ProgressivePoints = this->Progressive ? impl.Schedule.GetCount() : 0;
  statistics.Casters = impl.Casters->GetNumberOfCasters();
  statistics.MapperCasters = impl.Casters->GetNumberOfMapperCasters();
  statistics.Triangles = impl.Casters->GetNumberOfTriangles();
  statistics.BytesHeld = impl.Casters->GetBytes() + impl.Receivers->GetBytes() +
    impl.Target->GetBytes() + impl.Accumulator->GetBytes() + impl.Data.Target->GetBytes() +
    impl.Data.Accumulator->GetBytes() + impl.Data.PointMaps->GetTexture()->GetBytes() +
    this->GetTechniqueBytes();
  vtkTypeInt64 drawCalls = this->GetTechniqueDrawCalls();
  for (const auto& maps : impl.Maps)
  {
    statistics.BytesHeld += maps->GetBytes();
    drawCalls += maps->GetNumberOfDrawCalls();
  }
  statistics.BytesHeld += impl.PointMaps->GetTexture()->GetBytes();
  statistics.DrawCalls = drawCalls + impl.PointMaps->GetNumberOfDrawCalls();
  statistics.ShaderBuilds = impl.ProofShader.GetNumberOfBuilds() +
    impl.ConstantShader.GetNumberOfBuilds() + impl.PointShader.GetNumberOfBuilds() +
    impl.Accumulator->GetNumberOfBuilds() + this->GetTechniqueShaderBuilds();
  statistics.Milliseconds = impl.Timers.Collect();
  return statistics;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkSoftShadowPass::GetCount(const std::string& name)
{
  return FindByName(this->GetStatistics().GetCounts(), name);
}

//------------------------------------------------------------------------------
double vtkSoftShadowPass::GetMilliseconds(const std::string& step)
{
  return FindByName(this->GetStatistics().Milliseconds, step);
}

//------------------------------------------------------------------------------
std::string vtkSoftShadowPass::GetLightReport() const
{
  const Internals& impl = *this->Impl;
  std::ostringstream report;
  for (size_t i = 0; i < impl.Lights.size(); ++i)
  {
    const Internals::LitLight& light = impl.Lights[i];
    report << "light " << i << ": ";
    if (!light.Casts)
    {
      report << "casts nothing: " << light.Reason << "\n";
      continue;
    }
    ReportLight(report, light.Light, light.Emitter);
    size_t maps = 0;
    for (const auto& face : impl.Maps[light.Layer]->GetFaces())
    {
      maps += face.HasCasters ? 1 : 0;
    }
    report << (maps > 0 ? "; casts" : "; casts nothing: nothing lies in its way");
    if (const int lost = impl.Maps[light.Layer]->GetNumberTooNear())
    {
      report << ", but not with " << lost
             << " casters, nearer to it than 1e-7 of the distance of the farthest one";
    }
    report << "\n";
  }
  return report.str();
}
VTK_ABI_NAMESPACE_END
