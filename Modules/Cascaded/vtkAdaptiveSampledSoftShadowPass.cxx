// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveSampledSoftShadowPass.h"

#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkAdaptiveSampledSoftShadowPass);

//------------------------------------------------------------------------------
vtkAdaptiveSampledSoftShadowPass::vtkAdaptiveSampledSoftShadowPass()
{
  this->NumberOfCascades = 1;
  this->FitToView = false;
  this->Adaptive = true;
  this->Tolerance = 0.0625;
}

//------------------------------------------------------------------------------
void vtkAdaptiveSampledSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
VTK_ABI_NAMESPACE_END
