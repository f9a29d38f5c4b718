// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReferenceVector.h
 * @brief Three doubles and what the ray tracer does with them.
 */

#ifndef SoftShadowsRayTracing_ReferenceVector_h
#define SoftShadowsRayTracing_ReferenceVector_h

#include <array> // For Vector
#include <cmath> // For Length

namespace softshadows
{

using Vector = std::array<double, 3>;

inline Vector operator+(const Vector& a, const Vector& b)
{
  return { { a[0] + b[0], a[1] + b[1], a[2] + b[2] } };
}

inline Vector operator-(const Vector& a, const Vector& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

inline Vector operator*(double s, const Vector& a)
{
  return { { s * a[0], s * a[1], s * a[2] } };
}

inline double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector Cross(const Vector& a, const Vector& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}

inline double Length(const Vector& a)
{
  return std::sqrt(Dot(a, a));
}

/// The null vector stays the null vector.
inline Vector Normalized(const Vector& a)
{
  const double length = Length(a);
  return length > 0.0 ? (1.0 / length) * a : a;
}

}

#endif
