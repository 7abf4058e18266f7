// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/boundary_lines.h"
#include "workpiece/workpiece.h"

#include <span>
#include <string>
#include <vector>

// Smooth curves along many lines of one mesh.
namespace bspline_curve {

/// A line to be fitted, in the user's unit, as hosts have it.
struct LineToFit {
    std::vector<Vec3> points;
    bool closed = false;
    std::string name;  ///< for messages: "line 3 of lines.obj"
};

struct FittedLines {
    std::vector<DesignedCurve> curves;
    std::vector<std::size_t> lines;  ///< of each curve
    std::vector<std::string> notes;  ///< also of lines that were left out
};

/// The lines between faces of different labels as lines to be fitted, see boundaryLines().
/// `labels`: of the faces of the workpiece's mesh.
[[nodiscard]] std::vector<LineToFit> linesBetween(
    const TriangleMesh& mesh, std::span<const int> labels
);

/// The same round some faces.
[[nodiscard]] std::vector<LineToFit> linesRound(const TriangleMesh& mesh, const Region& faces);

/// Fits each. A line that has no smooth curve so near is left out with a note. Throws InputError
/// where that is so of all, or there are none; Cancelled.
[[nodiscard]] FittedLines fitLines(
    const Workpiece& workpiece,
    std::span<const LineToFit> lines,
    const FitOptions& fit,
    const CurveOptions& options,
    const Progress& progress = {}
);

}  // namespace bspline_curve
