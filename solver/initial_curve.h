// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/curve_problem.h"
#include "spline/spline_space.h"

#include <optional>
#include <vector>

namespace bspline_curve {

/// A way along the surface through all picks, by parameter: what the first spline follows.
struct InitialPath {
    struct Point {
        double parameter;  ///< ascending in [0, 1]
        SurfacePoint point;
        Vec3 position;  ///< in the shell's frame
    };

    std::vector<Point> points;  ///< closed: ends where it starts, with parameter 1

    /// The last point at or before t that has one after it.
    [[nodiscard]] std::size_t indexAt(double t) const;

    /// The same, from that of an earlier t on. O(n) for n points between.
    [[nodiscard]] std::size_t indexFrom(std::size_t earlier, double t) const;

    /// On the straight line between two points.
    [[nodiscard]] Vec3 positionAt(double t) const { return positionAfter(indexAt(t), t); }

    /// The same where point i is indexAt(t).
    [[nodiscard]] Vec3 positionAfter(std::size_t i, double t) const;

    [[nodiscard]] double length() const;
};

struct SplineCurve {
    SplineSpace space;
    ControlPoints controls;
};

/// The first spline, made as the options say; nothing where none along the initial path stays
/// inside the shell.
[[nodiscard]] std::optional<SplineCurve> makeFirstCurve(
    const CurveProblem& problem, const InitialPath& initialPath
);

/// First spline by least squares: follows the initial path path, passes all picks, lies in the
/// shell. Spans that leave the shell are halved and the fit repeated. Nothing where no fit stays
/// inside.
[[nodiscard]] std::optional<SplineCurve> fitInitialPath(
    const CurveProblem& problem, const InitialPath& initialPath
);

/// The same within a distance of the initial path, in the shell's frame, instead of within the
/// shell. `breaks`: to begin with; empty: those of the picks.
[[nodiscard]] SplineCurve fitLoosely(
    const CurveProblem& problem,
    const InitialPath& initialPath,
    double distance,
    std::vector<double> breaks = {}
);

}  // namespace bspline_curve
