// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowDrawTest.h"

#include "vtkShadowSides.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
// The four sides, and the far plane, behind which nothing is written. In front of the near plane there
// is none: what is there is clamped to it.
vtkShadowDrawTest::vtkShadowDrawTest(const vtkShadowMapView& view)
  : View(view)
{
  const auto toClip = view.WorldToClip(true);
  for (int i = 0; i < 4; ++i)
  {
    const double w = toClip[12 + i];
    this->Planes[0][i] = w + toClip[i];
    this->Planes[1][i] = w - toClip[i];
    this->Planes[2][i] = w + toClip[4 + i];
    this->Planes[3][i] = w - toClip[4 + i];
    this->Planes[4][i] = toClip[8 + i];
  }
}

//------------------------------------------------------------------------------
int vtkShadowDrawTest::GetSide(const vtkShadowCasterEntry& entry) const
{
  if (!entry.HasBody || !entry.Body.Casts || !this->IsInView(entry.Body.Bounds) ||
    !this->IsEffective(entry))
  {
    return vtkShadowCasterEntry::NO_SIDE;
  }
  // From inside a closed surface its other side is seen, and maybe from inside its box.
  return this->IsInside(entry.Body.Bounds) ? 0 : entry.GetFacing();
}

//------------------------------------------------------------------------------
bool vtkShadowDrawTest::IsInView(const std::array<double, 6>& box) const
{
  for (const auto& plane : this->Planes)
  {
    double farthest = plane[3];
    for (int i = 0; i < 3; ++i)
    {
      farthest += std::max(plane[i] * box[2 * i], plane[i] * box[2 * i + 1]);
    }
    if (farthest < 0.0)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowDrawTest::IsEffective(const vtkShadowCasterEntry& entry) const
{
  if (entry.HasReceivers[0] && entry.HasReceivers[1])
  {
    return true;
  }
  const int side = vtkShadowSides::OfEmitter(entry.Body, this->View.Emitter);
  return side == 0 ? entry.HasReceivers[0] || entry.HasReceivers[1]
                   : entry.HasReceivers[side > 0 ? 0 : 1];
}

//------------------------------------------------------------------------------
bool vtkShadowDrawTest::IsInside(const std::array<double, 6>& box) const
{
  const auto& eye = this->View.Emitter.Center;
  return !this->View.Emitter.Directional && eye[0] >= box[0] && eye[0] <= box[1] &&
    eye[1] >= box[2] && eye[1] <= box[3] && eye[2] >= box[4] && eye[2] <= box[5];
}

VTK_ABI_NAMESPACE_END
