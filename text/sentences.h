// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

// What hosts say in whole sentences, where a line of the program has none.
namespace bspline_curve {

/// A note as a sentence of its own: with a capital, and a stop.
[[nodiscard]] std::string asSentence(std::string note);

/// Appends notes as sentences.
void addSentences(std::vector<std::string>& sentences, const std::vector<std::string>& notes);

/// That a mesh was parted into layers of these names: the first few of them.
[[nodiscard]] std::string describeLayers(const std::vector<std::string>& names);

}  // namespace bspline_curve
