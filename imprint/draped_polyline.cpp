// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/draped_polyline.h"

#include "bspline_curve/error.h"
#include "imprint/projected_polyline.h"
#include "surface/geodesic_path.h"
#include "surface/surface_point.h"
#include "text/error_messages.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

/// Steps along a segment, in mean edge lengths.
constexpr double kStepEdges = 0.5;
/// How often a step is halved where its ends are in faces that are no neighbours.
constexpr int kMostStepHalvings = 20;
/// The same until the place where a line leaves the mesh is known to rounding.
constexpr int kBorderHalvings = 48;
/// A way that passes a vertex nearer than this, in mean edge lengths, goes through it.
constexpr double kThroughVertexEdges = 1e-5;
/// Steps of one segment, at most: of a mesh whose diagonal is a million edges.
constexpr double kMostSteps = 4e6;

/// A point of the polyline, and where it falls.
struct Shadow {
    Vec3 at;             ///< on the polyline
    SurfacePoint point;  ///< face -1: beside the mesh
    Vec3 position = Vec3::Zero();

    [[nodiscard]] bool isHit() const { return point.face >= 0; }
};

class Draper {
public:
    Draper(const Surface& surface, const TriangleTree& tree, const Vec3& direction, double distance)
        : surface_(surface),
          tree_(tree),
          direction_(direction.normalized()),
          distance_(distance),
          edge_(surface.averageEdgeLength()),
          paths_(surface, {}) {
        Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
        Vec3 high = -low;
        for (const Triangle& face : surface.faces()) {
            for (const int vertex : face) {
                low = low.cwiseMin(surface.vertices()[vertex]);
                high = high.cwiseMax(surface.vertices()[vertex]);
            }
        }
        middle_ = 0.5 * (low + high);
        radius_ = 0.5 * (high - low).norm() + edge_;
    }

    ProjectedLines drape(const SpacePolyline& line) {
        const std::size_t count = line.points.size();
        const Shadow first = shadowOf(line.points[0]);
        if (!first.isHit() && !line.closed) {
            result_.gaps.push_back(0);
        }
        begin(first);
        Shadow last = first;
        for (vertex_ = 0; vertex_ + 1 < count; ++vertex_) {
            last = goOn(last, shadowOf(line.points[vertex_ + 1]));
        }
        if (line.closed) {
            goOn(last, first);
        }
        finish(line.closed, first.isHit());
        return std::move(result_);
    }

private:
    [[nodiscard]] Shadow shadowOf(const Vec3& at) const {
        Shadow shadow{.at = at, .point = {.face = -1, .barycentric = Vec3::Zero()}};
        const Vec3 toMiddle = middle_ - at;
        const double along = direction_.dot(toMiddle);
        if ((toMiddle - along * direction_).norm() > radius_) {
            return shadow;
        }
        const Vec3 outside = at + (along - 2.0 * radius_) * direction_;
        const TriangleTree::Hit hit = tree_.firstHit(outside, direction_);
        if (hit.point.face >= 0) {
            shadow.point = snapped(hit.point, kOnEdgeBarycentric);
            shadow.position = surface_.position(shadow.point);
            checkDistance(shadow);
        }
        return shadow;
    }

    void checkDistance(const Shadow& shadow) const {
        const double away = std::abs(direction_.dot(shadow.position - shadow.at));
        if (distance_ > 0.0 && away > distance_) {
            throw InputError(
                InputErrorCode::PickTooFar,
                "vertex " + std::to_string(vertex_) + ", or what follows it, is " +
                    describeNumber(away) + " away from the mesh along the direction, and " +
                    describeNumber(distance_) + " at most is allowed",
                {static_cast<std::int64_t>(vertex_)}
            );
        }
    }

    void begin(const Shadow& shadow) {
        if (shadow.isHit()) {
            add(shadow.point, true);
        }
    }

    /// Takes the segment between two vertices; returns the second.
    Shadow goOn(const Shadow& from, const Shadow& to) {
        const Vec3 way = to.at - from.at;
        const Vec3 sideways = way - direction_.dot(way) * direction_;
        const double length = sideways.norm();
        Shadow last = from;
        if (length > 0.0) {
            // Farther from the mesh than this nothing is hit.
            const Vec3 toMiddle = middle_ - from.at;
            const double beside = sideways.dot(toMiddle) / length;
            const double low = std::clamp(beside - radius_, 0.0, length);
            const double high = std::clamp(beside + radius_, 0.0, length);
            const double steps =
                std::min(std::ceil((high - low) / (kStepEdges * edge_)), kMostSteps);
            for (double i = low > 0.0 ? 0.0 : 1.0; steps > 0.0 && i <= steps; ++i) {
                const double share = (low + (high - low) * (i / steps)) / length;
                if (share < 1.0) {
                    const Shadow next = shadowOf(from.at + share * way);
                    connect(last, next, 0);
                    last = next;
                }
            }
        }
        connect(last, to, 0);
        keepLast();
        return to;
    }

    void connect(const Shadow& from, const Shadow& to, int halvings) {
        if (!from.isHit() && !to.isHit()) {
            return;
        }
        if (!from.isHit()) {
            enter(from, to, halvings);
            return;
        }
        if (!to.isHit()) {
            leave(from, to, halvings);
            return;
        }
        if (commonFace(surface_, from.point, to.point) >= 0) {
            add(to.point, false);
            return;
        }
        if (const std::optional<SurfacePoint> crossing = crossingBetween(from, to)) {
            add(*crossing, false);
            add(to.point, false);
            return;
        }
        if (halvings < kMostStepHalvings) {
            const Shadow middle = shadowOf(0.5 * (from.at + to.at));
            connect(from, middle, halvings + 1);
            connect(middle, to, halvings + 1);
        } else {
            pass(from, to);
        }
    }

    /// Where the plane of the segment crosses the edge between the faces of its ends, if these are
    /// neighbours and the edge is crossed between the ends.
    [[nodiscard]] std::optional<SurfacePoint> crossingBetween(
        const Shadow& from, const Shadow& to
    ) const {
        const Triangle& neighbours = surface_.faceNeighbours()[from.point.face];
        const auto* const across = std::ranges::find(neighbours, to.point.face);
        if (across == neighbours.end()) {
            return std::nullopt;
        }
        const auto k = static_cast<std::size_t>(across - neighbours.begin());
        const Triangle& corners = surface_.faces()[from.point.face];
        const Vec3& a = surface_.vertices()[corners[(k + 1) % 3]];
        const Vec3& b = surface_.vertices()[corners[(k + 2) % 3]];
        const Vec3 way = to.at - from.at;
        const Vec3 normal = direction_.cross(way);
        const double ofA = normal.dot(a - from.at);
        const double ofB = normal.dot(b - from.at);
        if (ofA == ofB || (ofA > 0.0) == (ofB > 0.0)) {
            return std::nullopt;
        }
        const double share = ofA / (ofA - ofB);
        const Vec3 crossing = a + share * (b - a);
        const Vec3 sideways = way - direction_.dot(way) * direction_;
        const double along = sideways.dot(crossing - from.at);
        if (along < 0.0 || along > sideways.squaredNorm()) {
            return std::nullopt;
        }
        SurfacePoint point{.face = from.point.face, .barycentric = Vec3::Zero()};
        point.barycentric[static_cast<Eigen::Index>((k + 1) % 3)] = 1.0 - share;
        point.barycentric[static_cast<Eigen::Index>((k + 2) % 3)] = share;
        return snapped(point, kOnEdgeBarycentric);
    }

    /// Between two places that are next to each other along the segment: through a vertex, or by a
    /// jump.
    void pass(const Shadow& from, const Shadow& to) {
        const double reach = kThroughVertexEdges * edge_;
        for (std::size_t k = 0; k < 3; ++k) {
            const int vertex = surface_.faces()[from.point.face][k];
            const Vec3& position = surface_.vertices()[vertex];
            if (cornerOf(surface_.faces()[to.point.face], vertex) >= 0 &&
                (position - from.position).norm() <= reach &&
                (position - to.position).norm() <= reach) {
                SurfacePoint point{.face = from.point.face, .barycentric = Vec3::Zero()};
                point.barycentric[static_cast<Eigen::Index>(k)] = 1.0;
                add(point, false);
                add(to.point, false);
                return;
            }
        }
        const bool isJump = (to.position - from.position).norm() > edge_;
        if (isJump) {
            result_.jumps.push_back(vertex_);
        }
        const std::optional<GeodesicPath> path = paths_.find(from.point, to.point);
        if (!path) {
            end();
            add(to.point, true);
            return;
        }
        keepLast();
        for (std::size_t i = 1; i < path->points.size(); ++i) {
            add(path->points[i], true);
        }
    }

    /// The last place over the mesh, and the first one beside it.
    [[nodiscard]] std::pair<Shadow, Shadow> borderBetween(Shadow over, Shadow beside) const {
        for (int i = 0; i < kBorderHalvings; ++i) {
            const Shadow middle = shadowOf(0.5 * (over.at + beside.at));
            (middle.isHit() ? over : beside) = middle;
        }
        return {over, beside};
    }

    /// The point of the boundary there; none where the surface turns away.
    [[nodiscard]] std::optional<SurfacePoint> boundaryAt(
        const Shadow& over, const Shadow& beside
    ) const {
        const double height = direction_.dot(over.position - beside.at);
        const Vec3 level = beside.at + height * direction_;
        const SurfacePoint closest = snapped(tree_.closestPoint(level).point, kThroughVertexEdges);
        return commonFace(surface_, over.point, closest) >= 0 ? std::optional(closest)
                                                              : std::nullopt;
    }

    void leave(const Shadow& from, const Shadow& to, int halvings) {
        const auto [over, beside] = borderBetween(from, to);
        connect(from, over, halvings);
        if (const std::optional<SurfacePoint> boundary = boundaryAt(over, beside)) {
            add(*boundary, false);
        }
        keepLast();
        result_.gaps.push_back(vertex_);
        end();
    }

    void enter(const Shadow& from, const Shadow& to, int halvings) {
        const auto [over, beside] = borderBetween(to, from);
        if (const std::optional<SurfacePoint> boundary = boundaryAt(over, beside)) {
            add(*boundary, true);
            add(over.point, false);
        } else {
            add(over.point, true);
        }
        connect(over, to, halvings);
    }

    /// Points that are not kept give way to those that follow on the same straight line in a face.
    void add(const SurfacePoint& point, bool isKept) {
        const Vec3 position = surface_.position(point);
        std::vector<SurfacePoint>& points = line_.surfacePoints;
        if (!points.empty() && position == line_.points.back()) {
            isLastKept_ = isLastKept_ || isKept;
            return;
        }
        if (points.size() > 1 && !isLastKept_) {
            const int face = commonFace(surface_, points[points.size() - 2], point);
            const std::vector<int> ofLast = facesHolding(surface_, points.back());
            if (face >= 0 && std::ranges::find(ofLast, face) != ofLast.end()) {
                points.pop_back();
                line_.points.pop_back();
            }
        }
        points.push_back(point);
        line_.points.push_back(position);
        isLastKept_ = isKept;
    }

    void keepLast() { isLastKept_ = true; }

    /// A line of one point is none.
    void end() {
        if (line_.points.size() > 1) {
            result_.lines.push_back(std::move(line_));
        }
        line_ = {};
        ++ends_;
    }

    void finish(bool isClosed, bool beginsOnMesh) {
        const bool isWhole = isClosed && ends_ == 0;
        end();
        std::vector<SurfacePolyline>& lines = result_.lines;
        if (lines.empty() && result_.gaps.empty()) {
            result_.gaps.push_back(0);
        }
        if (isWhole && !lines.empty()) {
            SurfacePolyline& line = lines.front();
            if (line.points.size() > 1 && line.points.back() == line.points.front()) {
                line.points.pop_back();
                line.surfacePoints.pop_back();
            }
            line.closed = line.points.size() > 2;
            if (!line.closed) {
                lines.clear();
            }
        } else if (isClosed && beginsOnMesh && lines.size() > 1 &&
                   lines.back().points.back() == lines.front().points.front()) {
            // The last part goes on as the first.
            SurfacePolyline joined = std::move(lines.back());
            lines.pop_back();
            const SurfacePolyline& first = lines.front();
            joined.points.insert(
                joined.points.end(), std::next(first.points.begin()), first.points.end()
            );
            joined.surfacePoints.insert(
                joined.surfacePoints.end(),
                std::next(first.surfacePoints.begin()),
                first.surfacePoints.end()
            );
            lines.front() = std::move(joined);
        }
        for (SurfacePolyline& line : lines) {
            setParametersByLength(line);
        }
    }

    const Surface& surface_;
    const TriangleTree& tree_;
    Vec3 direction_;
    double distance_, edge_;
    GeodesicPathFinder paths_;
    Vec3 middle_;
    double radius_ = 0.0;
    std::size_t vertex_ = 0;  // the one behind which we are
    SurfacePolyline line_;    // so far
    bool isLastKept_ = false;
    int ends_ = 0;  // of lines so far
    ProjectedLines result_;
};

}  // namespace

ProjectedLines drapedPolyline(
    const Surface& surface,
    const TriangleTree& tree,
    const SpacePolyline& line,
    const Vec3& direction,
    double distance
) {
    return Draper(surface, tree, direction, distance).drape(line);
}

}  // namespace bspline_curve
