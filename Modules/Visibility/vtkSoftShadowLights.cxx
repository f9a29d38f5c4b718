// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowLights.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"
#include "vtkShadowLimits.h"
#include "vtkShadowMapFitter.h"
#include "vtkSoftShadowLosses.h"
#include "vtkSoftShadowSignature.h"

#include <algorithm>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

void DescribeEmitter(std::ostream& os, bool positional, const vtkShadowEmitter& emitter)
{
  const char* const shapes[] = { "a rectangle", "a disk", "a point" };
  if (emitter.Directional && positional)
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
std::string vtkSoftShadowLights::Collect(vtkRenderer* renderer)
{
  this->Lights.clear();
  this->FitsByLayer.clear();
  this->Casting = 0;
  std::map<const vtkLight*, vtkSoftShadowLightFit> before;
  before.swap(this->Fits); // what the renderer no longer has goes
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  const int mostLayers = vtkShadowLimits::GetTextureLayers();
  int firstWithout = -1;
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    const auto known = before.find(light);
    if (known != before.end())
    {
      this->Fits.insert(before.extract(known));
    }
    if (!light->GetSwitch())
    {
      continue; // mappers number lit lights only
    }
    LitLight lit;
    lit.Light = light;
    lit.Positional = light->GetPositional() != 0;
    lit.Casts = vtkShadowEmitter::FromLight(light, lit.Emitter, lit.Reason);
    if (lit.Casts && this->Casting == mostLayers)
    {
      lit.Casts = false;
      firstWithout = firstWithout < 0 ? this->GetNumberOfLights() : firstWithout;
      lit.Reason =
        "this OpenGL has no more than " + std::to_string(mostLayers) + " layers of a texture";
    }
    lit.Layer = lit.Casts ? this->Casting++ : -1;
    if (lit.Casts)
    {
      this->FitsByLayer.push_back(&this->Fits[light]);
    }
    this->Lights.push_back(lit);
  }
  std::string news;
  if (firstWithout >= 0 && !this->ToldLayers)
  {
    news = "Light " + std::to_string(firstWithout) +
      " is shown without shadows: " + this->Lights[firstWithout].Reason + ".";
  }
  this->ToldLayers = firstWithout >= 0;
  return news;
}

//------------------------------------------------------------------------------
void vtkSoftShadowLights::SeeFromAfar(const vtkShadowMapFitter& fitter)
{
  for (LitLight& light : this->Lights)
  {
    light.Emitter = light.Casts ? fitter.SeeFromAfar(light.Emitter) : light.Emitter;
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowLights::Hide(const vtkSoftShadowLosses& losses)
{
  for (LitLight& light : this->Lights)
  {
    const std::string& reason = losses.GetReason(light.Layer);
    if (!reason.empty())
    {
      light.Casts = false;
      light.Reason = reason;
      light.Layer = -1;
    }
  }
}

//------------------------------------------------------------------------------
int vtkSoftShadowLights::Find(const vtkLight* light) const
{
  const auto found = std::find_if(this->Lights.begin(), this->Lights.end(),
    [light](const LitLight& lit) { return lit.Light == light; });
  return found == this->Lights.end() ? -1 : static_cast<int>(found - this->Lights.begin());
}

//------------------------------------------------------------------------------
std::vector<int> vtkSoftShadowLights::GetNumbersByLayer() const
{
  std::vector<int> numbers;
  for (size_t i = 0; i < this->Lights.size(); ++i)
  {
    if (this->Lights[i].Casts)
    {
      numbers.push_back(static_cast<int>(i));
    }
  }
  return numbers;
}

//------------------------------------------------------------------------------
void vtkSoftShadowLights::AddTo(vtkSoftShadowSignature& signature) const
{
  for (const LitLight& light : this->Lights)
  {
    signature.Add(static_cast<vtkTypeUInt64>(light.Casts));
    signature.AddEmitter(light.Emitter);
  }
}

//------------------------------------------------------------------------------
std::string vtkSoftShadowLights::Describe() const
{
  std::ostringstream report;
  for (size_t i = 0; i < this->Lights.size(); ++i)
  {
    const LitLight& light = this->Lights[i];
    report << "light " << i << ": ";
    if (!light.Casts)
    {
      report << "casts nothing: " << light.Reason << "\n";
      continue;
    }
    DescribeEmitter(report, light.Positional, light.Emitter);
    const vtkSoftShadowLightFit& fit = *this->FitsByLayer[light.Layer];
    const bool casts = !fit.GetFaceViews().empty();
    report << (casts ? "; casts" : "; casts nothing: nothing lies in its way");
    if (const int lost = fit.GetNumberTooNear())
    {
      report << ", but not with " << lost
             << " casters, nearer to it than 1e-7 of the distance of the farthest one";
    }
    report << "\n";
  }
  return report.str();
}
VTK_ABI_NAMESPACE_END
