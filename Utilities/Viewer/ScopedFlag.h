// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A flag that is set as long as something is under way, however it ends.
 */

#ifndef ScopedFlag_h
#define ScopedFlag_h

namespace softshadows
{

class ScopedFlag
{
public:
  explicit ScopedFlag(bool& flag)
    : Flag(flag)
  {
    this->Flag = true;
  }
  ~ScopedFlag() { this->Flag = false; }
  ScopedFlag(const ScopedFlag&) = delete;
  ScopedFlag& operator=(const ScopedFlag&) = delete;

private:
  bool& Flag;
};

}

#endif
