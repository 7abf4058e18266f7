// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/drawing.h"

#include "offset/face_layout.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace bspline_curve {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double kQuarterTurn = std::numbers::pi / 2;
/// Parts of an arc that are looked at for its outermost points.
constexpr int kBoxSteps = 16;
/// Arcs that are shorter, in the size of their drawing, are rounding: on the surface picks would
/// coincide.
constexpr double kSpeckRelative = 1e-6;
/// Each narrows the place of an outermost point to two thirds.
constexpr int kBoxNarrowings = 40;

/// The unit direction from the first point to the first one elsewhere.
template <class Iterator>
Vec2 directionAlong(const Iterator& first, const Iterator& last) {
    for (auto next = first; next != last; ++next) {
        if (*next != *first) {
            return (*next - *first).normalized();
        }
    }
    return Vec2::Zero();
}

/// Extends a box to where an arc is outermost in a direction, between two parameters.
void extendOutwards(
    Eigen::AlignedBox2d& box, const DrawingArc& arc, const Vec2& outwards, double low, double high
) {
    for (int i = 0; i < kBoxNarrowings; ++i) {
        const double third = (high - low) / 3.0;
        const bool isLater = arc.at(low + third).dot(outwards) < arc.at(high - third).dot(outwards);
        (isLater ? low : high) += isLater ? third : -third;
    }
    box.extend(arc.at(0.5 * (low + high)));
}

void extendBy(Eigen::AlignedBox2d& box, const DrawingArc& arc) {
    box.extend(arc.points.front());
    box.extend(arc.points.back());
    if (arc.isLine()) {
        return;
    }
    for (const Vec2& outwards :
         {Vec2(Vec2::UnitX()), Vec2(-Vec2::UnitX()), Vec2(Vec2::UnitY()), Vec2(-Vec2::UnitY())}) {
        int outermost = 0;
        for (int i = 1; i <= kBoxSteps; ++i) {
            const auto reach = [&](int step) {
                return arc.at(static_cast<double>(step) / kBoxSteps).dot(outwards);
            };
            outermost = reach(i) > reach(outermost) ? i : outermost;
        }
        const double low = static_cast<double>(std::max(outermost - 1, 0)) / kBoxSteps;
        const double high = static_cast<double>(std::min(outermost + 1, kBoxSteps)) / kBoxSteps;
        extendOutwards(box, arc, outwards, low, high);
    }
}

double turnBetween(const DrawingArc& before, const DrawingArc& after) {
    return std::abs(angleBetween(before.endDirection(), after.startDirection()));
}

/// The indices of the arcs that begin in a corner.
std::vector<std::size_t> cornersOf(
    const std::vector<DrawingArc>& arcs, bool closed, double cornerAngle
) {
    std::vector<std::size_t> corners;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
        const DrawingArc& before = arcs[i > 0 ? i - 1 : arcs.size() - 1];
        const bool isStart = i == 0 && !closed;
        if (isStart || turnBetween(before, arcs[i]) > cornerAngle) {
            corners.push_back(i);
        }
    }
    return corners;
}

/// The arcs of a path that reach farther than a distance; their ends still meet.
std::vector<DrawingArc> withoutSpecks(const DrawingPath& path, double distance) {
    const auto isSpeck = [&](const DrawingArc& arc) {
        return std::ranges::all_of(arc.points, [&](const Vec2& point) {
            return (point - arc.points.front()).norm() <= distance;
        });
    };
    std::vector<DrawingArc> arcs;
    for (const DrawingArc& arc : path.arcs) {
        if (!isSpeck(arc)) {
            arcs.push_back(arc);
            if (arcs.size() > 1) {
                arcs.back().points.front() = arcs[arcs.size() - 2].points.back();
            }
        }
    }
    if (path.closed && !arcs.empty()) {
        arcs.back().points.back() = arcs.front().points.front();
    }
    return arcs;
}

}  // namespace

Vec2 DrawingArc::at(double t) const {
    // De Casteljau's algorithm, in homogeneous coordinates.
    std::vector<Eigen::Vector3d> level;
    level.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double weight = weights.empty() ? 1.0 : weights[i];
        level.emplace_back(weight * points[i].x(), weight * points[i].y(), weight);
    }
    for (std::size_t count = level.size() - 1; count > 0; --count) {
        for (std::size_t i = 0; i < count; ++i) {
            level[i] = (1.0 - t) * level[i] + t * level[i + 1];
        }
    }
    return level[0].head<2>() / level[0].z();
}

Vec2 DrawingArc::startDirection() const {
    return directionAlong(points.begin(), points.end());
}

Vec2 DrawingArc::endDirection() const {
    return -directionAlong(points.rbegin(), points.rend());
}

Eigen::AlignedBox2d Drawing::box() const {
    Eigen::AlignedBox2d box;
    for (const DrawingPath& path : paths) {
        for (const DrawingArc& arc : path.arcs) {
            extendBy(box, arc);
        }
    }
    return box;
}

bool isUsablePath(const DrawingPath& path) {
    return std::ranges::all_of(path.arcs, [](const DrawingArc& arc) {
        return std::ranges::all_of(arc.points, [](const Vec2& point) {
            return point.cwiseAbs().maxCoeff() <= kLargestDrawingCoordinate && point.allFinite();
        });
    });
}

std::vector<DrawingArc> ellipticalArc(
    const Vec2& centre, const Vec2& right, const Vec2& up, double from, double sweep
) {
    const int count =
        std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / kQuarterTurn - 1e-9)));
    const double half = 0.5 * sweep / count;
    const auto onEllipse = [&](double angle, double radius) {
        return Vec2(centre + radius * (std::cos(angle) * right + std::sin(angle) * up));
    };
    std::vector<DrawingArc> arcs;
    for (int i = 0; i < count; ++i) {
        const double start = from + 2 * i * half;
        const Vec2 first = arcs.empty() ? onEllipse(start, 1.0) : arcs.back().points.back();
        arcs.push_back(
            {.points =
                 {first,
                  onEllipse(start + half, 1.0 / std::cos(half)),
                  onEllipse(start + 2 * half, 1.0)},
             .weights = {1.0, std::cos(half), 1.0}}
        );
    }
    if (std::abs(sweep) == 2 * std::numbers::pi) {
        arcs.back().points.back() = arcs.front().points.front();
    }
    return arcs;
}

Drawing mapped(Drawing drawing, const Eigen::Affine2d& map) {
    for (DrawingPath& path : drawing.paths) {
        for (DrawingArc& arc : path.arcs) {
            for (Vec2& point : arc.points) {
                point = map * point;
            }
        }
    }
    return drawing;
}

Vec2 SmoothPiece::at(double parameter) const {
    const std::size_t index =
        std::min(static_cast<std::size_t>(std::max(parameter, 0.0)), arcs.size() - 1);
    const double t = parameter - static_cast<double>(index);
    // Ends are what they are, whatever the rounding.
    if (t == 0.0) {
        return arcs[index].points.front();
    }
    return t == 1.0 ? arcs[index].points.back() : arcs[index].at(t);
}

std::vector<SmoothPiece> smoothPieces(const Drawing& drawing, double cornerAngle) {
    std::vector<SmoothPiece> pieces;
    const Eigen::AlignedBox2d box = drawing.box();
    const double least = box.isEmpty() ? 0.0 : kSpeckRelative * box.diagonal().norm();
    for (std::size_t p = 0; p < drawing.paths.size(); ++p) {
        const DrawingPath& path = drawing.paths[p];
        std::vector<DrawingArc> arcs = withoutSpecks(path, least);
        if (arcs.empty()) {
            continue;
        }
        const std::vector<std::size_t> corners = cornersOf(arcs, path.closed, cornerAngle);
        if (corners.empty()) {
            pieces.push_back(
                {.arcs = std::move(arcs), .closed = true, .path = static_cast<int>(p)}
            );
            continue;
        }
        for (std::size_t c = 0; c < corners.size(); ++c) {
            const std::size_t first = corners[c];
            const std::size_t last = c + 1 < corners.size()
                                         ? corners[c + 1]
                                         : arcs.size() + (path.closed ? corners.front() : 0);
            SmoothPiece piece{.arcs = {}, .closed = false, .path = static_cast<int>(p)};
            for (std::size_t i = first; i < last; ++i) {
                piece.arcs.push_back(arcs[i % arcs.size()]);
            }
            pieces.push_back(std::move(piece));
        }
    }
    return pieces;
}

}  // namespace bspline_curve
