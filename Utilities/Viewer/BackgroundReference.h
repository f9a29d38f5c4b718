// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Ray tracing in a thread of its own, ever finer, until it is cancelled.
 */

#ifndef BackgroundReference_h
#define BackgroundReference_h

#include "ReferenceSnapshot.h"
#include "ReferenceTracer.h"

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace softshadows
{

/**
 * Traces one snapshot at a time with growing numbers of rays. Start and Cancel return at once: a
 * trace that runs ends within one pixel, or when its tree of triangles is built.
 */
class BackgroundReference
{
public:
  struct Result
  {
    ReferenceVisibility Images;
    int RaysPerPixel = 0;
  };

  BackgroundReference();
  ~BackgroundReference(); ///< Waits for the thread.
  BackgroundReference(const BackgroundReference&) = delete;
  BackgroundReference& operator=(const BackgroundReference&) = delete;

  /// Cancels what runs. Rays per axis of the light, one trace each, in order.
  void Start(std::shared_ptr<const ReferenceSnapshot> snapshot, std::vector<int> raysPerAxis);

  /// Forgets snapshot and results.
  void Cancel();

  /// The finest trace of the snapshot that is complete; null before the first.
  std::shared_ptr<const Result> GetResult() const;

  /// Whether traces are still to come.
  bool IsRunning() const;

  /// Rays per pixel of the trace that runs, and the share of its pixels that is done.
  std::string SpellProgress() const;

  /// Why tracing failed; empty if it did not.
  std::string GetFailure() const;

private:
  struct Job
  {
    std::shared_ptr<const ReferenceSnapshot> Snapshot;
    std::vector<int> RaysPerAxis;
    std::atomic<bool> Cancelled{ false };
    std::atomic<int> Level{ 0 };
    std::atomic<double> Share{ 0.0 };
    std::atomic<bool> Done{ false };
    std::shared_ptr<const Result> Newest; ///< Guarded.
    std::string Failure;                  ///< Guarded.
  };

  mutable std::mutex Guard;
  std::condition_variable Wake;
  std::shared_ptr<Job> Current; ///< Guarded; what was started last.
  bool Quit = false;            ///< Guarded.
  std::thread Thread;

  void Run();
  void Trace(Job& job);
};

}

#endif
