// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PaperTables.h"

#include <sstream>   // For option texts
#include <stdexcept> // For unknown names
#include <utility>   // For pairs

namespace softshadows
{
namespace
{

using Maker = std::vector<PaperTable> (*)();
constexpr std::pair<const char*, Maker> Papers[] = { { "cascaded", GetCascadedTables },
  { "estimators", GetEstimatorTables }, { "pcss", GetPcssTables }, { "pvssm", GetPvssmTables },
  { "sbfs", GetSbfsTables }, { "sssm", GetSssmTables } };

}

//--------------------------------------------------------------------------------------------------
bool IsComparedByDifference(PaperFigure figure)
{
  switch (figure)
  {
    case PaperFigure::Psnr:
    case PaperFigure::SsimPercent:
    case PaperFigure::PicturePsnr:
    case PaperFigure::PictureSsimPercent:
      return true;
    default:
      return false;
  }
}

//--------------------------------------------------------------------------------------------------
const std::vector<std::string>& GetPapers()
{
  static const std::vector<std::string> names = []
  {
    std::vector<std::string> all;
    for (const auto& paper : Papers)
    {
      all.emplace_back(paper.first);
    }
    return all;
  }();
  return names;
}

//--------------------------------------------------------------------------------------------------
std::vector<PaperTable> GetPaperTables(const std::string& paper)
{
  std::string message = "no paper " + paper + "; there are";
  for (const auto& known : Papers)
  {
    if (paper == known.first)
    {
      return known.second();
    }
    message += std::string(" ") + known.first;
  }
  throw std::runtime_error(message);
}

//--------------------------------------------------------------------------------------------------
ContestantChoice ParseChoice(const std::string& text)
{
  std::istringstream words(text);
  ContestantChoice choice;
  words >> choice.Technique;
  std::string word;
  while (words >> word)
  {
    const size_t equals = word.find('=');
    if (equals == std::string::npos || equals == 0)
    {
      throw std::runtime_error("option '" + word + "' is not of the form NAME=VALUE");
    }
    choice.Options[word.substr(0, equals)] = word.substr(equals + 1);
  }
  return choice;
}

}
