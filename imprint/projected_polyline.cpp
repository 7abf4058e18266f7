// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/projected_polyline.h"

#include "bspline_curve/error.h"
#include "imprint/draped_polyline.h"
#include "surface/geodesic_path.h"
#include "surface/picks.h"
#include "surface/segment_distance.h"
#include "surface/surface_point.h"
#include "text/error_messages.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

/// How often the way between two vertices is halved at most.
constexpr int kMostHalvings = 20;

struct Foot {
    SurfacePoint point;
    Vec3 at;  // in space, on the polyline
};

class Projector {
public:
    Projector(const Surface& surface, const TriangleTree& tree, double distance)
        : surface_(surface), tree_(tree), distance_(distance), paths_(surface, {}) {}

    [[nodiscard]] const std::vector<std::size_t>& jumps() const { return jumps_; }

    SurfacePolyline project(const SpacePolyline& line) {
        const std::size_t count = line.points.size();
        lastVertex_ = count - 1;
        Foot last = footOf(line.points[0], 0);
        const Foot first = last;
        add(last.point);
        for (std::size_t i = 1; i < count; ++i) {
            const Foot next = footOf(line.points[i], i);
            connect(last, next, i, 0);
            last = next;
        }
        if (line.closed) {
            connect(last, first, 0, 0);
        }
        return finished(line.closed);
    }

private:
    [[nodiscard]] Foot footOf(const Vec3& position, std::size_t vertex) const {
        const TriangleTree::Closest closest = tree_.closestPoint(position);
        const double away = std::sqrt(closest.squaredDistance);
        if (!(away <= distance_)) {
            throw InputError(
                InputErrorCode::PickTooFar,
                "vertex " + std::to_string(vertex) + ", or what leads to it, is " +
                    describeNumber(away) + " away from the mesh, and " + describeNumber(distance_) +
                    " at most is allowed",
                {static_cast<std::int64_t>(vertex)}
            );
        }
        return {.point = snapped(closest.point, kOnEdgeBarycentric), .at = position};
    }

    void add(const SurfacePoint& point) {
        const Vec3 position = surface_.position(point);
        if (line_.points.empty() || position != line_.points.back()) {
            line_.surfacePoints.push_back(point);
            line_.points.push_back(position);
        }
    }

    [[nodiscard]] double sizeAt(const SurfacePoint& point) const {
        const Triangle& face = surface_.faces()[point.face];
        double longest = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 side = surface_.vertices()[face[(k + 1) % 3]] - surface_.vertices()[face[k]];
            longest = std::max(longest, side.norm());
        }
        return longest;
    }

    void connect(const Foot& from, const Foot& to, std::size_t vertex, int halvings) {
        if (commonFace(surface_, from.point, to.point) >= 0) {
            add(to.point);
            return;
        }
        const double length = (to.at - from.at).norm();
        const double size = std::min(sizeAt(from.point), sizeAt(to.point));
        if (halvings < kMostHalvings && length > 0.5 * size) {
            const Foot middle = footOf(0.5 * (from.at + to.at), vertex);
            connect(from, middle, vertex, halvings + 1);
            connect(middle, to, vertex, halvings + 1);
        } else {
            follow(from, to, vertex, distance_ + length);
        }
    }

    void follow(const Foot& from, const Foot& to, std::size_t vertex, double reach) {
        const std::optional<GeodesicPath> path = paths_.find(from.point, to.point);
        bool isNear = path.has_value();
        for (std::size_t i = 0; isNear && i < path->points.size(); ++i) {
            isNear = distanceToSegment(path->positions[i], from.at, to.at) <= reach;
        }
        if (!isNear) {
            throw InputError(
                InputErrorCode::NoPath,
                "the segment that ends in vertex " + std::to_string(vertex) +
                    " leads over a gap of the mesh, or to another part of it",
                {static_cast<std::int64_t>(vertex)}
            );
        }
        for (std::size_t i = 1; i < path->points.size(); ++i) {
            add(path->points[i]);
        }
        if (isJump(from, to)) {
            jumps_.push_back(vertex == 0 ? lastVertex_ : vertex - 1);
        }
    }

    /// Whether the closest point jumps by more than a mean edge between two points of the polyline.
    [[nodiscard]] bool isJump(const Foot& from, const Foot& to) const {
        const auto distanceOf = [&](const SurfacePoint& a, const SurfacePoint& b) {
            return (surface_.position(a) - surface_.position(b)).norm();
        };
        Foot low = from;
        Foot high = to;
        double distance = distanceOf(low.point, high.point);
        for (int i = 0; i < kMostHalvings && distance > surface_.averageEdgeLength(); ++i) {
            const Vec3 middle = 0.5 * (low.at + high.at);
            const Foot between{.point = tree_.closestPoint(middle).point, .at = middle};
            const double before = distanceOf(low.point, between.point);
            const double after = distanceOf(between.point, high.point);
            (before < after ? low : high) = between;
            distance = std::max(before, after);
        }
        return distance > surface_.averageEdgeLength();
    }

    SurfacePolyline finished(bool closed) {
        if (closed && line_.points.size() > 1 && line_.points.back() == line_.points.front()) {
            line_.points.pop_back();
            line_.surfacePoints.pop_back();
        }
        if (line_.points.size() < (closed ? 3U : 2U)) {
            throw InputError(
                InputErrorCode::NoPath, "vertex 0 and all others are one point on the mesh", {0}
            );
        }
        line_.closed = closed;
        setParametersByLength(line_);
        return std::move(line_);
    }

    const Surface& surface_;
    const TriangleTree& tree_;
    double distance_;
    GeodesicPathFinder paths_;
    SurfacePolyline line_;
    std::size_t lastVertex_ = 0;  // of the polyline
    std::vector<std::size_t> jumps_;
};

}  // namespace

void setParametersByLength(SurfacePolyline& line) {
    line.parameters.clear();
    double length = 0.0;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        length += i > 0 ? (line.points[i] - line.points[i - 1]).norm() : 0.0;
        line.parameters.push_back(length);
    }
    length += line.closed ? (line.points.front() - line.points.back()).norm() : 0.0;
    for (double& t : line.parameters) {
        t /= length;
    }
}

SurfacePolyline projectedPolyline(
    const Surface& surface, const TriangleTree& tree, const SpacePolyline& line, double distance
) {
    return std::move(projectedLines(surface, tree, line, {.distance = distance}).lines.front());
}

void ProjectionOptions::validate() const {
    if (!(distance >= 0.0)) {
        throw InputError(
            InputErrorCode::BadOption,
            "distance is " + describeNumber(distance) + ", but must not be negative"
        );
    }
    if (direction && (!direction->allFinite() || direction->isZero(0.0))) {
        throw InputError(
            InputErrorCode::BadOption, "direction must be three finite numbers that are not all 0"
        );
    }
}

ProjectedLines projectedLines(
    const Surface& surface,
    const TriangleTree& tree,
    const SpacePolyline& line,
    const ProjectionOptions& options
) {
    options.validate();
    ProjectedLines result;
    if (options.direction) {
        result = drapedPolyline(surface, tree, line, *options.direction, options.distance);
    } else {
        const double reach =
            options.distance > 0.0 ? options.distance : kPickReachRelative * surface.diagonal();
        Projector projector(surface, tree, reach);
        result.lines.push_back(projector.project(line));
        result.jumps = projector.jumps();
    }
    for (SurfacePolyline& each : result.lines) {
        surface.provenance().bringToInput(each);
    }
    return result;
}

namespace {

/// "2 times (first behind vertex 3 of polyline 1)"
std::string describePlaces(
    std::span<const ProjectedLines> polylines, std::vector<std::size_t> ProjectedLines::* member
) {
    std::size_t count = 0;
    std::string first;
    for (std::size_t i = 0; i < polylines.size(); ++i) {
        const std::vector<std::size_t>& places = polylines[i].*member;
        if (count == 0 && !places.empty()) {
            first = " (first behind vertex " + std::to_string(places.front()) +
                    (polylines.size() > 1 ? " of polyline " + std::to_string(i) : "") + ")";
        }
        count += places.size();
    }
    return count == 0 ? "" : describeCount(count, "time", "times") + first;
}

}  // namespace

std::string projectionNote(std::span<const ProjectedLines> polylines) {
    const std::string gaps = describePlaces(polylines, &ProjectedLines::gaps);
    const std::string jumps = describePlaces(polylines, &ProjectedLines::jumps);
    std::string note;
    if (!gaps.empty()) {
        note = "along the direction it is beside the mesh " + gaps + ", and parted there";
    }
    if (!jumps.empty()) {
        note += (note.empty() ? "" : "; ") + std::string("it jumps ") + jumps +
                " from one part of the surface to another, and follows the surface there";
    }
    return note;
}

}  // namespace bspline_curve
