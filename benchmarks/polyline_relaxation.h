// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "benchmarks/polyline_energy.h"

namespace bspline_curve::benchmarks {

/// A curve that has been relaxed as a polyline.
struct RelaxedPolyline {
    FootedPolyline line;
    bool isWithinTolerance = false;  ///< at all vertices
    double largestHeight = 0.0;      ///< in tolerances
    double internalEnergy = 0.0;
    int rounds = 0, steps = 0;
};

/// What the paper compares with: not a spline, but a polyline with a fixed number of vertices is
/// optimised, as by Jin et al., "A shell space constrained approach for curve design on surface
/// meshes", 2019 ([9] of the paper). Over the same fibres as solveSampled(), from the same initial
/// path, with the same energies, weights, growth of the weights and stop rules; no vertices are
/// inserted.
[[nodiscard]] RelaxedPolyline relaxPolyline(
    const CurveProblem& problem, const InitialPath& initialPath, int count
);

}  // namespace bspline_curve::benchmarks
