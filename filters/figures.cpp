// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/figures.h"

#include <array>
#include <charconv>
#include <type_traits>

namespace bspline_curve {

std::string keyValueText(const Figures& figures) {
    std::string text;
    const auto add = [&](const std::string& name, const std::string& value) {
        text += (text.empty() ? "" : " ") + name + "=" + value;
    };
    for (const auto& [name, figure] : figures) {
        if (const auto* const flag = std::get_if<bool>(&figure)) {
            add(name, *flag ? "true" : "false");
        } else if (const auto* const whole = std::get_if<int>(&figure)) {
            add(name, std::to_string(*whole));
        } else if (const auto* const number = std::get_if<double>(&figure)) {
            std::array<char, 32> digits{};
            char* const end =
                std::to_chars(digits.data(), digits.data() + digits.size(), *number).ptr;
            add(name, std::string(digits.data(), end));
        }
    }
    return text;
}

}  // namespace bspline_curve
