// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"

#include <span>
#include <string>
#include <vector>

namespace bspline_curve::cli {

struct FitFigures {
    std::string line;  ///< its name
    const Curve* curve = nullptr;
    double seconds = 0.0;
};

/// JSON: of each curve line, closed, length, deviation (farthest from the line, user's unit),
/// degree, control_points and picks (how many), corners (pick, turn of the line in degrees),
/// status, usable, seconds; the notes.
[[nodiscard]] std::string fitReportBytes(
    std::span<const FitFigures> curves, std::span<const std::string> notes
);

}  // namespace bspline_curve::cli
