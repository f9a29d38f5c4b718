// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Techniques.h"

#include "vtkAdaptiveSampledSoftShadowPass.h"
#include "vtkBilateralSoftShadowPass.h"
#include "vtkCascadedSoftShadowPass.h"
#include "vtkMarchedSoftShadowPass.h"
#include "vtkPercentageCloserSoftShadowPass.h"
#include "vtkSampledSoftShadowPass.h"
#include "vtkScreenSpaceSoftShadowPass.h"
#include "vtkSeparableSoftShadowPass.h"
#include "vtkVirtualSoftShadowPass.h"
#ifdef SOFTSHADOWS_HAS_TRACED
#include "vtkTracedSoftShadowPass.h"
#endif

#include <ostream>

namespace SoftShadowsTesting
{
namespace
{

//------------------------------------------------------------------------------
int Choose(Effort effort, int accurate, int moderate, int quick)
{
  return effort == Effort::Accurate ? accurate : effort == Effort::Moderate ? moderate : quick;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSoftShadowPass> MakeSampled(Effort effort, Weights weights)
{
  auto pass = vtkSmartPointer<vtkSampledSoftShadowPass>::New();
  pass->SetMapSize(Choose(effort, 2048, 512, 512));
  pass->SetNumberOfSamples(Choose(effort, 256, 64, 16));
  pass->SetPatternToGrid();
  if (weights == Weights::Gaussian)
  {
    pass->SetWeightsToGaussian();
  }
  else
  {
    pass->SetWeightsToMean();
  }
  return pass;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSoftShadowPass> MakePercentageCloser(Effort effort, Weights weights)
{
  auto pass = vtkSmartPointer<vtkPercentageCloserSoftShadowPass>::New();
  pass->SetMapSize(Choose(effort, 2048, 512, 512));
  pass->SetSearchWidth(Choose(effort, 29, 17, 11));
  pass->SetFilterWidth(Choose(effort, 41, 29, 21));
  if (weights == Weights::Gaussian)
  {
    pass->SetWeightsToGaussian();
  }
  else
  {
    pass->SetWeightsToMean();
  }
  return pass;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSoftShadowPass> MakeMarched(Effort effort, Weights weights)
{
  auto pass = vtkSmartPointer<vtkMarchedSoftShadowPass>::New();
  pass->SetMapSize(Choose(effort, 2048, 512, 512));
  pass->SetRays(Choose(effort, 32, 16, 16));
  if (weights == Weights::Gaussian)
  {
    pass->SetWeightsToGaussian();
  }
  else
  {
    pass->SetWeightsToMean();
  }
  return pass;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSoftShadowPass> MakeSeparable(Effort effort, Weights weights)
{
  auto pass = vtkSmartPointer<vtkSeparableSoftShadowPass>::New();
  pass->SetMapSize(Choose(effort, 2048, 512, 512));
  pass->SetSearchWidth(Choose(effort, 29, 17, 11));
  pass->SetFilterWidth(Choose(effort, 41, 29, 21));
  if (weights == Weights::Gaussian)
  {
    pass->SetWeightsToGaussian();
  }
  else
  {
    pass->SetWeightsToMean();
  }
  return pass;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSoftShadowPass> MakeScreenSpace(Effort effort, Weights weights)
{
  auto pass = vtkSmartPointer<vtkScreenSpaceSoftShadowPass>::New();
  pass->SetMapSize(Choose(effort, 2048, 512, 512));
  pass->SetSearchWidth(Choose(effort, 29, 17, 11));
  pass->SetWeights(
    weights == Weights::Gaussian ? vtkShadowLightSampling::GAUSSIAN : vtkShadowLightSampling::MEAN);
  return pass;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSoftShadowPass> MakeCascaded(Effort effort, Weights weights)
{
  auto pass = vtkSmartPointer<vtkCascadedSoftShadowPass>::New();
  pass->SetMapSize(Choose(effort, 2048, 512, 512));
  pass->SetWeights(
    weights == Weights::Gaussian ? vtkShadowLightSampling::GAUSSIAN : vtkShadowLightSampling::MEAN);
  for (int i = 0; i < vtkCascadedSoftShadowPass::MaximumNumberOfCascades; ++i)
  {
    pass->SetSampleEdge(i, Choose(effort, 16, 8, 4));
    pass->SetResolution(i, vtkCascadedSoftShadowPass::HIGH);
    pass->SetFilterSize(i, 1);
  }
  // Maps cut to the view differ by their texels from view to view; the module's own tests look at
  // that.
  pass->SetFitToView(effort != Effort::Quick);
  return pass;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSoftShadowPass> MakeAdaptiveSampled(Effort effort, Weights weights)
{
  auto pass = vtkSmartPointer<vtkAdaptiveSampledSoftShadowPass>::New();
  pass->SetMapSize(Choose(effort, 2048, 512, 512));
  pass->SetWeights(
    weights == Weights::Gaussian ? vtkShadowLightSampling::GAUSSIAN : vtkShadowLightSampling::MEAN);
  pass->SetFilterSize(0, 1);
  pass->SetTolerance(effort == Effort::Quick ? 0.125 : 0.0);
  pass->SetMaximumLevel(Choose(effort, 3, 3, 2));
  return pass;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSoftShadowPass> MakeVirtual(Effort effort, Weights weights)
{
  auto pass = vtkSmartPointer<vtkVirtualSoftShadowPass>::New();
  pass->SetMapSize(Choose(effort, 2048, 512, 512));
  pass->SetSearchMapSize(Choose(effort, 1024, 256, 256));
  pass->SetSearchWidth(Choose(effort, 24, 16, 12));
  pass->SetAdaptive(effort != Effort::Quick);
  pass->SetWeights(
    weights == Weights::Gaussian ? vtkShadowLightSampling::GAUSSIAN : vtkShadowLightSampling::MEAN);
  return pass;
}

#ifdef SOFTSHADOWS_HAS_TRACED
//------------------------------------------------------------------------------
vtkSmartPointer<vtkSoftShadowPass> MakeTraced(Effort effort, Weights weights)
{
  auto pass = vtkSmartPointer<vtkTracedSoftShadowPass>::New();
  pass->SetRays(Choose(effort, 64, 16, 4));
  pass->SetMostRays(Choose(effort, 256, 64, 16));
  pass->SetWeights(
    weights == Weights::Gaussian ? vtkShadowLightSampling::GAUSSIAN : vtkShadowLightSampling::MEAN);
  return pass;
}
#endif

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSoftShadowPass> MakeBilateral(Effort effort, Weights weights)
{
  auto pass = vtkSmartPointer<vtkBilateralSoftShadowPass>::New();
  pass->SetMapSize(Choose(effort, 2048, 512, 512));
  pass->SetNumberOfSamples(Choose(effort, 64, 32, 15));
  pass->SetWeights(
    weights == Weights::Gaussian ? vtkShadowLightSampling::GAUSSIAN : vtkShadowLightSampling::MEAN);
  return pass;
}

}

//------------------------------------------------------------------------------
const std::vector<Technique>& AllTechniques()
{
  static const std::vector<Technique> techniques = {
    { "Sampled", MakeSampled, 0.01, 0.03, 1.0 / 16.0 },
    { "PercentageCloser", MakePercentageCloser, 0.015, 0.03, 1.0 / 11.0 },
    { "Marched", MakeMarched, 0.015, 0.03, 1.0 / 8.0, 0.008 },
    { "Bilateral", MakeBilateral, 0.01, 0.03, 1.0 / 15.0, 0.01, true, false },
    { "Separable", MakeSeparable, 0.015, 0.03, 1.0 / 11.0, 0.002, true },
    { "Cascaded", MakeCascaded, 0.01, 0.03, 1.0 / 16.0, 0.005, true },
    { "AdaptiveSampled", MakeAdaptiveSampled, 0.02, 0.03, 1.0 / 16.0 },
    { "Virtual", MakeVirtual, 0.015, 0.03, 1.0 / 8.0, 0.0, true },
#ifdef SOFTSHADOWS_HAS_TRACED
    { "Traced", MakeTraced, 0.01, 0.03, 1.0 / 16.0, 0.008, true, false, false },
#endif
  };
  return techniques;
}

//------------------------------------------------------------------------------
std::vector<Technique> EveryTechnique()
{
  std::vector<Technique> techniques = AllTechniques();
  techniques.push_back({ "ScreenSpace", MakeScreenSpace, 1.0, 1.0, 1.0, 0.0, true });
  return techniques;
}

//------------------------------------------------------------------------------
std::ostream& operator<<(std::ostream& os, const Technique& technique)
{
  return os << technique.Name;
}

//------------------------------------------------------------------------------
std::string NameOfTechnique(const testing::TestParamInfo<Technique>& parameter)
{
  return parameter.param.Name;
}

}
