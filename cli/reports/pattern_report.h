// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/pattern.h"

#include <string>

namespace bspline_curve::cli {

struct PatternFigures {
    double readSeconds = 0.0;     ///< files
    double prepareSeconds = 0.0;  ///< the mesh
    double drawSeconds = 0.0;     ///< carrying the drawing, and all curves
    std::string font;             ///< file of the text's letters, UTF-8; empty: a drawing
};

/// The report of a pattern, .json: how many curves, how near they are to the carried drawing, how
/// much that is shortened and lengthened most and where, the font of a text, path, copy and length
/// of each curve.
[[nodiscard]] std::string patternReportBytes(const Pattern& pattern, const PatternFigures& figures);

}  // namespace bspline_curve::cli
