// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GltfMessages.h"

#include <stdexcept> // For errors

namespace softshadows
{

//--------------------------------------------------------------------------------------------------
std::string NameOfElement(const std::string& list, std::int64_t index)
{
  return list + "[" + std::to_string(index) + "]";
}

//--------------------------------------------------------------------------------------------------
void ThrowDamaged(const std::string& message)
{
  throw std::runtime_error("damaged: " + message);
}

}
