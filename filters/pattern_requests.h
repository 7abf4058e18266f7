// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/imprint_requests.h"
#include "pattern/carried_drawing.h"
#include "pattern/pattern_layout.h"

#include <string>
#include <vector>

// What users ask for of the filter that carries drawings to surfaces, as the libraries take it.
namespace bspline_curve {

/// Where a drawing goes.
enum class PatternPlace { Point, Curve };

struct PatternRequest {
    CurveUse use;             ///< its curves, where the drawing goes along them
    std::string drawingFile;  ///< UTF-8; empty: text
    std::string text;         ///< UTF-8
    std::string fontFile;     ///< UTF-8; empty: found
    std::string layers;       ///< of a DXF, with commas between them; empty: all that are visible
    PatternPlace place = PatternPlace::Point;
    std::string centre;  ///< "x y z"; empty: the one point of the host's own tool
    std::string up;      ///< "x y z"; empty: found
    RowLayout row;
    PatternOptions pattern;
};

[[nodiscard]] Bindings<PatternRequest> patternBindings();
[[nodiscard]] Bindings<DrawingScale> scaleBindings();
[[nodiscard]] Bindings<RowLayout> rowBindings();
[[nodiscard]] Bindings<PatternOptions> carryingBindings();

/// Of patternFilter(). Throws InputError (BadOption) naming the value and its range where a number
/// is outside, or where neither drawing nor text is given, or both.
[[nodiscard]] PatternRequest patternRequest(const ParameterValues& values);

/// The names of the layers to read.
[[nodiscard]] std::vector<std::string> patternLayers(const PatternRequest& request);

/// The centre of the drawing. `toolPoints`: of the host's own tool, in world coordinates. Throws
/// InputError where there is none, or more than one.
[[nodiscard]] Vec3 patternCentre(
    const PatternRequest& request, const std::vector<Vec3>& toolPoints
);

/// The direction of its up; none: it is found. Throws InputError.
[[nodiscard]] std::optional<Vec3> patternUp(const PatternRequest& request);

}  // namespace bspline_curve
