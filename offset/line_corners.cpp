// SPDX-License-Identifier: GPL-3.0-or-later
#include "offset/line_corners.h"

#include "surface/surface_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace bspline_curve {

namespace {

/// A line turns by this much at a corner, in radians, ...
constexpr double kCornerTurn = 20.0 / 180.0 * std::numbers::pi;
/// ... within so many distances of it, on either side.
constexpr double kCornerReach = 0.02;

class CornerFinder {
public:
    CornerFinder(const Surface& surface, const LevelLine& line, double distance)
        : surface_(surface), line_(line), reach_(kCornerReach * distance) {
        const std::size_t count = line.points.size();
        for (std::size_t i = 0; i < count; ++i) {
            positions_.push_back(surface.position(line.points[i]));
        }
        for (std::size_t i = 0; i < count; ++i) {
            lengths_.push_back((positions_[(i + 1) % count] - positions_[i]).norm());
        }
        for (std::size_t i = 0; i < count; ++i) {
            const bool isEnd = !line.closed && (i == 0 || i + 1 == count);
            turns_.push_back(isEnd ? 0.0 : turnAt(i));
        }
    }

    /// Indices of the points at corners, ascending.
    [[nodiscard]] std::vector<std::size_t> corners() const {
        const std::size_t count = turns_.size();
        std::vector<TurnAround> around;
        for (std::size_t i = 0; i < count; ++i) {
            around.push_back(turnAround(i));
        }
        std::vector<std::size_t> found;
        std::vector<char> isTaken(count, 0);
        // The sharpest first; none within reach of another.
        std::vector<std::size_t> order(count);
        for (std::size_t i = 0; i < count; ++i) {
            order[i] = i;
        }
        std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
            return around[a].weighted > around[b].weighted;
        });
        for (const std::size_t i : order) {
            if (around[i].whole >= kCornerTurn && isTaken[i] == 0 && turns_[i] > 0.0) {
                found.push_back(i);
                forEachWithin(i, 2.0 * reach_, [&](std::size_t near, double) {
                    isTaken[near] = 1;
                });
            }
        }
        std::ranges::sort(found);
        return found;
    }

private:
    /// How much the line turns within reach of a point.
    struct TurnAround {
        double whole = 0.0;
        double weighted = 0.0;  ///< by nearness: largest at the corner itself
    };

    /// How much the line turns left at a point, with the faces there laid in one plane.
    [[nodiscard]] double turnAt(std::size_t i) const {
        const std::size_t count = positions_.size();
        const std::size_t before = (i + count - 1) % count;
        const std::size_t after = (i + 1) % count;
        const Vec3 in = positions_[i] - positions_[before];
        const Vec3 out = positions_[after] - positions_[i];
        const int from = commonFace(surface_, line_.points[before], line_.points[i]);
        const int to = commonFace(surface_, line_.points[i], line_.points[after]);
        if (from < 0 || to < 0 || in.norm() == 0.0 || out.norm() == 0.0) {
            return 0.0;
        }
        // An axis in both faces: their common side, else the way in.
        Vec3 axis = in;
        for (int k = 0; from != to && k < 3; ++k) {
            if (surface_.faceNeighbours()[from][k] == to) {
                const Triangle& face = surface_.faces()[from];
                axis =
                    surface_.vertices()[face[(k + 2) % 3]] - surface_.vertices()[face[(k + 1) % 3]];
            }
        }
        const double turn = angleTo(out, axis, to) - angleTo(in, axis, from);
        return std::remainder(turn, 2.0 * std::numbers::pi);
    }

    /// The angle from an axis to a direction, counter-clockwise seen from outside.
    [[nodiscard]] double angleTo(const Vec3& direction, const Vec3& axis, int face) const {
        const Triangle& corners = surface_.faces()[face];
        const Vec3& a = surface_.vertices()[corners[0]];
        const Vec3 normal = (surface_.vertices()[corners[1]] - a)
                                .cross(surface_.vertices()[corners[2]] - a)
                                .normalized();
        return std::atan2(normal.cross(axis).dot(direction), axis.dot(direction));
    }

    /// Calls `use` with the points within `reach` of point i along the line, itself among them,
    /// and with the way to each.
    template <class Use>
    void forEachWithin(std::size_t i, double reach, const Use& use) const {
        const std::size_t count = positions_.size();
        use(i, 0.0);
        double way = 0.0;
        std::size_t steps = 0;
        for (std::size_t at = i; ++steps < count && (line_.closed || at + 1 < count);) {
            way += lengths_[at];
            at = (at + 1) % count;
            if (way > reach) {
                break;
            }
            use(at, way);
        }
        way = 0.0;
        steps = 0;
        for (std::size_t at = i; ++steps < count && (line_.closed || at > 0);) {
            at = (at + count - 1) % count;
            way += lengths_[at];
            if (way > reach) {
                break;
            }
            use(at, way);
        }
    }

    [[nodiscard]] TurnAround turnAround(std::size_t i) const {
        TurnAround around;
        forEachWithin(i, reach_, [&](std::size_t at, double way) {
            around.whole += turns_[at];
            around.weighted += (1.0 - way / reach_) * turns_[at];
        });
        return around;
    }

    const Surface& surface_;
    const LevelLine& line_;
    double reach_;
    std::vector<Vec3> positions_;
    std::vector<double> lengths_;  // to the next point
    std::vector<double> turns_;    // to the left, away from the curve
};

/// The points from one index to another, around where the line is closed.
LevelLine partOf(const LevelLine& line, std::size_t from, std::size_t to) {
    LevelLine part;
    const std::size_t count = line.points.size();
    for (std::size_t i = from;; i = (i + 1) % count) {
        part.points.push_back(line.points[i]);
        part.sides.push_back(line.sides[i]);
        if (i == to && part.points.size() > 1) {
            return part;
        }
    }
}

}  // namespace

std::vector<LevelLine> cutAtCorners(
    const Surface& surface, const LevelLine& line, double distance
) {
    std::vector<std::size_t> cuts = CornerFinder(surface, line, distance).corners();
    if (cuts.empty()) {
        return {line};
    }
    if (!line.closed) {
        cuts.insert(cuts.begin(), 0);
        cuts.push_back(line.points.size() - 1);
    } else {
        cuts.push_back(cuts.front());
    }
    std::vector<LevelLine> parts;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        parts.push_back(partOf(line, cuts[i], cuts[i + 1]));
    }
    return parts;
}

}  // namespace bspline_curve
