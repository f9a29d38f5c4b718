// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowFailures
 * @brief   Collects what OpenGL did not have to give, while one lives.
 *
 * Textures, framebuffers and shaders that cannot be had say so to the newest collector there is, and
 * may be deep in a technique: whoever opened the collector knows what it means. Without one it is an
 * error message.
 *
 *     vtkShadowFailures failures;
 *     technique->Add(services);
 *     if (failures.HasAny()) ...
 */

#ifndef vtkShadowFailures_h
#define vtkShadowFailures_h

#include "vtkRenderingSoftShadowsCoreModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                 // For the ABI namespace

#include <string> // For reasons

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGSOFTSHADOWSCORE_EXPORT vtkShadowFailures
{
public:
  vtkShadowFailures();
  ~vtkShadowFailures();
  vtkShadowFailures(const vtkShadowFailures&) = delete;
  vtkShadowFailures& operator=(const vtkShadowFailures&) = delete;

  bool HasAny() const { return !this->First.empty(); }

  /// The first of them, a sentence without its dot: "no memory for ...". Empty if there is none.
  const std::string& GetFirst() const { return this->First; }

  /// Tells the newest collector.
  static void Report(const std::string& reason);

  /// Whether the newest collector has any: what follows need not be drawn.
  static bool IsFailing();

private:
  std::string First;
  vtkShadowFailures* Outer;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowFailures.h
