// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Help in error messages: what the user may have meant, and what there is.
 */

#ifndef Suggestion_h
#define Suggestion_h

#include <string>
#include <vector>

namespace softshadows
{

/// The known word nearest to the given one; empty if none is near.
std::string NearestWord(const std::string& word, const std::vector<std::string>& known);

/// "did you mean 'color'? Known are: ...", without the question where no known word is near.
std::string DidYouMean(const std::string& word, const std::vector<std::string>& known);

}

#endif
