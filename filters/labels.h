// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/filter_description.h"

#include <string>

namespace bspline_curve {

/// A message with the labels of parameters, in quotes, in place of their ids, for people who see a
/// dialog. Ids of one word stay: they are words of the sentence as well.
[[nodiscard]] std::string withLabels(const std::string& message, const FilterDescription& filter);

}  // namespace bspline_curve
