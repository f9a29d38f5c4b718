// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedWorkers
 * @brief   Threads that wait for work, one per core, the caller's own being one of them.
 */

#ifndef vtkTracedWorkers_h
#define vtkTracedWorkers_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <atomic>             // For the next piece
#include <condition_variable> // For waiting
#include <functional>         // For work
#include <mutex>              // For the work at hand
#include <thread>             // For threads
#include <vector>             // For threads

VTK_ABI_NAMESPACE_BEGIN

class vtkTracedWorkers
{
public:
  vtkTracedWorkers() = default;
  ~vtkTracedWorkers();
  vtkTracedWorkers(const vtkTracedWorkers&) = delete;
  void operator=(const vtkTracedWorkers&) = delete;

  /// Calls work(piece) for every piece from 0 to count - 1, in any order, and returns when all are done.
  void Run(int count, const std::function<void(int)>& work);

private:
  void Start();
  void Wait();
  void TakePieces();

  std::vector<std::thread> Threads;
  std::mutex Mutex;
  std::condition_variable Begun;
  std::condition_variable Ended;
  const std::function<void(int)>* Work = nullptr;
  std::atomic<int> Next{ 0 };
  int Count = 0;
  int Busy = 0;            // threads that have not ended this round
  unsigned long Round = 0; // which work it is
  bool IsOver = false;
};

VTK_ABI_NAMESPACE_END
#endif
