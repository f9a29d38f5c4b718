// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowSides.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr double BEHIND_TOLERANCE = 1e-5;
}

//------------------------------------------------------------------------------
int vtkShadowSides::OfEmitter(const Body& plane, const vtkShadowEmitter& emitter)
{
  const double along = vtkMath::Dot(plane.Normal.data(), emitter.Direction.data());
  const double spread =
    std::abs(vtkMath::Dot(plane.Normal.data(), emitter.AxisU.data())) * emitter.HalfSize[0] +
    std::abs(vtkMath::Dot(plane.Normal.data(), emitter.AxisV.data())) * emitter.HalfSize[1];
  const double distance = emitter.Directional
    ? -along
    : vtkMath::Dot(plane.Normal.data(), emitter.Center.data()) - plane.Offset;
  return distance >= spread ? 1 : (distance <= -spread ? -1 : 0);
}

//------------------------------------------------------------------------------
bool vtkShadowSides::ReachesBehind(const Body& plane, int side, const Body& body)
{
  if (side == 0)
  {
    return true;
  }
  double size = 0.0;
  double deepest = std::numeric_limits<double>::infinity();
  if (body.Flat)
  {
    size =
      std::sqrt(vtkMath::Distance2BetweenPoints(body.Corners[0].data(), body.Corners[2].data()));
    for (const auto& corner : body.Corners)
    {
      deepest =
        std::min(deepest, side * (vtkMath::Dot(plane.Normal.data(), corner.data()) - plane.Offset));
    }
  }
  else
  {
    deepest = -side * plane.Offset;
    for (int i = 0; i < 3; ++i)
    {
      const double low = body.Bounds[2 * i];
      const double high = body.Bounds[2 * i + 1];
      const double slope = side * plane.Normal[i];
      deepest += std::min(slope * low, slope * high);
      size += (high - low) * (high - low);
    }
    size = std::sqrt(size);
  }
  return deepest < -BEHIND_TOLERANCE * size;
}

VTK_ABI_NAMESPACE_END
