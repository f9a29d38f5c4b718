// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowCasterSignature
 * @brief   A number that changes with everything that decides which fragments a prop has, and where.
 *
 * VTK's modification times stop at the first object: a mapper's does not tell of a plane that is moved
 * in its collection of clipping planes, nor an actor's of the pixels of its texture. Here every object
 * that counts is asked itself, at any depth. Colours and materials do not count.
 *
 * Pipelines are brought up to date on the way. Nothing is allocated.
 */

#ifndef vtkShadowCasterSignature_h
#define vtkShadowCasterSignature_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <cstdint> // For the sum

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractMapper;
class vtkActor;
class vtkAlgorithm;
class vtkDataObject;
class vtkMapper;
class vtkObject;
class vtkProperty;
class vtkTexture;

class vtkShadowCasterSignature
{
public:
  std::uint64_t Value = 0;

  void Add(std::uint64_t value);
  void Add(double value);

  /// Which object it is, and its modification time.
  void AddObject(vtkObject* object);

  /// A data set with its arrays, or a tree of them.
  void AddData(vtkDataObject* data);

  /// All inputs of an algorithm from a port on, brought up to date.
  void AddInputs(vtkAlgorithm* algorithm, int firstPort);

  void AddClippingPlanes(vtkAbstractMapper* mapper);

  /// The texture's own settings, its transform, its table and its pixels.
  void AddTexture(vtkTexture* texture);

  /// What a property says of shape; of a translucent prop nothing is drawn at all.
  void AddProperty(vtkProperty* property);

  /// Code and values of replaced shaders.
  void AddShaders(vtkActor* actor);

  /// All that decides which fragments the actor's mapper makes of its input.
  void AddActor(vtkActor* actor, vtkMapper* mapper);
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowCasterSignature.h
