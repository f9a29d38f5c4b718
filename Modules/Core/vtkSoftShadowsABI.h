// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkSoftShadowsABI.h
 * @brief VTK's ABI-namespace macros for every supported VTK.
 *
 * VTK from 9.2 on may wrap its classes in a versioned inline namespace. The headers of this project
 * put their forward declarations and classes between VTK_ABI_NAMESPACE_BEGIN and
 * VTK_ABI_NAMESPACE_END; with a VTK that has no such namespace both expand to nothing.
 */

#ifndef vtkSoftShadowsABI_h
#define vtkSoftShadowsABI_h

#if defined(__has_include)
#if __has_include("vtkABINamespace.h")
#include "vtkABINamespace.h"
#endif
#endif

#ifndef VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

#endif
// VTK-HeaderTest-Exclude: vtkSoftShadowsABI.h
