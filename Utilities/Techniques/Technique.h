// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Techniques and their options by name: one table for the tool, the tests and the benchmark.
 */

#ifndef Technique_h
#define Technique_h

#include "vtkSmartPointer.h"
#include "vtkSoftShadowPass.h"

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace softshadows
{

/// A property of a pass that can be set by name.
struct TechniqueOption
{
  enum class Kind
  {
    Integer,
    Number,
    Flag,  ///< on or off
    Choice ///< one of several names
  };

  std::string Name;
  Kind Is = Kind::Integer;
  std::string Meaning; ///< A line for the user, with units.
  /// What the pass's Set and Get are followed by, and their first argument if there is one.
  std::string Property;
  std::optional<int> Index;
  double Least = 0.0; ///< Of integers and numbers.
  double Most = 0.0;
  std::vector<std::string> Choices; ///< Of flags and choices, in the order of their values.
  ///@{
  /// The value in the pass: a number, or the place among the choices.
  std::function<void(vtkSoftShadowPass*, double)> Set;
  std::function<double(vtkSoftShadowPass*)> Get;
  ///@}

  /// The value that the text means. Throws std::runtime_error that names the option and its range.
  double Parse(const std::string& text) const;

  /// A value as Parse reads it.
  std::string Spell(double value) const;

  /// "1 to 4096", "mean or gaussian"
  std::string SpellRange() const;
};

/// A name and a text for each option to be set.
using OptionTexts = std::vector<std::pair<std::string, std::string>>;

/// Settings that meet an error class, or the reason why the technique has none that do.
struct TechniqueQuality
{
  OptionTexts Options;
  std::string WhyNone;

  bool Exists() const { return this->WhyNone.empty(); }
};

/**
 * A quality is the same class of errors for every technique: the largest root mean square error of
 * the visibility on the bundled scene Testing/Data/Scenes/bunny.json, silhouettes left out.
 */
struct QualityClass
{
  std::string Name;
  double LargestError;
};

struct Technique
{
  std::string Name;
  std::string Meaning; ///< A line for the user.
  /// Where it was published: authors and year. Empty: here, or in any book.
  std::vector<std::string> Papers;
  std::function<vtkSmartPointer<vtkSoftShadowPass>()> Create;
  std::vector<TechniqueOption> Options;
  ///@{
  /// The fastest settings found for each class; Documentation/Choosing.md has the figures they were
  /// chosen by. Good is what a pass has by default, where that meets the class.
  TechniqueQuality Draft;
  TechniqueQuality Good;
  TechniqueQuality Best;
  ///@}

  /// Throws std::runtime_error that names the nearest and lists all.
  const TechniqueOption& FindOption(const std::string& name) const;

  /// Whether the technique has it or not. Throws std::runtime_error that lists all.
  const TechniqueQuality& FindQuality(const std::string& name) const;

  /// The settings of a quality. Throws std::runtime_error that says why there are none.
  const OptionTexts& GetQualityOptions(const std::string& name) const;
};

/// draft, good and best.
const std::vector<QualityClass>& GetQualities();

/// All techniques there are, the simplest first.
const std::vector<Technique>& GetTechniques();

/// Throws std::runtime_error that names the nearest and lists all.
const Technique& FindTechnique(const std::string& name);

/// Cuts NAME=VALUE. Throws std::runtime_error for texts of another form.
std::pair<std::string, std::string> SplitOption(const std::string& text);

/**
 * A pass of the technique with options set, those not named as the pass has them by default. Throws
 * std::runtime_error for unknown options and values out of range, which no pass ever sees.
 */
vtkSmartPointer<vtkSoftShadowPass> CreatePass(
  const Technique& technique, const OptionTexts& options);

/// "samples=16 map_size=512", and "the defaults" where there are none.
std::string SpellOptions(const OptionTexts& options);

/// One line per technique that starts with its name, its options and qualities below, indented.
void PrintTechniques(std::ostream& os);

/**
 * The same and more as one JSON object, for programs. "techniques" is a list of name, class, meaning,
 * papers, options and qualities; an option has name, property (of the class; with an index, its first
 * argument), kind (integer, number, flag, choice), default, meaning, and least and most or choices.
 * "qualities" are names and largest errors.
 */
void PrintTechniquesAsJson(std::ostream& os);

}

#endif
