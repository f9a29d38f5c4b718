// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedWorkers.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkTracedWorkers::~vtkTracedWorkers()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->IsOver = true;
  }
  this->Begun.notify_all();
  for (std::thread& thread : this->Threads)
  {
    thread.join();
  }
}

//------------------------------------------------------------------------------
void vtkTracedWorkers::Start()
{
  const unsigned int cores = std::thread::hardware_concurrency();
  for (unsigned int i = 1; i < cores; ++i)
  {
    this->Threads.emplace_back([this] { this->Wait(); });
  }
}

//------------------------------------------------------------------------------
void vtkTracedWorkers::TakePieces()
{
  for (int piece = this->Next++; piece < this->Count; piece = this->Next++)
  {
    (*this->Work)(piece);
  }
}

//------------------------------------------------------------------------------
void vtkTracedWorkers::Wait()
{
  unsigned long done = 0;
  std::unique_lock<std::mutex> lock(this->Mutex);
  for (;;)
  {
    this->Begun.wait(lock, [this, done] { return this->IsOver || this->Round != done; });
    if (this->IsOver)
    {
      return;
    }
    done = this->Round;
    lock.unlock();
    this->TakePieces();
    lock.lock();
    if (--this->Busy == 0)
    {
      this->Ended.notify_one();
    }
  }
}

//------------------------------------------------------------------------------
void vtkTracedWorkers::Run(int count, const std::function<void(int)>& work)
{
  if (this->Threads.empty())
  {
    this->Start();
  }
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Work = &work;
    this->Count = count;
    this->Next = 0;
    this->Busy = static_cast<int>(this->Threads.size());
    ++this->Round;
  }
  this->Begun.notify_all();
  this->TakePieces();
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Ended.wait(lock, [this] { return this->Busy == 0; });
}
VTK_ABI_NAMESPACE_END
