// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualKernel.h"

#include "vtkMath.h"

#include "vtkVirtualKernelText.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// The integral of exp(-2 x^2) from 0 to x.
double GaussianIntegral(double x)
{
  return std::sqrt(vtkMath::Pi() / 8.0) * std::erf(std::sqrt(2.0) * x);
}

// The integral of sqrt(1 - x^2) from 0 to x.
double ChordIntegral(double x)
{
  const double clamped = std::min(std::max(x, -1.0), 1.0);
  return 0.5 * (clamped * std::sqrt(1.0 - clamped * clamped) + std::asin(clamped));
}
} // namespace

//------------------------------------------------------------------------------
vtkVirtualVariance vtkVirtualKernel::Variance(
  const std::array<double, 2>& u, const std::array<double, 2>& v)
{
  return { { u[0] * u[0] + v[0] * v[0], u[0] * u[1] + v[0] * v[1], u[1] * u[1] + v[1] * v[1] } };
}

//------------------------------------------------------------------------------
vtkVirtualVariance vtkVirtualKernel::Convolve(
  const std::array<double, 2>& lightHalfExtent, bool disk, const vtkVirtualVariance& footprint)
{
  const double share = disk ? 4.0 / 3.0 : 1.0;
  return { { lightHalfExtent[0] * lightHalfExtent[0] + share * footprint[0], share * footprint[1],
    lightHalfExtent[1] * lightHalfExtent[1] + share * footprint[2] } };
}

//------------------------------------------------------------------------------
vtkVirtualKernel vtkVirtualKernel::FromVariance(
  const vtkVirtualVariance& variance, bool disk, const std::array<double, 2>& texelsPerUnit)
{
  double along = variance[0] * texelsPerUnit[0] * texelsPerUnit[0];
  double mixed = variance[1] * texelsPerUnit[0] * texelsPerUnit[1];
  double across = variance[2] * texelsPerUnit[1] * texelsPerUnit[1];
  vtkVirtualKernel kernel;
  kernel.Disk = disk;
  kernel.Transposed = across > along;
  if (kernel.Transposed)
  {
    std::swap(along, across);
  }
  // The last line of the paper's appendix reads sqrt(m11 - u.y u.y).
  kernel.Along = std::max(std::sqrt(along), LeastHalfExtent);
  kernel.Lean = mixed / kernel.Along;
  kernel.Across =
    std::max(std::sqrt(std::max(across - kernel.Lean * kernel.Lean, 0.0)), LeastHalfExtent);
  return kernel;
}

//------------------------------------------------------------------------------
double vtkVirtualKernel::GetWindowArea(
  bool disk, bool gaussian, const std::array<double, 4>& window)
{
  if (!gaussian)
  {
    return disk ? vtkMath::Pi() : 4.0;
  }
  if (disk)
  {
    return 0.5 * vtkMath::Pi() * (1.0 - std::exp(-2.0)); // a disk is never split
  }
  double area = 1.0;
  for (int axis = 0; axis < 2; ++axis)
  {
    area *= (GaussianIntegral(window[axis] + window[axis + 2]) -
              GaussianIntegral(window[axis] - window[axis + 2])) /
      window[axis + 2];
  }
  return area;
}

//------------------------------------------------------------------------------
double vtkVirtualKernel::GetArea() const
{
  return GetWindowArea(this->Disk, this->Gaussian, this->Window) * this->Along * this->Across;
}

//------------------------------------------------------------------------------
vtkVirtualKernel::Strip vtkVirtualKernel::GetStrip(double along, double across, int index) const
{
  const double from = std::max(index - along, -this->Along);
  const double to = std::min(index + 1 - along, this->Along);
  const double width = to - from;
  if (width <= 0.0)
  {
    return { 0.0, 0.0, 0.0, 0.0, 1.0 };
  }
  double half = this->Across;
  if (this->Disk)
  {
    half *=
      (ChordIntegral(to / this->Along) - ChordIntegral(from / this->Along)) * this->Along / width;
  }
  // A leaning strip is a box smeared by its lean: a box of that variance, and of the strip's area.
  const double slope = this->Lean / this->Along;
  const double smeared = std::hypot(half, 0.5 * slope * width);
  const double middle = across + slope * 0.5 * (from + to);
  if (half <= 0.0)
  {
    return { 0.0, 0.0, 0.0, 0.0, 1.0 };
  }
  double weight = width;
  if (this->Gaussian)
  {
    const double center = this->Window[this->Transposed ? 1 : 0];
    const double perTexel = this->Window[this->Transposed ? 3 : 2] / this->Along;
    weight =
      (GaussianIntegral(center + to * perTexel) - GaussianIntegral(center + from * perTexel)) /
      perTexel;
  }
  const double slopeAcross =
    this->Window[this->Transposed ? 2 : 3] * half / (smeared * this->Across);
  return { weight * half / smeared, middle - smeared, middle + smeared, middle, slopeAcross };
}

//------------------------------------------------------------------------------
double vtkVirtualKernel::GetTexelOverlap(const Strip& strip, int index) const
{
  const double from = std::max<double>(strip.Low, index);
  const double to = std::max(std::min<double>(strip.High, index + 1), from);
  if (!this->Gaussian)
  {
    return to - from;
  }
  const double center = this->Window[this->Transposed ? 0 : 1];
  return (GaussianIntegral(center + strip.WindowSlope * (to - strip.Middle)) -
           GaussianIntegral(center + strip.WindowSlope * (from - strip.Middle))) /
    strip.WindowSlope;
}

//------------------------------------------------------------------------------
double vtkVirtualKernel::GetOverlap(double s, double t, int i, int j) const
{
  const Strip strip = this->Transposed ? this->GetStrip(t, s, j) : this->GetStrip(s, t, i);
  const int row = this->Transposed ? i : j;
  return strip.Width * this->GetTexelOverlap(strip, row);
}

//------------------------------------------------------------------------------
std::array<double, 2> vtkVirtualKernel::Filter(
  double s, double t, int width, int height, const std::function<double(int, int)>& lit) const
{
  const double along = this->Transposed ? t : s;
  const double across = this->Transposed ? s : t;
  const int lastStrip = (this->Transposed ? height : width) - 1;
  const int lastTexel = (this->Transposed ? width : height) - 1;
  std::array<double, 2> sums = { { 0.0, 0.0 } };
  const int first = std::max(static_cast<int>(std::floor(along - this->Along)), 0);
  const int last = std::min(static_cast<int>(std::floor(along + this->Along)), lastStrip);
  for (int i = first; i <= last; ++i)
  {
    const Strip strip = this->GetStrip(along, across, i);
    const int low = std::max(static_cast<int>(std::floor(strip.Low)), 0);
    const int high = std::min(static_cast<int>(std::floor(strip.High)), lastTexel);
    for (int j = low; j <= high; ++j)
    {
      const double area = strip.Width * this->GetTexelOverlap(strip, j);
      sums[0] += area * (this->Transposed ? lit(j, i) : lit(i, j));
      sums[1] += area;
    }
  }
  return sums;
}

//------------------------------------------------------------------------------
const char* vtkVirtualKernel::GetShaderText()
{
  return vtkVirtualKernelText;
}
VTK_ABI_NAMESPACE_END
