// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BackgroundReference.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace softshadows
{

//--------------------------------------------------------------------------------------------------
BackgroundReference::BackgroundReference()
  : Thread([this] { this->Run(); })
{
}

//--------------------------------------------------------------------------------------------------
BackgroundReference::~BackgroundReference()
{
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Quit = true;
    if (this->Current)
    {
      this->Current->Cancelled = true;
    }
  }
  this->Wake.notify_one();
  this->Thread.join();
}

//--------------------------------------------------------------------------------------------------
void BackgroundReference::Start(
  std::shared_ptr<const ReferenceSnapshot> snapshot, std::vector<int> raysPerAxis)
{
  auto job = std::make_shared<Job>();
  job->Snapshot = std::move(snapshot);
  job->RaysPerAxis = std::move(raysPerAxis);
  this->Cancel();
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Current = std::move(job);
  }
  this->Wake.notify_one();
}

//--------------------------------------------------------------------------------------------------
void BackgroundReference::Cancel()
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  if (this->Current)
  {
    this->Current->Cancelled = true;
    this->Current.reset();
  }
}

//--------------------------------------------------------------------------------------------------
std::shared_ptr<const BackgroundReference::Result> BackgroundReference::GetResult() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Current ? this->Current->Newest : nullptr;
}

//--------------------------------------------------------------------------------------------------
bool BackgroundReference::IsRunning() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Current && !this->Current->Done;
}

//--------------------------------------------------------------------------------------------------
std::string BackgroundReference::SpellProgress() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  if (!this->Current || this->Current->Done)
  {
    return {};
  }
  const int perAxis = this->Current->RaysPerAxis[this->Current->Level];
  return std::to_string(perAxis * perAxis) +
    " rays per pixel: " + std::to_string(std::lround(100.0 * this->Current->Share)) + " %";
}

//--------------------------------------------------------------------------------------------------
std::string BackgroundReference::GetFailure() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Current ? this->Current->Failure : std::string();
}

//--------------------------------------------------------------------------------------------------
void BackgroundReference::Run()
{
  for (;;)
  {
    std::shared_ptr<Job> job;
    {
      std::unique_lock<std::mutex> lock(this->Guard);
      this->Wake.wait(
        lock, [this] { return this->Quit || (this->Current && !this->Current->Done); });
      if (this->Quit)
      {
        return;
      }
      job = this->Current;
    }
    try
    {
      this->Trace(*job);
    }
    catch (const std::exception& error)
    {
      const std::lock_guard<std::mutex> lock(this->Guard);
      job->Failure = error.what();
    }
    job->Done = true;
  }
}

//--------------------------------------------------------------------------------------------------
void BackgroundReference::Trace(Job& job)
{
  const unsigned int cores = std::thread::hardware_concurrency();
  for (std::size_t i = 0; i < job.RaysPerAxis.size() && !job.Cancelled; ++i)
  {
    job.Share = 0.0;
    job.Level = static_cast<int>(i);
    const int perAxis = job.RaysPerAxis[i];
    ReferenceTracer tracer(job.Snapshot->GetWidth(), job.Snapshot->GetHeight(), perAxis);
    tracer.SetNumberOfThreads(std::max(1U, cores > 1 ? cores - 1 : 1U)); // one for the window
    tracer.SetCancelled(&job.Cancelled);
    tracer.SetProgress([&job](double share) { job.Share = share; });
    auto result = std::make_shared<Result>();
    result->Images = tracer.Trace(*job.Snapshot);
    result->RaysPerPixel = perAxis * perAxis;
    if (result->Images.Complete)
    {
      const std::lock_guard<std::mutex> lock(this->Guard);
      job.Newest = std::move(result);
    }
  }
}

}
