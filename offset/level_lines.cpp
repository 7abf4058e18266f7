// SPDX-License-Identifier: GPL-3.0-or-later
#include "offset/level_lines.h"

#include "bspline_curve/progress.h"
#include "offset/face_layout.h"
#include "surface/line_simplification.h"
#include "surface/surface_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace bspline_curve {

namespace {

/// Halvings that find a point between two nodes of a grid: to 2^-45 of their distance.
constexpr int kHalvings = 45;
/// More rows of small triangles in one face would take minutes.
constexpr int kMostRows = 512;

/// Of the radius of a block: its corners are not left out by rounding.
constexpr double kRounding = 1.0 + 1e-6;

/// Progress is reported after so many faces, ...
constexpr std::size_t kFacesPerReport = 1024;
/// ... all of which are this much of it.
constexpr double kFacesShare = 0.5;

/// A node of the grids that faces are divided by: at a vertex (vertex, -1, 0, 0), on an edge (low
/// and high vertex, step from low) or in a face (-1 - face, -1, row, column). The same from every
/// face that holds it.
using Node = std::array<int, 4>;

class GridLines {
public:
    GridLines(const Surface& surface, const DistanceBeams& beams, double distance, int rows)
        : surface_(surface), beams_(beams), distance_(distance), rows_(rows) {}

    void addFace(int face) {
        cells_.clear();
        collectCells(face, {0, 0}, {rows_, rows_});
        std::ranges::sort(cells_);
        for (const auto& [i, j] : cells_) {
            addTriangle(face, {{{i, j}, {i + 1, j}, {i, j + 1}}});
            if (i + j + 1 < rows_) {
                addTriangle(face, {{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}});
            }
        }
    }

    std::vector<LevelLine> chained() {
        std::vector<int> next(points_.size(), -1);
        std::vector<char> hasPrevious(points_.size(), 0);
        for (const auto& [from, to] : segments_) {
            next[from] = to;
            hasPrevious[to] = 1;
        }
        std::vector<LevelLine> lines;
        std::vector<char> done(points_.size(), 0);
        const auto follow = [&](int start, bool closed) {
            LevelLine line;
            line.closed = closed;
            for (int at = start; at >= 0 && done[at] == 0; at = next[at]) {
                done[at] = 1;
                line.points.push_back(points_[at]);
                line.sides.push_back(sides_[at]);
            }
            lines.push_back(std::move(line));
        };
        for (const bool closed : {false, true}) {
            for (int at = 0; at < static_cast<int>(points_.size()); ++at) {
                if (done[at] == 0 && (closed || hasPrevious[at] == 0)) {
                    follow(at, closed);
                }
            }
        }
        return lines;
    }

private:
    // Of a corner: barycentric steps (i, j), and rows - i - j of the third. A cell begins at one,
    // and consists of the two triangles beyond it, or of one at the end of a row.
    using Step = std::array<int, 2>;

    // The cells from one step to another through which a line may pass.
    void collectCells(int face, const Step& from, const Step& to) {
        const Step size{to[0] - from[0], to[1] - from[1]};
        if (from[0] + from[1] >= rows_ || size[0] == 0 || size[1] == 0) {
            return;
        }
        if (size[0] == 1 && size[1] == 1) {
            cells_.push_back(from);
            return;
        }
        if (isOnOneSide(face, from, to)) {
            return;
        }
        const Step middle{from[0] + size[0] / 2, from[1] + size[1] / 2};
        collectCells(face, from, middle);
        collectCells(face, {from[0], middle[1]}, {middle[0], to[1]});
        collectCells(face, {middle[0], from[1]}, {to[0], middle[1]});
        collectCells(face, middle, to);
    }

    // Whether all points of the cells from one step to another are nearer, or all farther.
    [[nodiscard]] bool isOnOneSide(int face, const Step& from, const Step& to) const {
        const Triangle& corners = surface_.faces()[face];
        const Vec3& origin = surface_.vertices()[corners[2]];
        const double perStep = 0.5 / rows_;
        const Vec3 a = perStep * (to[0] - from[0]) * (surface_.vertices()[corners[0]] - origin);
        const Vec3 b = perStep * (to[1] - from[1]) * (surface_.vertices()[corners[1]] - origin);
        const double radius = kRounding * std::max((a + b).norm(), (a - b).norm());
        const double i = perStep * (from[0] + to[0]);
        const double j = perStep * (from[1] + to[1]);
        const SurfacePoint centre{.face = face, .barycentric = Vec3(i, j, 1.0 - i - j)};
        // Distances change by no more than the way.
        return (i + j < 1.0 && beams_.at(centre).distance + radius < distance_) ||
               beams_.leastNear(centre, radius) > distance_;
    }

    [[nodiscard]] SurfacePoint pointOf(int face, const Step& step) const {
        const int k = rows_ - step[0] - step[1];
        return {
            .face = face, .barycentric = Vec3(step[0], step[1], k) / static_cast<double>(rows_)
        };
    }

    [[nodiscard]] Node nodeOf(int face, const Step& step) const {
        const Triangle& corners = surface_.faces()[face];
        const std::array<int, 3> steps{step[0], step[1], rows_ - step[0] - step[1]};
        for (int k = 0; k < 3; ++k) {
            if (steps[k] == rows_) {
                return {corners[k], -1, 0, 0};
            }
        }
        for (int k = 0; k < 3; ++k) {
            if (steps[k] == 0) {
                const int a = corners[(k + 1) % 3];
                const int b = corners[(k + 2) % 3];
                return a < b ? Node{a, b, steps[(k + 2) % 3], 0}
                             : Node{b, a, steps[(k + 1) % 3], 0};
            }
        }
        return {-1 - face, -1, step[0], step[1]};
    }

    bool isInside(int face, const Step& step) {
        const auto [entry, isNew] = inside_.try_emplace(nodeOf(face, step), false);
        if (isNew) {
            entry->second = beams_.at(pointOf(face, step)).distance < distance_;
        }
        return entry->second;
    }

    /// Index of the point at the distance between a node inside and one outside.
    int crossing(int face, const Step& inside, const Step& outside) {
        const auto key = std::pair(nodeOf(face, inside), nodeOf(face, outside));
        const auto [entry, isNew] = crossings_.try_emplace(key, static_cast<int>(points_.size()));
        if (isNew) {
            SurfacePoint in = pointOf(face, inside);
            SurfacePoint out = pointOf(face, outside);
            CurveSide side = beams_.at(in).side;
            for (int halving = 0; halving < kHalvings; ++halving) {
                const SurfacePoint middle{
                    .face = face, .barycentric = 0.5 * (in.barycentric + out.barycentric)
                };
                const SidedDistance there = beams_.at(middle);
                if (there.distance < distance_) {
                    in = middle;
                    side = there.side;
                } else {
                    out = middle;
                }
            }
            points_.push_back(in);
            sides_.push_back(side);
        }
        return entry->second;
    }

    void addTriangle(int face, const std::array<Step, 3>& steps) {
        std::array<bool, 3> inside{};
        int count = 0;
        for (int k = 0; k < 3; ++k) {
            inside[k] = isInside(face, steps[k]);
            count += inside[k] ? 1 : 0;
        }
        if (count == 0 || count == 3) {
            return;
        }
        // The corner that is alone; the inside is to the right of the segment.
        int alone = 0;
        while (inside[alone] != (count == 1)) {
            ++alone;
        }
        const Step& corner = steps[alone];
        const Step& next = steps[(alone + 1) % 3];
        const Step& last = steps[(alone + 2) % 3];
        if (count == 1) {
            const int from = crossing(face, corner, last);
            const int to = crossing(face, corner, next);
            segments_.emplace_back(from, to);
        } else {
            const int from = crossing(face, next, corner);
            const int to = crossing(face, last, corner);
            segments_.emplace_back(from, to);
        }
    }

    const Surface& surface_;
    const DistanceBeams& beams_;
    double distance_;
    int rows_;
    std::vector<Step> cells_;  // of one face
    std::map<Node, bool> inside_;
    std::map<std::pair<Node, Node>, int> crossings_;
    std::vector<SurfacePoint> points_;
    std::vector<CurveSide> sides_;
    std::vector<std::pair<int, int>> segments_;
};

}  // namespace

namespace {

/// Segments whose middle is nearer to the level than this are not divided (relative to the
/// distance).
constexpr double kLevelTolerance = 2e-4;
/// Grids have more points than lines need. Those in a face are left out that lie nearer to the
/// segment between others than this (likewise).
constexpr double kThinTolerance = 2e-5;
/// Halvings of one segment at most; corners where two arcs meet need most of them.
constexpr int kMostDivisions = 12;

/// A corner of the level is at most this deep, in lengths of the segment that cuts it off.
constexpr double kCornerDepth = 4.0;

/// A line without points that it does not need. Those on sides of faces stay, so that consecutive
/// ones share a face, and those beside which the side of the curve changes.
LevelLine thinned(const Surface& surface, const LevelLine& line, double distance) {
    const auto count = static_cast<int>(line.points.size());
    std::vector<Vec3> positions;
    std::vector<int> kept;
    for (int i = 0; i < count; ++i) {
        positions.push_back(surface.position(line.points[i]));
        const bool isEnd = i == 0 || i + 1 == count;
        if (isEnd || line.points[i].barycentric.minCoeff() <= kOnEdgeBarycentric ||
            line.sides[i] != line.sides[i - 1] || line.sides[i] != line.sides[i + 1]) {
            kept.push_back(i);
        }
    }
    LevelLine result{.closed = line.closed, .points = {}, .sides = {}};
    for (const int i : simplified(positions, std::move(kept), kThinTolerance * distance)) {
        result.points.push_back(line.points[i]);
        result.sides.push_back(line.sides[i]);
    }
    return result;
}

/// Adds points between those of a line where its segments leave the level: along arcs, and at the
/// corners where ways from two sides meet.
class LineRefiner {
public:
    LineRefiner(const Surface& surface, const DistanceBeams& beams, double distance)
        : surface_(surface), beams_(beams), distance_(distance) {}

    [[nodiscard]] LevelLine refined(const LevelLine& line) {
        result_ = {.closed = line.closed, .points = {}, .sides = {}};
        const std::size_t count = line.points.size();
        for (std::size_t i = 0; i < count; ++i) {
            result_.points.push_back(line.points[i]);
            result_.sides.push_back(line.sides[i]);
            if (i + 1 < count || line.closed) {
                const SurfacePoint& next = line.points[(i + 1) % count];
                const int face = commonFace(surface_, line.points[i], next);
                divide(inFace(surface_, line.points[i], face), inFace(surface_, next, face), 0);
            }
        }
        return std::move(result_);
    }

private:
    void divide(const SurfacePoint& from, const SurfacePoint& to, int depth) {
        const SurfacePoint middle{
            .face = from.face, .barycentric = 0.5 * (from.barycentric + to.barycentric)
        };
        const double error = beams_.at(middle).distance - distance_;
        if (depth >= kMostDivisions || std::abs(error) <= kLevelTolerance * distance_) {
            return;
        }
        // The curve is to the right: too far, the level is there; too near, it is to the left.
        const FaceLayout layout(surface_.vertices(), surface_.faces()[from.face], 0);
        const Eigen::Vector2d along =
            layout.position(to.barycentric) - layout.position(from.barycentric);
        const Eigen::Vector2d aside = (error > 0 ? -1.0 : 1.0) * turnedLeft(along);
        const Vec3 step = barycentricStep(layout, aside);
        double reach = kCornerDepth;
        for (int k = 0; k < 3; ++k) {
            if (step[k] < 0) {
                reach = std::min(reach, middle.barycentric[k] / -step[k]);
            }
        }
        SurfacePoint low = middle;
        SurfacePoint high{
            .face = from.face, .barycentric = (middle.barycentric + reach * step).cwiseMax(0.0)
        };
        high.barycentric /= high.barycentric.sum();
        const bool wasInside = error < 0;
        if ((beams_.at(high).distance < distance_) == wasInside) {
            divideAcross(from, to, high, wasInside, depth);
            return;
        }
        SidedDistance found;
        for (int halving = 0; halving < kHalvings; ++halving) {
            const SurfacePoint half{
                .face = from.face, .barycentric = 0.5 * (low.barycentric + high.barycentric)
            };
            found = beams_.at(half);
            ((found.distance < distance_) == wasInside ? low : high) = half;
        }
        divide(from, low, depth + 1);
        result_.points.push_back(low);
        result_.sides.push_back(found.side);
        divide(low, to, depth + 1);
    }

    /// Where a corner of the level reaches over a side of the face, at `beyond`: goes to that side,
    /// through the neighbour and back.
    void divideAcross(
        const SurfacePoint& from,
        const SurfacePoint& to,
        const SurfacePoint& beyond,
        bool wasInside,
        int depth
    ) {
        int side = 0;
        beyond.barycentric.minCoeff(&side);
        const int across = surface_.faceNeighbours()[from.face][side];
        if (across < 0 || beyond.barycentric[side] > kOnEdgeBarycentric) {
            return;
        }
        SurfacePoint foot = beyond;
        foot.barycentric[side] = 0.0;
        const FaceLayout layout(surface_.vertices(), surface_.faces()[from.face], 0);
        const Eigen::Vector2d chord =
            layout.position(to.barycentric) - layout.position(from.barycentric);
        const Eigen::Vector2d edge =
            layout.corners[(side + 2) % 3] - layout.corners[(side + 1) % 3];
        // Along the side, once towards `from` and once towards `to`.
        std::array<SurfacePoint, 2> ends;
        std::array<CurveSide, 2> sides{};
        for (const int end : {0, 1}) {
            const bool forwards = (chord.dot(edge) > 0) == (end == 1);
            const int towards = (side + (forwards ? 2 : 1)) % 3;
            const int away = (side + (forwards ? 1 : 2)) % 3;
            const double step = std::min(chord.norm() / edge.norm(), foot.barycentric[away]);
            SurfacePoint low = foot;
            SurfacePoint high = foot;
            high.barycentric[towards] += step;
            high.barycentric[away] -= step;
            if ((beams_.at(high).distance < distance_) == wasInside) {
                return;
            }
            for (int halving = 0; halving < kHalvings; ++halving) {
                const SurfacePoint half{
                    .face = from.face, .barycentric = 0.5 * (low.barycentric + high.barycentric)
                };
                const SidedDistance found = beams_.at(half);
                sides[end] = found.side;
                ((found.distance < distance_) == wasInside ? low : high) = half;
            }
            ends[end] = low;
        }
        divide(from, ends[0], depth + 1);
        result_.points.push_back(ends[0]);
        result_.sides.push_back(sides[0]);
        divide(inFace(surface_, ends[0], across), inFace(surface_, ends[1], across), depth + 1);
        result_.points.push_back(ends[1]);
        result_.sides.push_back(sides[1]);
        divide(ends[1], to, depth + 1);
    }

    [[nodiscard]] static Vec3 barycentricStep(
        const FaceLayout& layout, const Eigen::Vector2d& step
    ) {
        const Eigen::Vector2d a = layout.corners[1] - layout.corners[0];
        const Eigen::Vector2d b = layout.corners[2] - layout.corners[0];
        const double area = cross(a, b);
        const double second = cross(step, b) / area;
        const double third = cross(a, step) / area;
        return {-second - third, second, third};
    }

    const Surface& surface_;
    const DistanceBeams& beams_;
    double distance_;
    LevelLine result_;
};

}  // namespace

std::vector<LevelLine> levelLines(
    const Surface& surface,
    const DistanceBeams& beams,
    double distance,
    double stepRelative,
    const Progress& progress
) {
    const auto show = [&](double fraction) {
        report(progress, fraction, "drawing lines at the distance");
    };
    show(0.0);
    // Distances change by no more than the way, so that few faces can hold a line.
    std::vector<int> faces;
    double longest = 0.0;
    for (const int f : beams.reachedFaces()) {
        const FaceLayout layout(surface.vertices(), surface.faces()[f], 0);
        const Vec3 middle = Vec3::Constant(1.0 / 3.0);
        const double nearest = beams.at({.face = f, .barycentric = middle}).distance;
        if (nearest + layout.size() >= distance) {
            faces.push_back(f);
            longest = std::max(longest, layout.size());
        }
    }
    const double rows = std::ceil(longest / (stepRelative * distance));
    GridLines lines(
        surface, beams, distance, static_cast<int>(std::clamp(rows, 1.0, 1.0 * kMostRows))
    );
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (i % kFacesPerReport == 0) {
            show(kFacesShare * static_cast<double>(i) / static_cast<double>(faces.size()));
        }
        lines.addFace(faces[i]);
    }
    std::vector<LevelLine> result = lines.chained();
    LineRefiner refiner(surface, beams, distance);
    for (std::size_t i = 0; i < result.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(result.size());
        show(std::lerp(kFacesShare, 1.0, share));
        result[i] = refiner.refined(thinned(surface, result[i], distance));
    }
    return result;
}

}  // namespace bspline_curve
