// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the viewer can show in place of the picture.
 */

#ifndef DebugView_h
#define DebugView_h

#include "Technique.h"

#include <string>
#include <vector>

namespace softshadows
{

struct DebugView
{
  enum class Source
  {
    Picture,
    Visibility, ///< Of the selected light, grey.
    Penumbra,   ///< Of the selected light: lit, umbra, and bands between them.
    Error       ///< Visibility minus the reference, blue too dark, red too bright.
  };

  std::string Name;
  std::string Meaning; ///< A line for the user.
  Source Shows = Source::Picture;
  ///@{
  /// An option of the technique that is set while the view is shown; none if empty.
  std::string Option;
  double Value = 0.0;
  ///@}

  /// Whether the pass computes the true visibility while this is shown.
  bool KeepsVisibility() const { return this->Option.empty() || this->Shows == Source::Picture; }
};

/// The views of a technique: picture, visibility, penumbra and error first, then its own.
std::vector<DebugView> GetDebugViews(const Technique& technique);

/// Whether an option belongs to the views and not to the settings.
bool IsViewOption(const std::string& name);

}

#endif
