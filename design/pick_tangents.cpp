// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/pick_tangents.h"

#include "bspline_curve/error.h"
#include "bspline_curve/spline.h"
#include "text/error_messages.h"
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

/// The unit direction along the surface; zero: any.
Vec3 alongSurface(const Vec3& asked, const Vec3& normal, std::size_t pick) {
    if (asked.isZero(0.0)) {
        return asked;
    }
    if (!asked.allFinite()) {
        refuseTangent(pick, " is not finite");
    }
    const Vec3 direction = asked.normalized();
    const Vec3 along = direction - direction.dot(normal) * normal;
    if (!(along.norm() >= kLeastAlong)) {
        refuseTangent(pick, " is normal to the surface");
    }
    return along.normalized();
}

}  // namespace

std::vector<PickTangent> tangentsOf(
    const ExtendedSurface& extended,
    const LocatedPicks& located,
    std::span<const PickTangent> asked,
    std::span<const int> corners,
    const SolverOptions& options
) {
    if (std::ranges::all_of(asked, &PickTangent::isAny)) {
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
    std::vector<PickTangent> tangents(located.points.size());
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const int point = located.pointOf[i];
        if (asked[i].isAny() || !tangents[point].isAny()) {
            continue;
        }
        const bool isEnd = !options.closed && (point == 0 || point == last);
        const bool isCorner = !isEnd && std::ranges::binary_search(corners, point);
        const Vec3 normal = unitNormalAt(extended, located.points[point]);
        PickTangent& tangent = tangents[point];
        tangent.before = alongSurface(asked[i].before, normal, i);
        tangent.after = alongSurface(asked[i].after, normal, i);
        if (!isEnd && !isCorner && !asked[i].isOne()) {
            refuseTangent(i, " has two directions, which only a corner can have");
        }
        if (isEnd) {
            tangent = PickTangent::along(point == 0 ? tangent.after : tangent.before);
        }
    }
    return tangents;
}

std::vector<Vec3> tangentsOfPiece(
    std::span<const PickTangent> tangents, std::span<const int> points, bool closed
) {
    std::vector<Vec3> result;
    for (const int point : tangents.empty() ? std::span<const int>() : points) {
        result.push_back(tangents[point].after);
    }
    if (!result.empty() && !closed) {
        result.back() = tangents[points.back()].before;
    }
    const bool areAny = std::ranges::all_of(result, [](const Vec3& t) { return t.isZero(0.0); });
    return areAny ? std::vector<Vec3>() : result;
}

std::vector<MetTangent> metTangents(
    const ExtendedSurface& extended,
    const LocatedPicks& located,
    std::span<const PickTangent> tangents,
    const Curve& curve
) {
    const SurfacePolyline& line = curve.polyline;
    const auto count = static_cast<int>(line.points.size());
    std::vector<MetTangent> met;
    for (std::size_t i = 0; !tangents.empty() && i < located.pointOf.size(); ++i) {
        const int point = located.pointOf[i];
        const PickTangent& asked = tangents[point];
        if (asked.isAny()) {
            continue;
        }
        MetTangent each{
            .pick = static_cast<int>(i),
            .isBefore = !asked.before.isZero(0.0),
            .isAfter = !asked.after.isZero(0.0)
        };
        const PickTangent drawn = directionsAtPick(curve.spline, each.pick);
        const Vec3 normal = unitNormalAt(extended, located.points[point]);
        const int vertex = line.picks[i];
        const auto measure = [&](const Vec3& tangent, const Vec3& ofSpline, int from, int to) {
            each.ofSpline = std::max(each.ofSpline, angleBetween(tangent, ofSpline));
            const Vec3 way =
                line.points[(to + count) % count] - line.points[(from + count) % count];
            const Vec3 along = way - way.dot(normal) * normal;
            each.ofPolyline = std::max(each.ofPolyline, angleBetween(tangent, along));
        };
        if (each.isBefore && (line.closed || vertex > 0)) {
            measure(asked.before, drawn.before, vertex - 1, vertex);
        }
        if (each.isAfter && (line.closed || vertex + 1 < count)) {
            measure(asked.after, drawn.after, vertex, vertex + 1);
        }
        met.push_back(each);
    }
    return met;
}

}  // namespace bspline_curve
