// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Techniques.h"

#include "vtkMarchedSoftShadowPass.h"
#include "vtkPercentageCloserSoftShadowPass.h"
#include "vtkSampledSoftShadowPass.h"
#include "vtkSeparableSoftShadowPass.h"

#include <ostream>

namespace SoftShadowsTesting
{
namespace
{

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSoftShadowPass> MakeSampled(Effort effort, Weights weights)
{
  auto pass = vtkSmartPointer<vtkSampledSoftShadowPass>::New();
  pass->SetMapSize(effort == Effort::Accurate ? 2048 : 512);
  pass->SetNumberOfSamples(effort == Effort::Accurate ? 256 : 16);
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
  pass->SetMapSize(effort == Effort::Accurate ? 2048 : 512);
  pass->SetSearchWidth(effort == Effort::Accurate ? 29 : 11);
  pass->SetFilterWidth(effort == Effort::Accurate ? 41 : 21);
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
  pass->SetMapSize(effort == Effort::Accurate ? 2048 : 512);
  pass->SetRays(effort == Effort::Accurate ? 64 : 16);
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
  pass->SetMapSize(effort == Effort::Accurate ? 2048 : 512);
  pass->SetSearchWidth(effort == Effort::Accurate ? 29 : 11);
  pass->SetFilterWidth(effort == Effort::Accurate ? 41 : 21);
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

}

//------------------------------------------------------------------------------
const std::vector<Technique>& AllTechniques()
{
  static const std::vector<Technique> techniques = {
    { "Sampled", MakeSampled, 0.01, 0.03, 1.0 / 16.0 },
    { "PercentageCloser", MakePercentageCloser, 0.015, 0.03, 1.0 / 11.0 },
    { "Marched", MakeMarched, 0.015, 0.03, 1.0 / 8.0 },
    { "Separable", MakeSeparable, 0.015, 0.03, 1.0 / 11.0, 0.002 },
  };
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
