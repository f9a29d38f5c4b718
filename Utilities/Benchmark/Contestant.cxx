// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Contestant.h"

#include "HardShadowContestant.h"
#include "ReferenceTracer.h"
#include "SceneChanges.h"
#include "SupersampledContestant.h"

#include "vtkSoftShadowPass.h"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <charconv>     // For numbers
#include <cmath>        // For roots
#include <stdexcept>    // For errors
#include <string>       // For their text
#include <system_error> // For errc

namespace softshadows
{
namespace
{

//--------------------------------------------------------------------------------------------------
// Whether all of the text is a number.
template <typename Number>
bool ReadNumber(const std::string& text, Number& number)
{
  const char* const end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, number);
  return parsed.ec == std::errc() && parsed.ptr == end;
}

//--------------------------------------------------------------------------------------------------
int GetNumber(const ContestantChoice& choice, const std::string& option, int whenAbsent)
{
  const auto found = choice.Options.find(option);
  if (found == choice.Options.end())
  {
    return whenAbsent;
  }
  int number = 0;
  if (!ReadNumber(found->second, number) || number < 1)
  {
    throw std::invalid_argument(
      choice.Technique + ": " + option + " must be a whole number above 0");
  }
  return number;
}

//--------------------------------------------------------------------------------------------------
// Every frame builds its hierarchy anew and traces all rays: the price of a scene that moves.
class RayContestant : public Contestant
{
public:
  RayContestant(const SceneFactory& makeScene, int width, int height, int samples)
    : Renderer(makeScene())
    , Tracer(width, height, static_cast<int>(std::lround(std::sqrt(samples))))
  {
  }

  void Draw(Motion, int) override { this->Last = this->Tracer.Trace(this->Renderer); }
  std::vector<std::vector<float>> GetVisibility() override { return this->Last.Visibility; }
  bool Notices(Motion motion) const override { return motion == Motion::Light; }

  std::vector<std::pair<std::string, std::int64_t>> GetCounts() override
  {
    return { { "shadow_rays", this->Last.ShadowRays } };
  }

private:
  vtkSmartPointer<vtkRenderer> Renderer;
  ReferenceTracer Tracer;
  ReferenceVisibility Last;
};

}

//--------------------------------------------------------------------------------------------------
std::string ContestantChoice::GetName() const
{
  std::string name = this->Technique;
  for (const auto& option : this->Options)
  {
    name += ' ' + option.first + '=' + option.second;
  }
  return name;
}

//--------------------------------------------------------------------------------------------------
bool ContestantChoice::HasHardShadows() const
{
  const auto samples = this->Options.find("samples");
  const bool isOneSample = samples != this->Options.end() && samples->second == "1";
  return this->Technique == "vtk" || (this->Technique == "sampled" && isOneSample);
}

//--------------------------------------------------------------------------------------------------
std::unique_ptr<Contestant> MakeContestant(const ContestantChoice& choice,
  const SceneFactory& makeScene, int width, int height, const TechniqueFactory& makeTechnique)
{
  if (choice.Options.count("light_scale") == 1)
  {
    ContestantChoice rest = choice;
    rest.Options.erase("light_scale");
    double scale = 0.0;
    if (!ReadNumber(choice.Options.at("light_scale"), scale) || !(scale > 0.0) || std::isinf(scale))
    {
      throw std::invalid_argument(choice.Technique + ": light_scale must be a number above 0");
    }
    const SceneFactory makeScaled = [makeScene, scale]
    {
      vtkSmartPointer<vtkRenderer> renderer = makeScene();
      ScaleLights(renderer, scale);
      return renderer;
    };
    return MakeContestant(rest, makeScaled, width, height, makeTechnique);
  }
  if (choice.Technique == "plain")
  {
    return std::make_unique<WindowContestant>(makeScene, width, height);
  }
  if (choice.Technique == "vtk")
  {
    return std::make_unique<HardShadowContestant>(
      makeScene, width, height, GetNumber(choice, "map_size", 1024));
  }
  if (choice.Technique == "rays")
  {
    return std::make_unique<RayContestant>(
      makeScene, width, height, GetNumber(choice, "samples", 16));
  }
  TechniqueOptions options = choice.Options;
  if (options.erase("supersample") == 1)
  {
    return std::make_unique<SupersampledContestant>(makeScene, width, height,
      GetNumber(choice, "supersample", 1), makeTechnique(choice.Technique, options));
  }
  return std::make_unique<TechniqueContestant>(
    makeScene, width, height, makeTechnique(choice.Technique, options));
}

}
