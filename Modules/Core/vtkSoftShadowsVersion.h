// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkSoftShadowsVersion.h
 * @brief The version of SoftShadows, for the preprocessor; CMake reads it from here.
 */

#ifndef vtkSoftShadowsVersion_h
#define vtkSoftShadowsVersion_h

#define SOFTSHADOWS_VERSION "0.1.0"
#define SOFTSHADOWS_VERSION_MAJOR 0
#define SOFTSHADOWS_VERSION_MINOR 1
#define SOFTSHADOWS_VERSION_PATCH 0

/// True where the headers are of the given version or a later one.
#define SOFTSHADOWS_VERSION_AT_LEAST(major, minor, patch)                                          \
  (SOFTSHADOWS_VERSION_MAJOR > (major) ||                                                          \
    (SOFTSHADOWS_VERSION_MAJOR == (major) &&                                                       \
      (SOFTSHADOWS_VERSION_MINOR > (minor) ||                                                      \
        (SOFTSHADOWS_VERSION_MINOR == (minor) && SOFTSHADOWS_VERSION_PATCH >= (patch)))))

#endif
// VTK-HeaderTest-Exclude: vtkSoftShadowsVersion.h
