// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/parameter_values.h"
#include "filters/requests.h"

#include <optional>
#include <string>
#include <vector>

namespace bspline_curve {

/// What a drawing tool offers of a curve, named and valued as the parameters of curveFilter().
struct DrawnOptions {
    bool closed = false;
    int degree = 3;
    double tension = 0.0;
    std::string field = "none";
    double fieldWeight = 2000.0;
    std::string avoid = "none";
    double avoidThreshold = 0.0;

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
