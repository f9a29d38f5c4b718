// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowTimers
 * @brief   Milliseconds per step of a frame, by GPU timer queries that nobody waits for.
 *
 * A frame is timed only after the queries of the frame timed before have come back. Steps without
 * GPU work are timed by the clock.
 */

#ifndef vtkSoftShadowTimers_h
#define vtkSoftShadowTimers_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <chrono>  // For CPU steps
#include <memory>  // For timers
#include <string>  // For names
#include <utility> // For pairs
#include <vector>  // For lists

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderTimer;

class vtkSoftShadowTimers
{
public:
  vtkSoftShadowTimers();
  ~vtkSoftShadowTimers();
  vtkSoftShadowTimers(const vtkSoftShadowTimers&) = delete;
  vtkSoftShadowTimers& operator=(const vtkSoftShadowTimers&) = delete;

  void BeginFrame();
  /// Ends the step before, if any. Steps on the processor are timed by the clock.
  void BeginStep(const char* name, bool onProcessor = false);
  void EndFrame();

  /// Name and milliseconds of each step of the last frame that has come back; repeated names add up.
  const std::vector<std::pair<std::string, double>>& Collect();

  void ReleaseGraphicsResources();

private:
  struct Step
  {
    const char* Name = nullptr;
    std::unique_ptr<vtkOpenGLRenderTimer> Timer;
    bool OnProcessor = false;
    double ProcessorMilliseconds = 0.0;
  };

  bool IsReady();
  void EndStep();

  std::vector<Step> Steps; // reused from frame to frame
  size_t Used = 0;
  bool Timing = false;
  bool Pending = false;
  std::chrono::steady_clock::time_point StepStart;
  std::vector<std::pair<std::string, double>> Milliseconds;
};

VTK_ABI_NAMESPACE_END
#endif
