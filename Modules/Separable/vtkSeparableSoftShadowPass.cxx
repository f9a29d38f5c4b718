// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSeparableSoftShadowPass.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSeparableStep.h"
#include "vtkSeparableTarget.h"
#include "vtkShaderProgram.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowTextureArray.h"

#include "vtkSeparableColumnsFS.h"
#include "vtkSeparableRowsFS.h"
#include "vtkSeparableVisibilityFS.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSeparableSoftShadowPass);

namespace
{
// In the shares of reuse: not counted.
constexpr float Uncounted = -1.0f;
// A row's place may be off by this share of the kernel's half width, because the screen is a raster.
constexpr float SnapTolerance = 0.5f;
// A row's own kernel may be wider or narrower by this share.
constexpr float WidthTolerance = 0.5f;
// The filter's rows are kept in parts that end at these shares of their half width, and at 1.
constexpr double FilterNodes[2] = { 0.5, 0.8 };
} // namespace

class vtkSeparableSoftShadowPass::Internals
{
public:
  vtkSeparableStep Rows{ vtkSeparableRowsFS };
  vtkSeparableStep Columns{ vtkSeparableColumnsFS };
  vtkSeparableStep Visibility{ vtkSeparableVisibilityFS };
  vtkSeparableTarget Target;

  vtkNew<vtkShadowTextureArray> Points;     // RGBA32F: s, t, d, 1 lit or 2 blocked
  vtkNew<vtkShadowTextureArray> SearchRows; // RGBA32F: sum, number to the node; sum, number beyond
  vtkNew<vtkShadowTextureArray> FilterRows; // RGBA32F: blocked weights in three parts, depth gap
  vtkNew<vtkShadowTextureArray> Shares[2];  // R32F: share of reused rows, per stage

  // Sums and numbers of the shares, per pixel, and the frame they belong to.
  std::vector<float> ShareSums[2];
  std::vector<int> ShareCounts[2];
  int ShareSize[2] = { 0, 0 };
  vtkTypeInt64 ShareFrame = -1;

  std::vector<vtkShadowTextureArray*> GetTextures()
  {
    return { this->Points, this->SearchRows, this->FilterRows, this->Shares[0], this->Shares[1] };
  }
};

//------------------------------------------------------------------------------
vtkSeparableSoftShadowPass::vtkSeparableSoftShadowPass()
  : Impl(new Internals)
{
}

//------------------------------------------------------------------------------
vtkSeparableSoftShadowPass::~vtkSeparableSoftShadowPass() = default;

//------------------------------------------------------------------------------
bool vtkSeparableSoftShadowPass::HasGaussianWeights() const
{
  return this->Weights == vtkShadowLightSampling::GAUSSIAN;
}

//------------------------------------------------------------------------------
void vtkSeparableSoftShadowPass::AddVisibility(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  const int width = context.Receivers->GetWidth();
  const int height = context.Receivers->GetHeight();
  bool allocated = true;
  for (vtkShadowTextureArray* texture :
    { impl.Points.Get(), impl.SearchRows.Get(), impl.FilterRows.Get() })
  {
    allocated = allocated &&
      texture->Allocate(context.Window, vtkShadowTextureArray::RGBA32F, width, height, 1);
  }
  for (int stage = 0; stage < 2 && this->CountReuse; ++stage)
  {
    allocated = allocated &&
      impl.Shares[stage]->Allocate(context.Window, vtkShadowTextureArray::R32F, width, height, 1);
  }
  if (!allocated)
  {
    return;
  }
  this->BeginStep("rows");
  this->DrawRows(context);
  this->BeginStep("columns");
  this->DrawColumns(context);
  this->BeginStep("filter");
  this->DrawVisibility(context);
  if (this->CountReuse)
  {
    this->AddReuse(context);
  }
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkSeparableSoftShadowPass::UseStep(
  vtkShadowShader& shader, const vtkSoftShadowContext& context)
{
  if (!shader.Use(context.Window))
  {
    return nullptr;
  }
  vtkShaderProgram* program = shader.GetProgram();
  this->SetReceiverUniforms(program, context);
  this->SetMapUniforms(
    program, context, context.Maps->GetViews()[context.Layer], context.Maps->GetResolution());
  program->SetUniformi("depthMaps", context.Maps->GetTexture()->Activate());
  program->SetUniformf("mapLayer", static_cast<float>(context.Layer));
  // All taps of a light without extent are the same one.
  const bool hasExtent = context.Emitter.HasExtent();
  program->SetUniformi("searchWidth", hasExtent ? this->SearchWidth : 1);
  program->SetUniformi("filterWidth", hasExtent ? this->FilterWidth : 1);
  program->SetUniformi("footprint", this->Footprint ? 1 : 0);
  program->SetUniformi("kernelGaussian", this->HasGaussianWeights() ? 1 : 0);
  const float axes[2][2] = { { 1.0f, 0.0f }, { 0.0f, 1.0f } };
  program->SetUniform2f("rowAxis", axes[this->RowAxis]);
  program->SetUniform2f("columnAxis", axes[1 - this->RowAxis]);
  return program;
}

//------------------------------------------------------------------------------
void vtkSeparableSoftShadowPass::SetReuseUniforms(
  vtkShaderProgram* program, const vtkSoftShadowContext& context)
{
  const vtkShadowMapView& view = context.Maps->GetViews()[context.Layer];
  float mapToScreen[16];
  vtkSeparableStep::MapToScreen(context, view, mapToScreen);
  program->SetUniformMatrix4x4("mapToScreen", mapToScreen);
  program->SetUniformi("receiverPoints", this->Impl->Points->Activate());
  program->SetUniformi("reusePublished", this->Reuse == REUSE_AS_PUBLISHED ? 1 : 0);
  program->SetUniformf("reuseSnap", SnapTolerance);
  const float size[2] = { static_cast<float>(context.Receivers->GetWidth()),
    static_cast<float>(context.Receivers->GetHeight()) };
  program->SetUniform2f("screenSize", size);
  const double* range = context.Renderer->GetActiveCamera()->GetClippingRange();
  const float limits[2] = { static_cast<float>(this->Alpha * (view.Far - view.Near)),
    static_cast<float>(this->Beta * (range[1] - range[0])) };
  program->SetUniform2f("reusePublishedLimits", limits);
}

//------------------------------------------------------------------------------
std::array<float, 3> vtkSeparableSoftShadowPass::GetRowWeights(
  const vtkSoftShadowContext& context) const
{
  const int taps = context.Emitter.HasExtent() ? this->FilterWidth : 1;
  const double center = context.Emitter.WindowCenter[this->RowAxis];
  const double halfSize = context.Emitter.WindowHalfSize[this->RowAxis];
  std::array<float, 3> weights = { { 0.0f, 0.0f, 0.0f } };
  for (int i = 0; i < taps; ++i)
  {
    const double tap = (2.0 * i + 1.0) / taps - 1.0;
    const double window = center + halfSize * tap;
    const double weight = this->HasGaussianWeights() ? std::exp(-2.0 * window * window) : 1.0;
    const double x = std::abs(tap);
    weights[x < FilterNodes[0] ? 0 : (x < FilterNodes[1] ? 1 : 2)] += static_cast<float>(weight);
  }
  return weights;
}

//------------------------------------------------------------------------------
void vtkSeparableSoftShadowPass::DrawRows(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  if (this->UseStep(impl.Rows.GetShader(), context))
  {
    impl.Target.Draw(context.Window, impl.Rows.GetShader(),
      { { impl.Points, 0.0f }, { impl.SearchRows, 0.0f } }, 0);
    context.Maps->GetTexture()->Deactivate();
    context.Receivers->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkSeparableSoftShadowPass::DrawColumns(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  if (vtkShaderProgram* program = this->UseStep(impl.Columns.GetShader(), context))
  {
    this->SetReuseUniforms(program, context);
    program->SetUniformi("searchRows", impl.SearchRows->Activate());
    const std::array<float, 3> weights = this->GetRowWeights(context);
    program->SetUniformf("rowTotal", weights[0] + weights[1] + weights[2]);
    program->SetUniformf("alpha", static_cast<float>(this->Alpha));
    vtkShadowTextureArray* share = this->CountReuse ? impl.Shares[SEARCH_STAGE].Get() : nullptr;
    impl.Target.Draw(context.Window, impl.Columns.GetShader(),
      { { impl.FilterRows, vtkSeparableStep::ProvedRow }, { share, Uncounted } }, context.Marks);
    impl.SearchRows->Deactivate();
    impl.Points->Deactivate();
    context.Maps->GetTexture()->Deactivate();
    context.Receivers->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkSeparableSoftShadowPass::DrawVisibility(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  if (vtkShaderProgram* program = this->UseStep(impl.Visibility.GetShader(), context))
  {
    this->SetReuseUniforms(program, context);
    program->SetUniformi("filterRows", impl.FilterRows->Activate());
    program->SetUniformf("beta", static_cast<float>(this->Beta));
    program->SetUniformf("widthTolerance", WidthTolerance);
    program->SetUniformf("weight", static_cast<float>(context.Emitter.Weight));
    const std::array<float, 3> weights = this->GetRowWeights(context);
    program->SetUniform3f("rowWeights", weights.data());
    this->DrawFiltered(impl.Visibility.GetShader());
    if (this->CountReuse)
    {
      impl.Target.Draw(context.Window, impl.Visibility.GetShader(),
        { { nullptr, 0.0f }, { impl.Shares[FILTER_STAGE], Uncounted } }, context.Marks);
    }
    impl.FilterRows->Deactivate();
    impl.Points->Deactivate();
    context.Maps->GetTexture()->Deactivate();
    context.Receivers->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkSeparableSoftShadowPass::AddReuse(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  const vtkTypeInt64 frame = this->ChangeStatistics().VisibilityFrames;
  impl.ShareSize[0] = context.Receivers->GetWidth();
  impl.ShareSize[1] = context.Receivers->GetHeight();
  const size_t size = static_cast<size_t>(impl.ShareSize[0]) * impl.ShareSize[1];
  for (int stage = 0; stage < 2; ++stage)
  {
    if (impl.ShareFrame != frame || impl.ShareCounts[stage].size() != size)
    {
      impl.ShareCounts[stage].assign(size, 0);
      impl.ShareSums[stage].assign(size, 0.0f);
    }
    const std::vector<float> shares = impl.Shares[stage]->ReadLayer(0);
    for (size_t i = 0; i < size; ++i)
    {
      if (shares[i] != Uncounted)
      {
        ++impl.ShareCounts[stage][i];
        impl.ShareSums[stage][i] += shares[i];
      }
    }
  }
  impl.ShareFrame = frame;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkSeparableSoftShadowPass::GetReuseImage(int stage)
{
  const Internals& impl = *this->Impl;
  if (stage < SEARCH_STAGE || stage > FILTER_STAGE || impl.ShareCounts[stage].empty())
  {
    return nullptr;
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(impl.ShareSize[0], impl.ShareSize[1], 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  for (size_t i = 0; i < impl.ShareCounts[stage].size(); ++i)
  {
    const int count = impl.ShareCounts[stage][i];
    values[i] = count > 0 ? impl.ShareSums[stage][i] / static_cast<float>(count)
                          : std::numeric_limits<float>::quiet_NaN();
  }
  return image;
}

//------------------------------------------------------------------------------
double vtkSeparableSoftShadowPass::GetReuseShare(int stage)
{
  const Internals& impl = *this->Impl;
  double sum = 0.0;
  double count = 0.0;
  if (stage < SEARCH_STAGE || stage > FILTER_STAGE)
  {
    return 0.0;
  }
  for (size_t i = 0; i < impl.ShareCounts[stage].size(); ++i)
  {
    sum += impl.ShareSums[stage][i];
    count += impl.ShareCounts[stage][i];
  }
  return count > 0.0 ? sum / count : 0.0;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkSeparableSoftShadowPass::GetTechniqueBytes()
{
  vtkTypeInt64 bytes = 0;
  for (vtkShadowTextureArray* texture : this->Impl->GetTextures())
  {
    bytes += texture->GetBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
int vtkSeparableSoftShadowPass::GetTechniqueShaderBuilds()
{
  return this->Impl->Rows.GetShader().GetNumberOfBuilds() +
    this->Impl->Columns.GetShader().GetNumberOfBuilds() +
    this->Impl->Visibility.GetShader().GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkSeparableSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  for (vtkSeparableStep* step :
    { &this->Impl->Rows, &this->Impl->Columns, &this->Impl->Visibility })
  {
    step->GetShader().ReleaseGraphicsResources(window);
  }
  for (vtkShadowTextureArray* texture : this->Impl->GetTextures())
  {
    texture->ReleaseGraphicsResources(window);
  }
  this->Impl->Target.ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkSeparableSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SearchWidth: " << this->SearchWidth << "\n";
  os << indent << "FilterWidth: " << this->FilterWidth << "\n";
  os << indent << "Weights: " << (this->HasGaussianWeights() ? "gaussian" : "mean") << "\n";
  os << indent << "Reuse: " << (this->Reuse == REUSE_BY_KERNEL ? "by kernel" : "as published")
     << "\n";
  os << indent << "Alpha: " << this->Alpha << "\n";
  os << indent << "Beta: " << this->Beta << "\n";
  os << indent << "Footprint: " << (this->Footprint ? "on" : "off") << "\n";
  os << indent << "RowAxis: " << (this->RowAxis == ROWS_ALONG_S ? "s" : "t") << "\n";
  os << indent << "CountReuse: " << (this->CountReuse ? "on" : "off") << "\n";
}
VTK_ABI_NAMESPACE_END
