// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkTracedVector.h
 * @brief   Vectors and affine maps in double precision. For sources only.
 */

#ifndef vtkTracedVector_h
#define vtkTracedVector_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <array> // For members
#include <cmath> // For lengths

VTK_ABI_NAMESPACE_BEGIN

using vtkTracedVector = std::array<double, 3>;

inline vtkTracedVector operator+(const vtkTracedVector& a, const vtkTracedVector& b)
{
  return { { a[0] + b[0], a[1] + b[1], a[2] + b[2] } };
}

inline vtkTracedVector operator-(const vtkTracedVector& a, const vtkTracedVector& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

inline vtkTracedVector operator*(double s, const vtkTracedVector& a)
{
  return { { s * a[0], s * a[1], s * a[2] } };
}

namespace vtkTraced
{
inline double Dot(const vtkTracedVector& a, const vtkTracedVector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline vtkTracedVector Cross(const vtkTracedVector& a, const vtkTracedVector& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}

inline double Length(const vtkTracedVector& a)
{
  return std::sqrt(Dot(a, a));
}
}

/// p -> Columns p + Offset
struct vtkTracedMap
{
  std::array<vtkTracedVector, 3> Columns = { { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } },
    { { 0.0, 0.0, 1.0 } } } };
  vtkTracedVector Offset{};

  vtkTracedVector Turn(const vtkTracedVector& p) const
  {
    return p[0] * this->Columns[0] + p[1] * this->Columns[1] + p[2] * this->Columns[2];
  }
  vtkTracedVector operator()(const vtkTracedVector& p) const
  {
    return this->Turn(p) + this->Offset;
  }
};

namespace vtkTraced
{
/// Of a row-major affine matrix.
inline vtkTracedMap MapOf(const std::array<double, 16>& m)
{
  vtkTracedMap map;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      map.Columns[column][row] = m[4 * row + column];
    }
    map.Offset[row] = m[4 * row + 3];
  }
  return map;
}
}

VTK_ABI_NAMESPACE_END
#endif
