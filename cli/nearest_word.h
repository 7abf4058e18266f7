// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace bspline_curve::cli {

/// "; did you mean valley?" where one of `words` differs from `word` by at most two letters (one in
/// words of up to three); else "".
[[nodiscard]] std::string didYouMean(std::string_view word, std::span<const std::string> words);

}  // namespace bspline_curve::cli
