// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Visibilities as colours, for the viewer's views.
 */

#ifndef VisibilityPicture_h
#define VisibilityPicture_h

#include <vector>

namespace softshadows
{

/// RGB bytes in the order of the values: black at 0, white at 1, blue-grey for NaN.
std::vector<unsigned char> DrawGrey(const std::vector<float>& values);

/**
 * RGB bytes in the order of the values: white for lit (0.98 and above), black for umbra (0.02 and
 * below), between them ten colours from dark blue to yellow, one for every tenth; blue-grey for NaN.
 */
std::vector<unsigned char> DrawPenumbra(const std::vector<float>& visibility);

}

#endif
