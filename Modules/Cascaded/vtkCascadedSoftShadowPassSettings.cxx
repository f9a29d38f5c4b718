// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The pass's settings: setters, getters and how they are printed.
#include "vtkCascadedSoftShadowPass.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::Change(
  std::array<int, MaximumNumberOfCascades>& values, int cascade, int value)
{
  if (cascade < 0 || cascade >= MaximumNumberOfCascades)
  {
    vtkErrorMacro("There is no cascade " << cascade << "; cascades are numbered 0 to "
                                         << MaximumNumberOfCascades - 1 << ".");
    return;
  }
  if (values[cascade] != value)
  {
    values[cascade] = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkCascadedSoftShadowPass::Read(
  const std::array<int, MaximumNumberOfCascades>& values, int cascade) const
{
  return values[std::min(std::max(cascade, 0), MaximumNumberOfCascades - 1)];
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::SetSampleEdge(int cascade, int edge)
{
  this->Change(this->SampleEdges, cascade, std::min(std::max(edge, 1), 32));
}

//------------------------------------------------------------------------------
int vtkCascadedSoftShadowPass::GetSampleEdge(int cascade) const
{
  return this->Read(this->SampleEdges, cascade);
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::SetResolution(int cascade, int resolution)
{
  this->Change(this->Resolutions, cascade, std::min<int>(std::max<int>(resolution, HIGH), LOW));
}

//------------------------------------------------------------------------------
int vtkCascadedSoftShadowPass::GetResolution(int cascade) const
{
  return this->Read(this->Resolutions, cascade);
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::SetFilterSize(int cascade, int size)
{
  this->Change(this->FilterSizes, cascade, std::min(std::max(size, 1), 15));
}

//------------------------------------------------------------------------------
int vtkCascadedSoftShadowPass::GetFilterSize(int cascade) const
{
  return this->Read(this->FilterSizes, cascade);
}

//------------------------------------------------------------------------------
bool vtkCascadedSoftShadowPass::HasGaussianWeights() const
{
  return this->Weights == vtkShadowLightSampling::GAUSSIAN;
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const patterns[] = { "grid", "stratified", "hammersley" };
  const char* const filters[] = { "screen", "fixed" };
  const char* const resolutions[] = { "high", "medium", "low" };
  os << indent << "NumberOfCascades: " << this->NumberOfCascades << "\n";
  os << indent << "SplitLambda: " << this->SplitLambda << "\n";
  os << indent << "BlendBand: " << this->BlendBand << "\n";
  for (int i = 0; i < MaximumNumberOfCascades; ++i)
  {
    os << indent << "Cascade " << i << ": " << this->SampleEdges[i] << "^2 points, "
       << resolutions[this->Resolutions[i]] << " resolution, filter " << this->FilterSizes[i]
       << "\n";
  }
  os << indent << "Pattern: " << patterns[this->Pattern] << "\n";
  os << indent << "Filter: " << filters[this->Filter] << "\n";
  os << indent << "Weights: " << (this->HasGaussianWeights() ? "gaussian" : "mean") << "\n";
  os << indent << "FitToView: " << (this->FitToView ? "on" : "off") << "\n";
  os << indent << "Adaptive: " << (this->Adaptive ? "on" : "off") << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "Gather: " << (this->Gather ? "on" : "off") << "\n";
  os << indent << "Tint: " << (this->Tint ? "on" : "off") << "\n";
  os << indent << "TintLight: " << this->TintLight << "\n";
}
VTK_ABI_NAMESPACE_END
