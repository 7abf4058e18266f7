// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/number_text.h"

#include <array>
#include <charconv>

namespace bspline_curve {

std::string numberText(double value) {
    std::array<char, 32> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end};
}

}  // namespace bspline_curve
