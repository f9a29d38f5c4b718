// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowFailures.h"

#include "vtkObject.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
thread_local vtkShadowFailures* Newest = nullptr;
}

//------------------------------------------------------------------------------
vtkShadowFailures::vtkShadowFailures()
  : Outer(Newest)
{
  Newest = this;
}

//------------------------------------------------------------------------------
vtkShadowFailures::~vtkShadowFailures()
{
  Newest = this->Outer;
}

//------------------------------------------------------------------------------
void vtkShadowFailures::Report(const std::string& reason)
{
  if (!Newest)
  {
    vtkGenericWarningMacro(<< "Soft shadows: " << reason << ".");
  }
  else if (Newest->First.empty())
  {
    Newest->First = reason;
  }
}

//------------------------------------------------------------------------------
bool vtkShadowFailures::IsFailing()
{
  return Newest && Newest->HasAny();
}
VTK_ABI_NAMESPACE_END
