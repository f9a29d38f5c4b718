// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GltfMessages.h
 * @brief What errors of a glTF file say.
 */

#ifndef SoftShadowsScene_GltfMessages_h
#define SoftShadowsScene_GltfMessages_h

#include <cstdint> // For numbers of elements
#include <string>  // For texts

namespace softshadows
{

/// "meshes[3]"
std::string NameOfElement(const std::string& list, std::int64_t index);

/// Throws std::runtime_error: the file is damaged in the way that the message says.
[[noreturn]] void ThrowDamaged(const std::string& message);

}

#endif
