// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A display for VTK's windows where there is none.
 */

#ifndef VirtualDisplay_h
#define VirtualDisplay_h

namespace softshadows
{

/**
 * Whether VTK's windows can be seen. DISPLAY is asked once, over a connection that stays open until the
 * program ends, so that this was not the server's last.
 */
bool HasDisplay();

/**
 * VTK's windows of the X Window System need a display even when they draw off-screen, and end the
 * program if there is none. Where VTK makes such windows and DISPLAY names no server that answers,
 * this starts an Xvfb of its own and points DISPLAY to it; it is ended with this object, or with the
 * program, however that ends. Elsewhere it does nothing. Windows must be gone before this is.
 */
class VirtualDisplay
{
public:
  /// Throws std::runtime_error that says what to install if there is neither a display nor Xvfb.
  VirtualDisplay();
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

private:
  int Process = 0; ///< 0: none of our own.
};

}

#endif
