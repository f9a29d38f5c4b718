// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Suggestion.h"

#include <algorithm>
#include <cstddef>

namespace softshadows
{
namespace
{

/// Insertions, deletions, replacements and swaps of neighbours from one word to the other.
std::size_t EditDistance(const std::string& from, const std::string& to)
{
  const std::size_t width = to.size() + 1;
  std::vector<std::size_t> table((from.size() + 1) * width);
  for (std::size_t i = 0; i <= from.size(); ++i)
  {
    for (std::size_t j = 0; j <= to.size(); ++j)
    {
      std::size_t& cell = table[i * width + j];
      if (i == 0 || j == 0)
      {
        cell = i + j;
        continue;
      }
      const std::size_t* left = &cell - 1;
      const std::size_t* above = &cell - width;
      cell = std::min({ *left + 1, *above + 1, above[-1] + (from[i - 1] == to[j - 1] ? 0 : 1) });
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
      {
        cell = std::min(cell, table[(i - 2) * width + j - 2] + 1);
      }
    }
  }
  return table.back();
}

}

//--------------------------------------------------------------------------------------------------
std::string NearestWord(const std::string& word, const std::vector<std::string>& known)
{
  constexpr std::size_t longestWord = 64; // longer ones are no slips of the finger
  if (word.size() > longestWord)
  {
    return {};
  }
  std::string nearest;
  std::size_t least = 1 + std::max<std::size_t>(1, word.size() / 3);
  for (const std::string& candidate : known)
  {
    const std::size_t distance = EditDistance(word, candidate);
    if (distance < least)
    {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

//--------------------------------------------------------------------------------------------------
std::string DidYouMean(const std::string& word, const std::vector<std::string>& known)
{
  const std::string nearest = NearestWord(word, known);
  std::string text = nearest.empty() ? "" : "did you mean '" + nearest + "'? ";
  text += "Known are:";
  for (std::size_t i = 0; i < known.size(); ++i)
  {
    text += (i == 0 ? " " : ", ") + known[i];
  }
  return text;
}

}
