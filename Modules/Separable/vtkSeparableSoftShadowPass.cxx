// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSeparableSoftShadowPass.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSeparableReuseCount.h"
#include "vtkSeparableStep.h"
#include "vtkSeparableTarget.h"
#include "vtkShaderProgram.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowServices.h"
#include "vtkWeakPointer.h"

#include "vtkSeparableColumnsFS.h"
#include "vtkSeparableRowsFS.h"
#include "vtkSeparableVisibilityFS.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSeparableSoftShadowPass);

namespace
{
// A row's place may be off by this share of the kernel's half width, because the screen is a raster.
constexpr float SnapTolerance = 0.5f;
// A row's own kernel may be wider or narrower by this share.
constexpr float WidthTolerance = 0.5f;
// The filter's rows are kept in parts that end at these shares of their half width, and at 1.
constexpr double FilterNodes[2] = { 0.5, 0.8 };
// A tap on a node belongs to the part beyond it, however it was rounded.
constexpr double NodeSlack = 1e-4;

struct LightThresholds
{
  vtkWeakPointer<vtkLight> Light;
  double Alpha;
  double Beta;
};
} // namespace

class vtkSeparableSoftShadowPass::Internals
{
public:
  vtkSeparableStep Rows{ vtkSeparableRowsFS };
  vtkSeparableStep Columns{ vtkSeparableColumnsFS };
  vtkSeparableStep Visibility{ vtkSeparableVisibilityFS };

  vtkNew<vtkShadowTextureArray> Points;     // RGBA32F: s, t, d, reach; < 0: blocked
  vtkNew<vtkShadowTextureArray> SearchRows; // RGBA32F: sum, number to the node; sum, number beyond
  vtkNew<vtkShadowTextureArray> FilterRows; // RGBA32F: blocked weights in three parts, depth gap
  vtkSeparableReuseCount Reuse;

  std::vector<LightThresholds> Thresholds;

  // Null if the light has none of its own.
  const LightThresholds* Find(const vtkLight* light) const
  {
    const auto found = std::find_if(this->Thresholds.begin(), this->Thresholds.end(),
      [light](const LightThresholds& entry) { return light && entry.Light == light; });
    return found == this->Thresholds.end() ? nullptr : &*found;
  }

  void Remove(const vtkLight* light)
  {
    this->Thresholds.erase(
      std::remove_if(this->Thresholds.begin(), this->Thresholds.end(),
        [light](const LightThresholds& entry) { return !entry.Light || entry.Light == light; }),
      this->Thresholds.end());
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
void vtkSeparableSoftShadowPass::SetLightThresholds(vtkLight* light, double alpha, double beta)
{
  if (!light)
  {
    vtkErrorMacro("Thresholds are for a light, and there is none.");
    return;
  }
  alpha = vtkMath::ClampValue(alpha, 0.0, 1.0);
  beta = vtkMath::ClampValue(beta, 0.0, 1.0);
  const LightThresholds* found = this->Impl->Find(light);
  if (!found || found->Alpha != alpha || found->Beta != beta)
  {
    this->Impl->Remove(light);
    this->Impl->Thresholds.push_back({ light, alpha, beta });
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkSeparableSoftShadowPass::ResetLightThresholds(vtkLight* light)
{
  if (this->Impl->Find(light))
  {
    this->Impl->Remove(light);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkSeparableSoftShadowPass::GetLightAlpha(vtkLight* light) const
{
  const LightThresholds* found = this->Impl->Find(light);
  return found ? found->Alpha : this->Alpha;
}

//------------------------------------------------------------------------------
double vtkSeparableSoftShadowPass::GetLightBeta(vtkLight* light) const
{
  const LightThresholds* found = this->Impl->Find(light);
  return found ? found->Beta : this->Beta;
}

//------------------------------------------------------------------------------
vtkSoftShadowRequirements vtkSeparableSoftShadowPass::GetRequirements() const
{
  vtkSoftShadowRequirements requirements = this->Superclass::GetRequirements();
  requirements.Proof = this->DebugView == DEBUG_NONE
    ? vtkSoftShadowRequirements::PROVES_LIT_AND_BLOCKED
    : vtkSoftShadowRequirements::PROVES_LIT;
  return requirements;
}

//------------------------------------------------------------------------------
std::vector<vtkSeparableStep*> vtkSeparableSoftShadowPass::GetSteps()
{
  return { &this->Impl->Rows, &this->Impl->Columns, &this->Impl->Visibility };
}

//------------------------------------------------------------------------------
std::vector<vtkShadowTextureArray*> vtkSeparableSoftShadowPass::GetTextures()
{
  Internals& impl = *this->Impl;
  return { impl.Points, impl.SearchRows, impl.FilterRows, impl.Reuse.GetShares(SEARCH_STAGE),
    impl.Reuse.GetShares(FILTER_STAGE) };
}

//------------------------------------------------------------------------------
bool vtkSeparableSoftShadowPass::WritesShares(int stage) const
{
  return this->CountReuse || (stage == SEARCH_STAGE && this->DebugView == DEBUG_SEARCH_REUSE);
}

//------------------------------------------------------------------------------
void vtkSeparableSoftShadowPass::Add(const vtkSoftShadowServices& services)
{
  Internals& impl = *this->Impl;
  bool allocated = vtkSeparableSoftShadowPass::Allocate(
    services, vtkShadowTextureArray::RGBA32F, { impl.Points, impl.SearchRows, impl.FilterRows });
  for (int stage = 0; stage < vtkSeparableReuseCount::Stages; ++stage)
  {
    allocated = allocated &&
      (!this->WritesShares(stage) ||
        vtkSeparableSoftShadowPass::Allocate(
          services, vtkShadowTextureArray::R32F, { impl.Reuse.GetShares(stage) }));
  }
  if (!allocated)
  {
    return;
  }
  services.BeginStep("rows");
  this->DrawRows(services);
  services.BeginStep("columns");
  this->DrawColumns(services);
  services.BeginStep("filter");
  this->DrawVisibility(services);
  if (this->CountReuse)
  {
    impl.Reuse.Add(services.Estimate);
    const auto percent = [&impl](int stage)
    { return static_cast<vtkTypeInt64>(std::lround(100.0 * impl.Reuse.GetShare(stage))); };
    services.SetCounts({ { "percent_of_search_rows_reused", percent(SEARCH_STAGE) },
      { "percent_of_filter_rows_reused", percent(FILTER_STAGE) } });
  }
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkSeparableSoftShadowPass::UseRows(
  vtkSeparableStep& step, const vtkSoftShadowServices& services)
{
  vtkShaderProgram* program = this->UseStep(step, services);
  if (program)
  {
    program->SetUniformi("footprint", this->Footprint ? 1 : 0);
    const float axes[2][2] = { { 1.0f, 0.0f }, { 0.0f, 1.0f } };
    program->SetUniform2f("rowAxis", axes[this->RowAxis]);
    program->SetUniform2f("columnAxis", axes[1 - this->RowAxis]);
  }
  return program;
}

//------------------------------------------------------------------------------
void vtkSeparableSoftShadowPass::SetReuseUniforms(
  vtkShaderProgram* program, const vtkSoftShadowServices& services)
{
  const vtkShadowMapView& view = services.GetMapView();
  float mapToScreen[16];
  vtkSeparableStep::MapToScreen(services, view, mapToScreen);
  program->SetUniformMatrix4x4("mapToScreen", mapToScreen);
  program->SetUniformi("receiverPoints", this->Impl->Points->Activate());
  program->SetUniformi("reusePublished", this->Reuse == REUSE_AS_PUBLISHED ? 1 : 0);
  program->SetUniformf("reuseSnap", SnapTolerance);
  const float size[2] = { static_cast<float>(services.Receivers->GetWidth()),
    static_cast<float>(services.Receivers->GetHeight()) };
  program->SetUniform2f("screenSize", size);
  const double* range = services.Renderer->GetActiveCamera()->GetClippingRange();
  const float limits[2] = { static_cast<float>(
                              this->GetLightAlpha(services.Source) * (view.Far - view.Near)),
    static_cast<float>(this->GetLightBeta(services.Source) * (range[1] - range[0])) };
  program->SetUniform2f("reusePublishedLimits", limits);
}

//------------------------------------------------------------------------------
std::array<float, 3> vtkSeparableSoftShadowPass::GetRowWeights(
  const vtkSoftShadowServices& services) const
{
  const int taps = services.Emitter.HasExtent() ? this->FilterWidth : 1;
  const double center = services.Emitter.WindowCenter[this->RowAxis];
  const double halfSize = services.Emitter.WindowHalfSize[this->RowAxis];
  std::array<float, 3> weights = { { 0.0f, 0.0f, 0.0f } };
  for (int i = 0; i < taps; ++i)
  {
    const double tap = (2.0 * i + 1.0) / taps - 1.0;
    const double window = center + halfSize * tap;
    const double weight = this->HasGaussianWeights() ? std::exp(-2.0 * window * window) : 1.0;
    const double x = std::abs(tap);
    const int part = x < FilterNodes[0] - NodeSlack ? 0 : (x < FilterNodes[1] - NodeSlack ? 1 : 2);
    weights[part] += static_cast<float>(weight);
  }
  return weights;
}

//------------------------------------------------------------------------------
void vtkSeparableSoftShadowPass::DrawRows(const vtkSoftShadowServices& services)
{
  Internals& impl = *this->Impl;
  if (vtkShaderProgram* program = this->UseRows(impl.Rows, services))
  {
    // No ray from a pixel that was proved lit meets a blocker: the footprint leaves its row empty.
    const auto setPart = [this, program](bool proved)
    { program->SetUniformi("provedByFootprint", proved && this->Footprint ? 1 : 0); };
    this->GetTarget().Draw(services.Window, impl.Rows.GetShader(),
      { { impl.Points, 0.0f }, { impl.SearchRows, 0.0f } }, services.Marks,
      this->GetSearchTaps(services), setPart);
    vtkSeparableSoftShadowPass::EndStep(services);
  }
}

//------------------------------------------------------------------------------
void vtkSeparableSoftShadowPass::DrawColumns(const vtkSoftShadowServices& services)
{
  Internals& impl = *this->Impl;
  if (vtkShaderProgram* program = this->UseRows(impl.Columns, services))
  {
    this->SetReuseUniforms(program, services);
    program->SetUniformi("searchRows", impl.SearchRows->Activate());
    const std::array<float, 3> weights = this->GetRowWeights(services);
    program->SetUniformf("rowTotal", weights[0] + weights[1] + weights[2]);
    program->SetUniformf("alpha", static_cast<float>(this->GetLightAlpha(services.Source)));
    vtkShadowTextureArray* shares =
      this->WritesShares(SEARCH_STAGE) ? impl.Reuse.GetShares(SEARCH_STAGE) : nullptr;
    const int taps = this->GetSearchTaps(services);
    this->GetTarget().Draw(services.Window, impl.Columns.GetShader(),
      { { impl.FilterRows, vtkSeparableStep::ProvedRow },
        { shares, vtkSeparableReuseCount::Uncounted } },
      services.Marks, taps * taps);
    impl.SearchRows->Deactivate();
    impl.Points->Deactivate();
    vtkSeparableSoftShadowPass::EndStep(services);
  }
}

//------------------------------------------------------------------------------
void vtkSeparableSoftShadowPass::DrawVisibility(const vtkSoftShadowServices& services)
{
  Internals& impl = *this->Impl;
  if (vtkShaderProgram* program = this->UseRows(impl.Visibility, services))
  {
    this->SetReuseUniforms(program, services);
    program->SetUniformi("filterRows", impl.FilterRows->Activate());
    vtkShadowTextureArray* searchShares = impl.Reuse.GetShares(SEARCH_STAGE);
    program->SetUniformi("searchShares", searchShares->Activate(services.Window));
    program->SetUniformi("debugView", this->DebugView);
    program->SetUniformf("beta", static_cast<float>(this->GetLightBeta(services.Source)));
    program->SetUniformf("widthTolerance", WidthTolerance);
    program->SetUniformf("weight", static_cast<float>(services.Emitter.Weight));
    const std::array<float, 3> weights = this->GetRowWeights(services);
    program->SetUniform3f("rowWeights", weights.data());
    const int taps = this->GetFilterTaps(services);
    services.DrawMarked(impl.Visibility.GetShader(), taps * taps);
    if (this->CountReuse)
    {
      this->GetTarget().Draw(services.Window, impl.Visibility.GetShader(),
        { { nullptr, 0.0f },
          { impl.Reuse.GetShares(FILTER_STAGE), vtkSeparableReuseCount::Uncounted } },
        services.Marks, taps * taps);
    }
    searchShares->Deactivate();
    impl.FilterRows->Deactivate();
    impl.Points->Deactivate();
    vtkSeparableSoftShadowPass::EndStep(services);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkSeparableSoftShadowPass::GetReuseImage(int stage)
{
  return this->Impl->Reuse.MakeImage(stage);
}

//------------------------------------------------------------------------------
double vtkSeparableSoftShadowPass::GetReuseShare(int stage)
{
  return this->Impl->Reuse.GetShare(stage);
}

//------------------------------------------------------------------------------
void vtkSeparableSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Reuse: " << (this->Reuse == REUSE_BY_KERNEL ? "by kernel" : "as published")
     << "\n";
  os << indent << "Alpha: " << this->Alpha << "\n";
  os << indent << "Beta: " << this->Beta << "\n";
  os << indent << "Footprint: " << (this->Footprint ? "on" : "off") << "\n";
  os << indent << "RowAxis: " << (this->RowAxis == ROWS_ALONG_S ? "s" : "t") << "\n";
  os << indent << "CountReuse: " << (this->CountReuse ? "on" : "off") << "\n";
  const char* const views[] = { "none", "search_reuse", "filter_reuse" };
  os << indent << "DebugView: " << views[this->DebugView] << "\n";
  os << indent << "LightThresholds: " << this->Impl->Thresholds.size() << "\n";
}
VTK_ABI_NAMESPACE_END
