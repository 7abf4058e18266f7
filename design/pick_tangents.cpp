// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/pick_tangents.h"

#include "bspline_curve/error.h"
#include "bspline_curve/spline.h"
#include "surface/error_messages.h"
#include "utility/index_sets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace bspline_curve {
namespace {

/// Of a direction's length: with less along the surface it does not say where to go.
constexpr double kLeastAlong = 1e-3;

[[noreturn]] void refuseTangent(std::size_t pick, const std::string& what) {
    const auto id = static_cast<std::int64_t>(pick);
    throw InputError(
        InputErrorCode::BadOption, "the tangent of " + describePicks({id}) + what, {id}
    );
}

Vec3 unitNormalAt(const ExtendedSurface& extended, const SurfacePoint& point) {
    return extended.normalAt(point.face, point.barycentric).normalized();
}

double angleBetween(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

void requireTangentOptions(const SolverOptions& options) {
    if (options.interpolation != Interpolation::Constraint ||
        options.initialCurve != InitialCurve::GeodesicFit) {
        throw InputError(
            InputErrorCode::BadOption,
            R"(tangents need interpolation = "constraint" and initial_curve = "geodesic-fit")"
        );
    }
}

}  // namespace

std::vector<Vec3> tangentsOf(
    const ExtendedSurface& extended,
    const LocatedPicks& located,
    std::span<const Vec3> asked,
    std::span<const int> corners,
    const SolverOptions& options
) {
    const auto isFree = [](const Vec3& direction) { return direction.isZero(0.0); };
    if (std::ranges::all_of(asked, isFree)) {
        return {};
    }
    if (asked.size() != located.pointOf.size()) {
        throw InputError(
            InputErrorCode::BadOption,
            "there are " + std::to_string(asked.size()) + " tangents for " +
                describeCount(located.pointOf.size(), "pick", "picks") + ": give one for each"
        );
    }
    requireTangentOptions(options);
    const int last = static_cast<int>(located.points.size()) - 1;
    std::vector<Vec3> tangents(located.points.size(), Vec3::Zero());
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const int point = located.pointOf[i];
        if (isFree(asked[i]) || !isFree(tangents[point])) {
            continue;
        }
        if (!asked[i].allFinite()) {
            refuseTangent(i, " is not finite");
        }
        const bool isEnd = !options.closed && (point == 0 || point == last);
        if (!isEnd && std::ranges::binary_search(corners, point)) {
            refuseTangent(i, " is one of a corner, at which the curve has two directions");
        }
        const Vec3 direction = asked[i].normalized();
        const Vec3 normal = unitNormalAt(extended, located.points[point]);
        const Vec3 along = direction - direction.dot(normal) * normal;
        if (!(along.norm() >= kLeastAlong)) {
            refuseTangent(i, " is normal to the surface");
        }
        tangents[point] = along.normalized();
    }
    return tangents;
}

std::vector<MetTangent> metTangents(
    const ExtendedSurface& extended,
    const LocatedPicks& located,
    std::span<const Vec3> tangents,
    const Curve& curve
) {
    const SurfacePolyline& line = curve.polyline;
    const auto count = static_cast<int>(line.points.size());
    std::vector<MetTangent> met;
    for (std::size_t i = 0; !tangents.empty() && i < located.pointOf.size(); ++i) {
        const int point = located.pointOf[i];
        const Vec3& tangent = tangents[point];
        if (tangent.isZero(0.0)) {
            continue;
        }
        MetTangent each{.pick = static_cast<int>(i)};
        each.ofSpline =
            angleBetween(tangent, derivativeOf(curve.spline, curve.spline.pickParameters[i]));
        const Vec3 normal = unitNormalAt(extended, located.points[point]);
        const int vertex = line.picks[i];
        const auto measure = [&](int from, int to) {
            const Vec3 way =
                line.points[(to + count) % count] - line.points[(from + count) % count];
            const Vec3 along = way - way.dot(normal) * normal;
            each.ofPolyline = std::max(each.ofPolyline, angleBetween(tangent, along));
        };
        if (line.closed || vertex > 0) {
            measure(vertex - 1, vertex);
        }
        if (line.closed || vertex + 1 < count) {
            measure(vertex, vertex + 1);
        }
        met.push_back(each);
    }
    return met;
}

}  // namespace bspline_curve
