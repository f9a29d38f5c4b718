// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MachineContext.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkVersion.h>
#include <vtksys/SystemInformation.hxx>

#include <ctime>   // For the date
#include <fstream> // For the processor
#include <sstream> // For lines
#include <thread>  // For the number of processors

namespace softshadows
{
namespace
{

//--------------------------------------------------------------------------------------------------
std::string DescribeOpenGL()
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(16, 16);
  window->Render();
  std::istringstream lines(window->ReportCapabilities());
  const std::string wanted = "OpenGL renderer string:";
  std::string line;
  while (std::getline(lines, line))
  {
    if (line.rfind(wanted, 0) == 0)
    {
      const size_t start = line.find_first_not_of(' ', wanted.size());
      return start == std::string::npos ? "" : line.substr(start);
    }
  }
  return "";
}

//--------------------------------------------------------------------------------------------------
// Linux knows processors by name that the library does not.
std::string DescribeProcessor(vtksys::SystemInformation& system)
{
  std::ifstream file("/proc/cpuinfo");
  std::string line;
  while (std::getline(file, line))
  {
    const size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos)
    {
      return line.substr(colon + 2);
    }
  }
  return system.GetExtendedProcessorName();
}

//--------------------------------------------------------------------------------------------------
std::string Now()
{
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  return text;
}

}

//--------------------------------------------------------------------------------------------------
BenchmarkContext DescribeMachine(const std::string& version)
{
  vtksys::SystemInformation system;
  system.RunCPUCheck();
  system.RunOSCheck();
  BenchmarkContext context;
  context.Date = Now();
  context.Host = system.GetHostname();
  context.Processor = DescribeProcessor(system);
  context.Processors = static_cast<int>(std::thread::hardware_concurrency());
  context.Renderer = DescribeOpenGL();
  context.VtkVersion = vtkVersion::GetVTKVersion();
  context.Version = version;
  return context;
}

}
