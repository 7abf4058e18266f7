// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/pieces.h"
#include "offset/surface_fan.h"
#include "pattern/straightest_path.h"
#include "surface/strict_line.h"
#include "surface/surface_point.h"
#include "text/error_messages.h"
#include "workpiece/curve_chain.h"
#include "workpiece/workpiece_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

namespace bspline_curve {

namespace {

/// The geodesic is drawn through points that are so far apart, relative to the diagonal.
constexpr double kStepRelative = 0.05;

void requireExtension(double length, const char* where) {
    if (!(length >= 0.0) || !std::isfinite(length)) {
        throw InputError(
            InputErrorCode::BadOption,
            std::string("the length at the ") + where + " is " + describeNumber(length) +
                ", but must be at least 0"
        );
    }
}

/// Positions of a path at even distances of about a step, the first and the last point among them.
std::vector<Vec3> thinnedPath(const std::vector<Vec3>& path, double length, double step) {
    const int parts = std::max(1, static_cast<int>(std::lround(length / step)));
    std::vector<Vec3> picks{path.front()};
    double passed = 0.0;
    int next = 1;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const double segment = (path[i] - path[i - 1]).norm();
        while (next < parts && passed + segment >= length * next / parts) {
            const double share = (length * next / parts - passed) / segment;
            picks.emplace_back((1.0 - share) * path[i - 1] + share * path[i]);
            ++next;
        }
        passed += segment;
    }
    picks.push_back(path.back());
    return picks;
}

/// What follows a curve's end.
Curve beyondEnd(
    const Workpiece& workpiece, const Curve& curve, double length, const Progress& progress
) {
    const Surface& surface = surfaceOf(workpiece);
    const CurveEnd end = endOf(curve);
    SurfacePolyline place;
    place.surfacePoints.push_back(curve.polyline.surfacePoints.back());
    const SurfacePoint from = snapped(
        strictLine(surface, std::move(place), "the curve").surfacePoints.front(), kSnapBarycentric
    );
    const SurfaceFan fan = fanOf(surface, from);
    const std::optional<double> angle = angleOfDirection(surface, fan, end.direction);
    const StraightestPath path =
        angle ? straightestPath(surface, from, fan, *angle, length) : StraightestPath{};
    if (!(path.length > 0.0)) {
        throw InputError(
            InputErrorCode::NoPath, "the curve ends at a boundary of the mesh: nothing is beyond it"
        );
    }
    std::vector<Vec3> points;
    for (const SurfacePoint& point : path.points) {
        points.push_back(surface.position(point));
    }
    const Vec3 last = points.back() - points[points.size() - 2];
    const double step = kStepRelative * workpiece.diagonal();
    return drawnBetween(
        workpiece,
        {.picks = thinnedPath(points, path.length, step),
         .degree = curve.spline.degree,
         .from = end,
         .to = {},
         .first = end.direction,
         .last = last},
        progress
    );
}

Curve extendedAtEnd(
    const Workpiece& workpiece, const Curve& curve, double length, const Progress& progress
) {
    if (length == 0.0) {
        return curve;
    }
    return chained(std::array{curve, beyondEnd(workpiece, curve, length, progress)}, true);
}

}  // namespace

Curve extendedCurve(
    const Workpiece& workpiece,
    const Curve& curve,
    double atStart,
    double atEnd,
    const Progress& progress
) {
    requireExtension(atStart, "start");
    requireExtension(atEnd, "end");
    if (curve.polyline.closed) {
        throw InputError(InputErrorCode::BadOption, "a closed curve has no ends to be extended");
    }
    Curve longer = extendedAtEnd(workpiece, curve, atEnd, progress);
    if (atStart == 0.0) {
        return longer;
    }
    return reversedCurve(extendedAtEnd(workpiece, reversedCurve(longer), atStart, progress));
}

}  // namespace bspline_curve
