// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorReport.h"

#include <cmath>   // For std::isfinite
#include <iomanip> // For columns
#include <ostream> // For the terminal

namespace softshadows
{
namespace
{

using Json = nlohmann::ordered_json;

struct NamedMeasure
{
  const char* Name;
  double ErrorMeasures::*Value;
};

constexpr NamedMeasure Measures[] = { { "rmse", &ErrorMeasures::Rmse },
  { "mean", &ErrorMeasures::Mean }, { "bias", &ErrorMeasures::Bias },
  { "maximum", &ErrorMeasures::Maximum }, { "percentile99", &ErrorMeasures::Percentile99 },
  { "psnr", &ErrorMeasures::Psnr }, { "ssim", &ErrorMeasures::Ssim } };

//--------------------------------------------------------------------------------------------------
Json ToJson(const ErrorMeasures& measures)
{
  Json json;
  json["pixels"] = measures.Pixels;
  for (const NamedMeasure& measure : Measures)
  {
    const double value = measures.*measure.Value;
    json[measure.Name] = std::isfinite(value) ? Json(value) : Json();
  }
  return json;
}

}

//--------------------------------------------------------------------------------------------------
Json ToJson(const VisibilityErrors& errors)
{
  Json json;
  json["all"] = ToJson(errors.All);
  json["penumbra"] = ToJson(errors.Penumbra);
  json["light_leaks"] = errors.LightLeaks;
  json["false_shadows"] = errors.FalseShadows;
  json["worst_tile"] = errors.WorstTile;
  json["worst_tile_with_left_out"] = errors.WorstTileWithLeftOut;
  json["left_out"] = errors.LeftOut;
  json["only_in_reference"] = errors.OnlyInTruth;
  json["only_in_candidate"] = errors.OnlyInEstimate;
  return json;
}

//--------------------------------------------------------------------------------------------------
void PrintErrors(std::ostream& os, const VisibilityErrors& errors)
{
  const auto name = [&os](const char* text) -> std::ostream&
  { return os << "  " << std::left << std::setw(20) << text << std::right; };
  name("") << std::setw(12) << "all" << std::setw(12) << "penumbra" << '\n';
  name("pixels") << std::setw(12) << errors.All.Pixels << std::setw(12) << errors.Penumbra.Pixels
                 << '\n';
  for (const NamedMeasure& measure : Measures)
  {
    name(measure.Name) << std::setprecision(4) << std::setw(12) << errors.All.*measure.Value
                       << std::setw(12) << errors.Penumbra.*measure.Value << '\n';
  }
  name("light leaks") << std::setw(12) << errors.LightLeaks << '\n';
  name("false shadows") << std::setw(12) << errors.FalseShadows << '\n';
  name("worst tile") << std::setw(12) << errors.WorstTile << "  (with silhouettes "
                     << errors.WorstTileWithLeftOut << ")\n";
  name("left out") << std::setw(12) << errors.LeftOut << "  (silhouettes)\n";
  name("only in reference") << std::setw(12) << errors.OnlyInTruth << '\n';
  name("only in candidate") << std::setw(12) << errors.OnlyInEstimate << '\n';
}

}
