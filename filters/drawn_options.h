// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/filter_description.h"
#include "filters/parameter_values.h"
#include "filters/requests.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace bspline_curve {

/// The default of a parameter of curveFilter().
template <class Value>
[[nodiscard]] Value curveDefault(std::string_view id) {
    return std::get<Value>(curveFilter().parameter(id).defaultValue);
}

/// What a drawing tool offers of a curve, named and valued as the parameters of curveFilter(), with
/// the same defaults.
struct DrawnOptions {
    bool closed = curveDefault<bool>("closed");
    int degree = curveDefault<int>("degree");
    double tension = curveDefault<double>("tension");
    std::string pickTolerance = curveDefault<std::string>("pick_tolerance");
    std::string field = curveDefault<std::string>("field");
    double fieldWeight = curveDefault<double>("field_weight");
    std::string avoid = curveDefault<std::string>("avoid");
    double avoidThreshold = curveDefault<double>("avoid_threshold");

    friend bool operator==(const DrawnOptions&, const DrawnOptions&) = default;
};

/// Those parameters of curveFilter() that DrawnOptions has, in the order of its dialogs.
[[nodiscard]] const std::vector<std::string>& drawnParameters();

/// The values of all parameters of curveFilter(); what is no drawn one has its default. Throws
/// InputError where a name is none of the filter's.
[[nodiscard]] ParameterValues valuesOf(const DrawnOptions& options);

/// Of the values of curveFilter(), those that DrawnOptions has: the inverse of valuesOf().
[[nodiscard]] DrawnOptions drawnOptionsOf(const ParameterValues& values);

/// The options that a request was made of; none where it asks for something that a drawing tool
/// does not offer, so that the same curve could not be drawn again. Picks and what the curve leaves
/// besides its layer do not count.
[[nodiscard]] std::optional<DrawnOptions> drawnOptions(const CurveRequest& request);

}  // namespace bspline_curve
