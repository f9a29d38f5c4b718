// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowDrawnMappers
 * @brief   Which mappers drew which props.
 *
 * Props with levels of detail choose a mapper whenever they are drawn, by the time they are given and
 * by how long mappers took, and no time stamp tells. Receivers and shading must show the same level.
 */

#ifndef vtkSoftShadowDrawnMappers_h
#define vtkSoftShadowDrawnMappers_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <utility> // For pairs
#include <vector>  // For the list

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractMapper;
class vtkProp;

class vtkSoftShadowDrawnMappers
{
public:
  void Clear() { this->Pairs.clear(); }
  void Add(const vtkProp* prop, const vtkAbstractMapper* mapper);

  /**
   * Whether a prop that is in both was drawn by a mapper that the other does not have for it. What is in
   * one only has no say: a delegate may leave props out, or draw more.
   */
  bool Contradicts(const vtkSoftShadowDrawnMappers& other) const;

private:
  // Compared, never followed: both may be gone.
  std::vector<std::pair<const vtkProp*, const vtkAbstractMapper*>> Pairs;
};

VTK_ABI_NAMESPACE_END
#endif
