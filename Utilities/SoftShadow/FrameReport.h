// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The report of softshadow render.
 */

#ifndef FrameReport_h
#define FrameReport_h

#include "SceneFrame.h"
#include "Technique.h"

#include <string>
#include <vector>

namespace softshadows
{

/**
 * JSON: inputs, technique, all its options, image size, the time of the whole frame and of each
 * step in milliseconds, all counts of the pass, what it says of each light, and the OpenGL driver.
 */
std::string ReportFrame(
  const std::vector<std::string>& inputs, const Technique& technique, const SceneFrame& frame);

}

#endif
