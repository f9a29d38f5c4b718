// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How far the shown visibility is from ray tracing, while camera and lights rest.
 */

#ifndef ErrorMeter_h
#define ErrorMeter_h

#include "BackgroundReference.h"

#include <memory>
#include <string>
#include <vector>

class vtkRenderer;

namespace softshadows
{

class ErrorMeter
{
public:
  /// Traces what the renderer shows now, in the background. Size in pixels.
  void Start(vtkRenderer* renderer, int width, int height, bool gaussian);

  /// Something moved: what was traced is of no use any more.
  void Cancel();

  bool IsRunning() const { return this->Reference.IsRunning(); }
  bool IsStarted() const { return this->Started; }

  /// Whether the reference was traced for the light's points weighted like this.
  bool IsFor(bool gaussian) const { return this->Started && this->Gaussian == gaussian; }

  /// The finest reference so far, null if there is none. Another object after each refinement.
  std::shared_ptr<const BackgroundReference::Result> GetReference() const
  {
    return this->Reference.GetResult();
  }

  /**
   * Root of the mean squared error of a light's visibility over all pixels that have one, without
   * silhouettes, as softshadow compare has it. Top row first. NaN without a reference.
   */
  double Measure(int light, const std::vector<float>& visibility);

  /// Such as "RMSE 0.0123 to ray tracing with 64 rays per pixel; 256 rays per pixel: 40 %".
  std::string Spell(double rmse) const;

private:
  BackgroundReference Reference;
  std::shared_ptr<const ReferenceSnapshot> Snapshot; ///< Kept for its surfaces.
  /// Of SilhouettesOf.
  std::vector<unsigned char> Silhouettes;
  std::shared_ptr<const BackgroundReference::Result> SilhouettesOf;
  bool Started = false;
  bool Gaussian = false;
};

}

#endif
