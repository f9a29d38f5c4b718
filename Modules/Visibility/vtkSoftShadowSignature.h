// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowSignature
 * @brief   All that the visibility of a frame depends on, in a form that can be compared.
 */

#ifndef vtkSoftShadowSignature_h
#define vtkSoftShadowSignature_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkType.h"           // For times

#include <cstdint> // For addresses
#include <cstring> // For doubles
#include <vector>  // For words

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkRenderState;
class vtkRenderer;
struct vtkShadowEmitter;

class vtkSoftShadowSignature
{
public:
  void Clear() { this->Words.clear(); }
  void Add(vtkTypeUInt64 value) { this->Words.push_back(value); }
  void Add(double value)
  {
    vtkTypeUInt64 bits;
    std::memcpy(&bits, &value, sizeof(bits));
    this->Words.push_back(bits);
  }
  void Add(const double* values, int count)
  {
    for (int i = 0; i < count; ++i)
    {
      this->Add(values[i]);
    }
  }

  /// The renderer, its camera and the props that are drawn.
  void AddState(const vtkRenderState* s);

  void AddEmitter(const vtkShadowEmitter& emitter);

  bool operator==(const vtkSoftShadowSignature& other) const { return this->Words == other.Words; }
  void Swap(vtkSoftShadowSignature& other) { this->Words.swap(other.Words); }

private:
  /// The camera's matrices for the renderer's aspect ratio.
  void AddCamera(vtkRenderer* renderer);

  /// Everything about a prop that its receivers depend on.
  void AddProp(vtkProp* prop);

  std::vector<vtkTypeUInt64> Words;
};

VTK_ABI_NAMESPACE_END
#endif
