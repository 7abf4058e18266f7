// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace bspline_curve {

/// A number that a filter answers with, or a list of them (points: x, y, z of each in turn).
struct Figure {
    std::string name;
    std::variant<bool, int, double, std::vector<double>> value;
};

/// In the order in which hosts show them.
using Figures = std::vector<Figure>;

/// "usable=true vertices=311 length=1.41421 …": the figures that are no lists, for logs. Doubles
/// with as many digits as it takes to tell them from others, the same in every locale.
[[nodiscard]] std::string keyValueText(const Figures& figures);

}  // namespace bspline_curve
