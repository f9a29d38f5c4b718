// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * For the files that describe a technique: options made from a pass's own setters, getters and
 * limits, so that neither ranges nor defaults are written twice.
 */

#ifndef TechniqueOptions_h
#define TechniqueOptions_h

#include "Technique.h"

#include <string>
#include <type_traits>
#include <vector>

namespace softshadows
{

/// Appends the options of every technique, properties of vtkSoftShadowPass.
void AddCommonOptions(Technique& technique, vtkSoftShadowPass* pass);

/// Appends, behind the technique's own, those that change pictures and not the visibility.
void AddPictureOptions(Technique& technique, vtkSoftShadowPass* pass);

/// A technique with the common options, its passes of the example's class.
template <typename Pass>
Technique MakeTechnique(const std::string& name, const std::string& meaning, Pass* example)
{
  Technique technique;
  technique.Name = name;
  technique.Meaning = meaning;
  technique.Create = []
  { return vtkSmartPointer<vtkSoftShadowPass>(vtkSmartPointer<Pass>::New()); };
  AddCommonOptions(technique, example);
  return technique;
}

/// An option that sets and gets through functions of the pass's own class.
template <typename Pass, typename Setter, typename Getter>
TechniqueOption MakeOption(TechniqueOption::Kind kind, const std::string& property,
  const std::string& name, const std::string& meaning, const Setter& set, const Getter& get)
{
  TechniqueOption option;
  option.Is = kind;
  option.Name = name;
  option.Meaning = meaning;
  option.Property = property;
  option.Set = [set](vtkSoftShadowPass* pass, double value)
  { set(static_cast<Pass*>(pass), value); };
  option.Get = [get](vtkSoftShadowPass* pass) { return get(static_cast<Pass*>(pass)); };
  if (kind == TechniqueOption::Kind::Flag)
  {
    option.Choices = { "off", "on" };
  }
  return option;
}

inline TechniqueOption WithRange(TechniqueOption option, double least, double most)
{
  option.Least = least;
  option.Most = most;
  return option;
}

/// Of a property whose Set and Get have a first argument.
inline TechniqueOption WithIndex(TechniqueOption option, int index)
{
  option.Index = index;
  return option;
}

inline TechniqueOption WithChoices(TechniqueOption option, const std::vector<std::string>& choices)
{
  option.Choices = choices;
  return option;
}

}

/// Property: what Set and Get are followed by.
#define SOFTSHADOWS_OPTION(kind, pass, Property, name, meaning)                                    \
  softshadows::MakeOption<std::remove_pointer_t<decltype(pass)>>(                                  \
    softshadows::TechniqueOption::Kind::kind, #Property, name, meaning,                            \
    [](decltype(pass) target, double value)                                                        \
    { target->Set##Property(static_cast<decltype(target->Get##Property())>(value)); },             \
    [](decltype(pass) target) { return static_cast<double>(target->Get##Property()); })

/// Properties of vtkSetClampMacro, whose limits are the option's.
#define SOFTSHADOWS_INTEGER_OPTION(pass, Property, name, meaning)                                  \
  softshadows::WithRange(SOFTSHADOWS_OPTION(Integer, pass, Property, name, meaning),               \
    pass->Get##Property##MinValue(), pass->Get##Property##MaxValue())
#define SOFTSHADOWS_NUMBER_OPTION(pass, Property, name, meaning)                                   \
  softshadows::WithRange(SOFTSHADOWS_OPTION(Number, pass, Property, name, meaning),                \
    pass->Get##Property##MinValue(), pass->Get##Property##MaxValue())

/// Properties of type bool: on or off.
#define SOFTSHADOWS_FLAG_OPTION(pass, Property, name, meaning)                                     \
  SOFTSHADOWS_OPTION(Flag, pass, Property, name, meaning)

/// Enumerations that start at 0, and the names of their values.
#define SOFTSHADOWS_CHOICE_OPTION(pass, Property, name, meaning, ...)                              \
  softshadows::WithChoices(SOFTSHADOWS_OPTION(Choice, pass, Property, name, meaning),              \
    std::vector<std::string> __VA_ARGS__)

#endif
