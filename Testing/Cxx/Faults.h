// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Faults.h
 * @brief A driver without memory, and what VTK says about it.
 */

#ifndef SoftShadowsTesting_Faults_h
#define SoftShadowsTesting_Faults_h

#include "vtkNew.h"                // For members
#include "vtkOutputWindow.h"       // For members
#include "vtkSmartPointer.h"       // For members
#include "vtkStringOutputWindow.h" // For members

#include <string> // For messages

namespace SoftShadowsTesting
{

/// Everything that VTK prints while one lives.
class Messages
{
public:
  Messages();
  ~Messages();
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  std::string Get() { return this->Window->GetOutput(); }

  /// How often a text occurs in it.
  int Count(const std::string& text);

private:
  vtkNew<vtkStringOutputWindow> Window;
  vtkSmartPointer<vtkOutputWindow> Before;
};

/**
 * While one lives, the which-th of the calls by which passes get memory fails, counted from 1: textures
 * (a call per level), depth renderbuffers, stores of buffers, and framebuffers that are asked whether
 * they are complete. The driver is asked for what it cannot have and says so itself.
 */
class Faults
{
public:
  explicit Faults(int which);
  ~Faults();
  Faults(const Faults&) = delete;
  Faults& operator=(const Faults&) = delete;

  /// Whether there were so many calls.
  bool HasFailed() const;
};

}

#endif
