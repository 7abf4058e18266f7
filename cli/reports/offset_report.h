// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/offset.h"

#include <string>
#include <vector>

namespace bspline_curve::cli {

/// JSON: distance, tolerance, seconds (draw: the curve; offset: the lines); of each piece closed,
/// length, deviation (largest, in distances), fitted, degree and control_points (how many).
[[nodiscard]] std::string offsetReportBytes(
    const std::vector<FittedLine>& pieces,
    const OffsetOptions& options,
    double drawSeconds,
    double offsetSeconds
);

}  // namespace bspline_curve::cli
