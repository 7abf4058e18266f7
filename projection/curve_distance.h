// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "projection/curve_trace.h"
#include "projection/trace_start.h"
#include "spline/spline_space.h"

#include <vector>

namespace bspline_curve {

/// How far a curve is from the surface, in the shell's frame.
struct CurveDistance {
    /// Largest distance sampled; infinite where the curve leaves the shell.
    double largest = 0.0;
    double largestHeight = 0.0;  ///< largest relative height d (10) in the shell
    /// Largest distance on each span; infinite where the curve leaves the shell there or before.
    std::vector<double> perSpan;
    CurveTrace trace;
};

/// Marks spans that are farther than the tolerance, as far as that is known: after one where the
/// curve leaves the shell it is not.
[[nodiscard]] std::vector<char> farSpans(const CurveDistance& distance, double tolerance);

/// Samples every piece of the curve at its start and middle. In a shell of full resolution the
/// distance is |P - M_S(P)|; in a simplified one, whose fibres are oblique, that to the face of the
/// shadow and those next to it. Beyond a boundary it is the distance to the boundary.
[[nodiscard]] CurveDistance measureDistance(
    const TraceStart& traced, const SplineSpace& space, const ControlPoints& controls
);

}  // namespace bspline_curve
