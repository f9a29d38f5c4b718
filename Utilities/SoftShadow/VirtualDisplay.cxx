// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VirtualDisplay.h"

#ifdef __linux__

#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkRenderWindow.h"

#ifdef SOFTSHADOWS_HAVE_X11
#include <X11/Xlib.h>
#endif

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace softshadows
{
namespace
{

constexpr std::chrono::seconds LongestStart{ 30 };

const char* const Advice =
  "there is no display, and VTK as it is installed here cannot draw without "
  "one. Install Xvfb (on Debian: apt-get install xvfb), which is then "
  "started by itself, or set DISPLAY";

/// While VTK tries what kind of window it can make.
class Silence
{
public:
  Silence() { vtkObject::GlobalWarningDisplayOff(); }
  ~Silence() { vtkObject::SetGlobalWarningDisplay(this->Warns); }
  Silence(const Silence&) = delete;
  void operator=(const Silence&) = delete;

private:
  int Warns = vtkObject::GetGlobalWarningDisplay();
};

bool DisplayAnswers()
{
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name)
  {
    return false;
  }
#ifdef SOFTSHADOWS_HAVE_X11
  // Never closed: a server may start afresh when its last client leaves, as Xvfb does, and whoever
  // connects in that moment is refused. The system closes it when the program ends.
  static Display* const connection = XOpenDisplay(name);
  return connection != nullptr;
#else
  return true;
#endif
}

/// In the child: becomes Xvfb, which writes the number of the display it found free.
[[noreturn]] void BecomeServer(int numberEnd, pid_t parent)
{
  // The server must not outlive the tool, even if that is killed.
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent)
  {
    _exit(1);
  }
  const int nowhere = open("/dev/null", O_RDWR);
  dup2(nowhere, STDIN_FILENO);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  const std::string number = std::to_string(numberEnd);
  // Without -noreset the server starts anew whenever the last window closes.
  execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1280x1024x24", "-noreset",
    "-nolisten", "tcp", static_cast<char*>(nullptr));
  _exit(127);
}

/// What the server writes, up to its newline; empty if it ends or takes too long.
std::string ReadNumber(int end)
{
  const auto deadline = std::chrono::steady_clock::now() + LongestStart;
  std::string number;
  for (;;)
  {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
      deadline - std::chrono::steady_clock::now());
    pollfd waiting = { end, POLLIN, 0 };
    const int ready = left.count() > 0 ? poll(&waiting, 1, static_cast<int>(left.count())) : 0;
    if (ready < 0 && errno == EINTR)
    {
      continue;
    }
    char character = 0;
    if (ready <= 0 || read(end, &character, 1) != 1)
    {
      return {};
    }
    if (character == '\n')
    {
      return number;
    }
    number += character;
  }
}

/// Whether VTK draws without a display. Where it chooses among kinds of windows at run time (9.4 and newer)
/// it is told which to make: it would else try the X Window System's for every window, and complain.
bool DrawsWithoutDisplay()
{
  constexpr const char* choice = "VTK_DEFAULT_OPENGL_WINDOW";
  const bool isChosen = std::getenv(choice) != nullptr;
  const Silence silence;
  if (!isChosen)
  {
    setenv(choice, "vtkEGLRenderWindow", 1);
  }
  const vtkNew<vtkRenderWindow> window; // made, not opened
  const bool draws =
    !window->IsA("vtkXOpenGLRenderWindow") && (isChosen || !window->IsA("vtkOSOpenGLRenderWindow"));
  if (!isChosen && !draws)
  {
    unsetenv(choice);
  }
  return draws;
}

void EndServer(int process)
{
  kill(process, SIGTERM);
  while (waitpid(process, nullptr, 0) < 0 && errno == EINTR)
  {
  }
}

}

//--------------------------------------------------------------------------------------------------
bool HasDisplay()
{
  const Silence silence;
  const vtkNew<vtkRenderWindow> window; // made, not opened
  const bool isUnseen = window->IsA("vtkEGLRenderWindow") || window->IsA("vtkOSOpenGLRenderWindow");
  return !isUnseen && (!window->IsA("vtkXOpenGLRenderWindow") || DisplayAnswers());
}

//--------------------------------------------------------------------------------------------------
VirtualDisplay::VirtualDisplay()
{
  if (DisplayAnswers() || DrawsWithoutDisplay())
  {
    return;
  }
  int ends[2];
  if (pipe(ends) != 0)
  {
    throw std::runtime_error("cannot start Xvfb: no pipe");
  }
  fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  const pid_t parent = getpid();
  this->Process = fork();
  if (this->Process == 0)
  {
    BecomeServer(ends[1], parent);
  }
  close(ends[1]);
  const std::string number = this->Process > 0 ? ReadNumber(ends[0]) : std::string();
  close(ends[0]);
  if (number.empty())
  {
    if (this->Process > 0)
    {
      EndServer(this->Process);
    }
    throw std::runtime_error(Advice);
  }
  setenv("DISPLAY", (":" + number).c_str(), 1);
}

//--------------------------------------------------------------------------------------------------
VirtualDisplay::~VirtualDisplay()
{
  if (this->Process > 0)
  {
    EndServer(this->Process);
    unsetenv("DISPLAY");
  }
}

}

#else

namespace softshadows
{

bool HasDisplay()
{
  return true;
}

VirtualDisplay::VirtualDisplay() = default;
VirtualDisplay::~VirtualDisplay() = default;

}

#endif
