// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowQueryReader
 * @brief   Asks OpenGL for the results of occlusion queries; tests put another in its place.
 */

#ifndef vtkShadowQueryReader_h
#define vtkShadowQueryReader_h

#include "vtkRenderingSoftShadowsCascadedModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                     // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN

class VTKRENDERINGSOFTSHADOWSCASCADED_EXPORT vtkShadowQueryReader
{
public:
  vtkShadowQueryReader() = default;
  virtual ~vtkShadowQueryReader();
  vtkShadowQueryReader(const vtkShadowQueryReader&) = delete;
  void operator=(const vtkShadowQueryReader&) = delete;

  /// Whether the result of an ended query has come back. Never waits.
  virtual bool IsAvailable(unsigned int query);

  /// The samples that passed. Waits for the GPU unless IsAvailable has said yes.
  virtual unsigned int GetResult(unsigned int query);
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowQueryReader.h
