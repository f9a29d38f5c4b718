// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowContext.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
bool vtkSoftShadowContext::HasLight(vtkRenderer* renderer, const vtkLight* light)
{
  vtkCollectionSimpleIterator iterator;
  renderer->GetLights()->InitTraversal(iterator);
  while (const vtkLight* other = renderer->GetLights()->GetNextLight(iterator))
  {
    if (other == light)
    {
      return true;
    }
  }
  return false;
}
VTK_ABI_NAMESPACE_END
