// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCasterOrientation.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr double LEAST_VOLUME = 1e-7; // of the cube over the extent

// Finaliser of SplitMix64.
std::uint64_t Scramble(std::uint64_t value)
{
  value += 0x9e3779b97f4a7c15ULL;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
  return value ^ (value >> 31);
}

std::uint64_t Hash(const double* p)
{
  std::uint64_t hash = 0;
  for (int i = 0; i < 3; ++i)
  {
    const double coordinate = p[i] + 0.0; // -0 is 0
    std::uint64_t bits;
    std::memcpy(&bits, &coordinate, sizeof(bits));
    hash = Scramble(hash ^ bits);
  }
  return hash;
}

// The number of the first vertex with the same coordinates, for every vertex.
std::vector<std::uint32_t> Weld(const std::vector<double>& points)
{
  const std::size_t count = points.size() / 3;
  constexpr std::uint32_t empty = std::numeric_limits<std::uint32_t>::max();
  std::size_t size = 16;
  while (size < 2 * count)
  {
    size *= 2;
  }
  std::vector<std::uint32_t> table(size, empty);
  std::vector<std::uint32_t> first(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double* p = points.data() + 3 * i;
    std::size_t slot = Hash(p) & (size - 1);
    while (table[slot] != empty && !std::equal(p, p + 3, points.data() + 3 * table[slot]))
    {
      slot = (slot + 1) & (size - 1);
    }
    if (table[slot] == empty)
    {
      table[slot] = static_cast<std::uint32_t>(i);
    }
    first[i] = table[slot];
  }
  return first;
}

// Closed if every edge is passed as often one way as the other. The sum of a random value for each
// way is then zero, and else it is not but for one chance in 2^64.
bool IsClosed(const std::vector<std::uint32_t>& vertices, const std::vector<std::uint32_t>& indices)
{
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < indices.size(); ++i)
  {
    const std::uint64_t a = vertices[indices[i]];
    const std::uint64_t b = vertices[indices[i % 3 == 2 ? i - 2 : i + 1]];
    sum += Scramble(a << 32 | b) - Scramble(b << 32 | a);
  }
  return sum == 0;
}

std::uint32_t FindRoot(std::vector<std::uint32_t>& parents, std::uint32_t i)
{
  while (parents[i] != i)
  {
    parents[i] = parents[parents[i]];
    i = parents[i];
  }
  return i;
}

// The root of the connected part for every vertex.
std::vector<std::uint32_t> FindParts(
  const std::vector<std::uint32_t>& vertices, const std::vector<std::uint32_t>& indices)
{
  std::vector<std::uint32_t> parents(vertices.size());
  std::iota(parents.begin(), parents.end(), 0u);
  for (std::size_t i = 0; i < indices.size(); i += 3)
  {
    const std::uint32_t a = FindRoot(parents, vertices[indices[i]]);
    parents[FindRoot(parents, vertices[indices[i + 1]])] = a;
    parents[FindRoot(parents, vertices[indices[i + 2]])] = a;
  }
  return parents;
}
}

//------------------------------------------------------------------------------
int vtkShadowCasterOrientation::Find(
  const std::vector<double>& points, const std::vector<std::uint32_t>& indices)
{
  if (indices.size() < 12)
  {
    return 0; // nothing is closed with fewer than four triangles
  }
  const std::vector<std::uint32_t> vertices = Weld(points);
  if (!IsClosed(vertices, indices))
  {
    return 0;
  }
  std::vector<std::uint32_t> parents = FindParts(vertices, indices);
  std::vector<double> volumes(vertices.size(), 0.0);
  double extent = 0.0;
  for (std::size_t i = 0; i < indices.size(); i += 3)
  {
    double p[3][3];
    for (int corner = 0; corner < 3; ++corner)
    {
      for (int k = 0; k < 3; ++k)
      {
        // Relative to some point of the surface: far from the origin a volume would drown.
        p[corner][k] = points[3 * indices[i + corner] + k] - points[3 * indices[0] + k];
        extent = std::max(extent, std::abs(p[corner][k]));
      }
    }
    volumes[FindRoot(parents, vertices[indices[i]])] +=
      p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
      p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
      p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
  }
  const double least = LEAST_VOLUME * extent * extent * extent;
  int orientation = 0;
  for (const std::uint32_t index : indices)
  {
    const double volume = volumes[FindRoot(parents, vertices[index])];
    const int turn = volume > least ? 1 : (volume < -least ? -1 : 0);
    if (turn == 0 || (orientation != 0 && turn != orientation))
    {
      return 0;
    }
    orientation = turn;
  }
  return orientation;
}

VTK_ABI_NAMESPACE_END
