// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "UnfinishedFiles.h"

#ifndef _WIN32

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>

#include <unistd.h>

namespace softshadows
{
namespace
{

// A signal's handler may neither allocate nor lock: names lie in fixed places.
using Name = std::array<char, 4096>;
std::array<Name, 16> Names{};

// What ends a program unless it says otherwise: people, systems that shut down or keep limits, abort()
// (which VTK calls where a display fails) and faults.
constexpr int Signals[] = { SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGALRM, SIGPIPE, SIGUSR1, SIGUSR2,
  SIGXCPU, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGSYS };

//--------------------------------------------------------------------------------------------------
extern "C" void RemoveUnfinished()
{
  for (const Name& name : Names)
  {
    if (name[0] != '\0')
    {
      unlink(name.data());
    }
  }
}

//--------------------------------------------------------------------------------------------------
// The default action is put back only when all is removed: the same signal may come twice at once, as
// from timeout(1), and another thread would take it.
extern "C" void RemoveAndEnd(int signalNumber)
{
  RemoveUnfinished();
  struct sigaction action = {};
  action.sa_handler = SIG_DFL;
  sigaction(signalNumber, &action, nullptr);
  raise(signalNumber); // waits until this returns
}

//--------------------------------------------------------------------------------------------------
void InstallHandler(int signalNumber)
{
  struct sigaction action = {};
  sigaction(signalNumber, nullptr, &action);
  if (action.sa_handler != SIG_DFL) // ignored, as under nohup, or the application's own
  {
    return;
  }
  action = {};
  action.sa_handler = RemoveAndEnd;
  sigaction(signalNumber, &action, nullptr);
}

}

//--------------------------------------------------------------------------------------------------
void RememberUnfinished(const std::string& path)
{
  const auto place =
    std::find_if(Names.begin(), Names.end(), [](const Name& name) { return name[0] == '\0'; });
  if (place == Names.end() || path.size() >= place->size())
  {
    return;
  }
  // The first character last: until then the handler takes the place for empty.
  std::copy(path.begin() + 1, path.end(), place->begin() + 1);
  (*place)[path.size()] = '\0';
  std::atomic_signal_fence(std::memory_order_seq_cst);
  (*place)[0] = path[0];
  for (const int signalNumber : Signals)
  {
    InstallHandler(signalNumber);
  }
  // Libraries call exit() too, as Xlib where the connection breaks: no destructor runs then.
  static const int installed = std::atexit(RemoveUnfinished);
  static_cast<void>(installed);
}

//--------------------------------------------------------------------------------------------------
void ForgetUnfinished(const std::string& path)
{
  for (Name& name : Names)
  {
    if (path == name.data())
    {
      name[0] = '\0';
    }
  }
}

}

#else

namespace softshadows
{

void RememberUnfinished(const std::string&) {}

void ForgetUnfinished(const std::string&) {}

}

#endif
