// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the last frame with new shadows cost.
 */

#ifndef FrameClock_h
#define FrameClock_h

#include "vtkSoftShadowPass.h"

#include <chrono>
#include <string>

namespace softshadows
{

/**
 * Frames that only draw the menu anew reuse the pass's shadows and say nothing about its cost: of
 * these the times are not taken over. Times are from one glFinish to the next, which the caller
 * makes: before Begin and before End.
 */
class FrameClock
{
public:
  void Begin();

  /// True if the frame drew visibility.
  bool End(vtkSoftShadowPass* pass);

  /// The pass is another one.
  void Reset() { *this = FrameClock(); }

  double GetMilliseconds() const { return this->Milliseconds; }

  /// "23.4 ms a frame, 12.3 ms of it shadows"
  std::string Spell() const;

private:
  std::chrono::steady_clock::time_point Start;
  double Milliseconds = 0.0;
  double ShadowMilliseconds = 0.0;
  vtkTypeInt64 VisibilityFrames = -1;
  vtkTypeInt64 ShaderBuilds = 0;
  bool BuiltShaders = false;
};

}

#endif
