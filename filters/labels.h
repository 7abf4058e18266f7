// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/filter_description.h"

#include <string>

namespace bspline_curve {

/// A message with the labels of parameters and of their choices, in quotes, for people who see a
/// dialog. Labels take the place of
/// - ids with an underscore: "picks_file";
/// - ids after "option" or "options": "the option weld", "the options size and scale";
/// - the subject of a message: "weld is 2, but …", "field weight is −1, but …", "up has no …";
/// - choices in quotes: "\"seed\"", with the label that the parameter named last has for them.
/// Other ids of one word stay, since they are words of the sentence as well, and so do names of
/// layers.
[[nodiscard]] std::string withLabels(const std::string& message, const FilterDescription& filter);

}  // namespace bspline_curve
