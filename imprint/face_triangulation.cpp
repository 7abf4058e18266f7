// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/face_triangulation.h"

#include "surface/plane_vectors.h"
#include "surface/predicates.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>

namespace bspline_curve {

namespace {

/// A side is flipped where that gains more than rounding could feign: the sine of the two opposite
/// angles' sum.
constexpr double kDelaunayMargin = 1e-9;

}  // namespace

void FaceTriangulation::start(const Vec3& corner0, const Vec3& corner1, const Vec3& corner2) {
    const Vec3 first = corner1 - corner0;
    const Vec3 second = corner2 - corner0;
    const Vec3 axis = first.normalized();
    first_ = {first.norm(), 0.0};
    second_ = {second.dot(axis), first.cross(second).norm() / first.norm()};
    places_ = {FacePlace(0, 0, 0), FacePlace(1, 0, 0), FacePlace(0, 1, 0)};
    flat_ = {Eigen::Vector2d::Zero(), first_, second_};
    cellOf_ = {0, 0, 0};
    cells_.clear();
    cells_.push_back({.points = {0, 1, 2}});
}

int FaceTriangulation::turn(int a, int b, int c) const {
    constexpr int kDropped = 2;
    return projectedOrientationSign(places_[a], places_[b], places_[c], kDropped);
}

int FaceTriangulation::addCell() {
    cells_.push_back({.points = {-1, -1, -1}});
    return static_cast<int>(cells_.size()) - 1;
}

void FaceTriangulation::setCell(
    int cell, const Triangle& points, const std::array<Border, 3>& borders
) {
    cells_[cell].points = points;
    cells_[cell].borders = borders;
    for (int k = 0; k < 3; ++k) {
        cellOf_[points[k]] = cell;
        const Side beyond = borders[k].beyond;
        if (beyond.cell >= 0) {
            cells_[beyond.cell].borders[beyond.k] = {{cell, k}, borders[k].isSegment};
        }
    }
}

int FaceTriangulation::addPoint(const FacePlace& place) {
    const int point = static_cast<int>(places_.size());
    places_.push_back(place);
    flat_.emplace_back(place.x() * first_ + place.y() * second_);
    cellOf_.push_back(-1);
    const int cell = locate(point);
    const Triangle& points = cells_[cell].points;
    int side = -1;
    for (int k = 0; k < 3; ++k) {
        if (turn(points[(k + 1) % 3], points[(k + 2) % 3], point) == 0) {
            side = k;
        }
    }
    if (side >= 0) {
        splitSide({cell, side}, point);
    } else {
        splitCell(cell, point);
    }
    std::vector<Side> suspects;
    for (const Side around : sidesAround(point)) {
        suspects.push_back({around.cell, (around.k + 1) % 3});  // opposite to the point
    }
    restoreDelaunay(std::move(suspects));
    return point;
}

/// A cell that holds a point, its sides included: a walk across sides that the point is beyond of,
/// from the newest cell. In a triangulation that is nearly Delaunay it comes to an end; where it
/// takes more steps than there are cells, all are tried.
int FaceTriangulation::locate(int point) const {
    const auto count = static_cast<int>(cells_.size());
    const auto sideBefore = [&](int cell) {
        const Triangle& points = cells_[cell].points;
        for (int k = 0; k < 3; ++k) {
            if (turn(points[(k + 1) % 3], points[(k + 2) % 3], point) < 0) {
                return k;
            }
        }
        return -1;
    };
    int cell = count - 1;
    for (int steps = 0; steps <= count; ++steps) {
        const int k = sideBefore(cell);
        if (k < 0) {
            return cell;
        }
        cell = border({cell, k}).beyond.cell;
        if (cell < 0) {
            break;
        }
    }
    for (cell = 0; cell < count; ++cell) {
        if (sideBefore(cell) < 0) {
            return cell;
        }
    }
    throw std::logic_error("a point of a face's triangulation lies outside of the face");
}

void FaceTriangulation::splitCell(int cell, int point) {
    const auto [a, b, c] = cells_[cell].points;
    const auto [beyondA, beyondB, beyondC] = cells_[cell].borders;
    const int second = addCell();
    const int third = addCell();
    setCell(cell, {point, b, c}, {beyondA, {{second, 2}}, {{third, 1}}});
    setCell(second, {point, c, a}, {beyondB, {{third, 2}}, {{cell, 1}}});
    setCell(third, {point, a, b}, {beyondC, {{cell, 2}}, {{second, 1}}});
}

void FaceTriangulation::splitSide(Side side, int point) {
    const auto [cell, k] = side;
    const int apex = cells_[cell].points[k];
    const int from = cells_[cell].points[(k + 1) % 3];
    const int to = cells_[cell].points[(k + 2) % 3];
    const Border old = cells_[cell].borders[k];
    const Border last = cells_[cell].borders[(k + 1) % 3];   // from `to` to the apex
    const Border first = cells_[cell].borders[(k + 2) % 3];  // from the apex to `from`
    const int half = addCell();
    setCell(cell, {apex, from, point}, {Border{{}, old.isSegment}, {{half, 2}}, first});
    setCell(half, {apex, point, to}, {Border{{}, old.isSegment}, last, {{cell, 1}}});
    if (old.beyond.cell < 0) {
        return;
    }
    const auto [other, j] = old.beyond;
    const int peak = cells_[other].points[j];
    const Border nearFrom = cells_[other].borders[(j + 1) % 3];  // from `from` to the peak
    const Border nearTo = cells_[other].borders[(j + 2) % 3];    // from the peak to `to`
    const int otherHalf = addCell();
    setCell(other, {peak, to, point}, {Border{{half, 0}, old.isSegment}, {{otherHalf, 2}}, nearTo});
    setCell(
        otherHalf, {peak, point, from}, {Border{{cell, 0}, old.isSegment}, nearFrom, {{other, 1}}}
    );
}

/// The sides that lead away from a point, one in each of its cells.
std::vector<FaceTriangulation::Side> FaceTriangulation::sidesAround(int point) const {
    const auto leaving = [&](int cell) {
        const Triangle& points = cells_[cell].points;
        const int at = points[0] == point ? 0 : (points[1] == point ? 1 : 2);
        return Side{cell, (at + 2) % 3};
    };
    std::vector<Side> sides{leaving(cellOf_[point])};
    const int start = sides[0].cell;
    // Counter-clockwise, until once round or at the border; then clockwise from the start.
    for (;;) {
        const Side arriving{sides.back().cell, (sides.back().k + 2) % 3};
        const int next = border(arriving).beyond.cell;
        if (next == start) {
            return sides;
        }
        if (next < 0) {
            break;
        }
        sides.push_back(leaving(next));
    }
    for (Side side = sides[0];;) {
        const int next = border(side).beyond.cell;
        if (next < 0) {
            return sides;
        }
        side = leaving(next);
        sides.push_back(side);
    }
}

FaceTriangulation::Side FaceTriangulation::findSide(int a, int b) const {
    for (const Side side : sidesAround(a)) {
        if (cells_[side.cell].points[(side.k + 2) % 3] == b) {
            return side;
        }
        const Side arriving{side.cell, (side.k + 2) % 3};
        if (cells_[side.cell].points[side.k] == b) {
            const Side beyond = border(arriving).beyond;
            return beyond.cell >= 0 ? beyond : arriving;
        }
    }
    return {};
}

/// Whether the two cells at a side are a strictly convex quadrilateral.
bool FaceTriangulation::isConvex(Side side) const {
    const Side beyond = border(side).beyond;
    const Triangle& points = cells_[side.cell].points;
    const int peak = cells_[beyond.cell].points[beyond.k];
    const int apex = points[side.k];
    return turn(apex, points[(side.k + 1) % 3], peak) > 0 &&
           turn(apex, peak, points[(side.k + 2) % 3]) > 0;
}

/// Whether the angles opposite to a side sum to at most pi.
bool FaceTriangulation::isDelaunay(Side side) const {
    const Side beyond = border(side).beyond;
    const Triangle& points = cells_[side.cell].points;
    const Eigen::Vector2d& apex = flat_[points[side.k]];
    const Eigen::Vector2d& from = flat_[points[(side.k + 1) % 3]];
    const Eigen::Vector2d& to = flat_[points[(side.k + 2) % 3]];
    const Eigen::Vector2d& peak = flat_[cells_[beyond.cell].points[beyond.k]];
    const Eigen::Vector2d a = (from - apex).normalized();
    const Eigen::Vector2d b = (to - apex).normalized();
    const Eigen::Vector2d c = (to - peak).normalized();
    const Eigen::Vector2d d = (from - peak).normalized();
    // sin(alpha + beta) = sin alpha cos beta + cos alpha sin beta
    return cross(a, b) * c.dot(d) + a.dot(b) * cross(c, d) >= -kDelaunayMargin;
}

void FaceTriangulation::flip(Side side) {
    const Side beyond = border(side).beyond;
    const auto [cell, k] = side;
    const auto [other, j] = beyond;
    const int apex = cells_[cell].points[k];
    const int from = cells_[cell].points[(k + 1) % 3];
    const int to = cells_[cell].points[(k + 2) % 3];
    const int peak = cells_[other].points[j];
    const Border last = cells_[cell].borders[(k + 1) % 3];
    const Border first = cells_[cell].borders[(k + 2) % 3];
    const Border nearFrom = cells_[other].borders[(j + 1) % 3];
    const Border nearTo = cells_[other].borders[(j + 2) % 3];
    setCell(cell, {apex, from, peak}, {nearFrom, {{other, 2}}, first});
    setCell(other, {apex, peak, to}, {nearTo, last, {{cell, 1}}});
}

/// Flips sides until all but segments are Delaunay. Ends, since each flip makes the smaller of two
/// angle sums larger by more than rounding.
void FaceTriangulation::restoreDelaunay(std::vector<Side> suspects) {
    while (!suspects.empty()) {
        const Side side = suspects.back();
        suspects.pop_back();
        const Border across = border(side);
        if (across.isSegment || across.beyond.cell < 0 || isDelaunay(side) || !isConvex(side)) {
            continue;
        }
        flip(side);
        for (const int cell : {side.cell, across.beyond.cell}) {
            for (int k = 0; k < 3; ++k) {
                suspects.push_back({cell, k});
            }
        }
    }
}

void FaceTriangulation::markSegment(Side side) {
    Border& one = cells_[side.cell].borders[side.k];
    one.isSegment = true;
    if (one.beyond.cell >= 0) {
        cells_[one.beyond.cell].borders[one.beyond.k].isSegment = true;
    }
}

bool FaceTriangulation::isCrossed(int a, int b, int from, int to) const {
    return from != a && from != b && to != a && to != b && turn(a, b, from) * turn(a, b, to) < 0 &&
           turn(from, to, a) * turn(from, to, b) < 0;
}

/// The sides that the segment from a to b crosses, in its order.
std::vector<std::array<int, 2>> FaceTriangulation::sidesCrossed(int a, int b) const {
    std::vector<std::array<int, 2>> crossed;
    Side side{};
    for (const Side leaving : sidesAround(a)) {
        const Triangle& points = cells_[leaving.cell].points;
        const int from = points[(leaving.k + 2) % 3];
        const int to = points[leaving.k];
        if (isCrossed(a, b, from, to)) {
            side = {leaving.cell, (leaving.k + 1) % 3};
        }
    }
    while (side.cell >= 0) {
        const Triangle& points = cells_[side.cell].points;
        crossed.push_back({points[(side.k + 1) % 3], points[(side.k + 2) % 3]});
        const Side entered = border(side).beyond;
        side = {};
        for (int k = 1; k < 3; ++k) {
            const Triangle& next = cells_[entered.cell].points;
            const int out = (entered.k + k) % 3;
            if (isCrossed(a, b, next[(out + 1) % 3], next[(out + 2) % 3])) {
                side = {entered.cell, out};
            }
        }
    }
    return crossed;
}

void FaceTriangulation::addSegment(int a, int b) {
    std::vector<std::array<int, 2>> created;
    const std::vector<std::array<int, 2>> crossed = sidesCrossed(a, b);
    std::deque<std::array<int, 2>> left(crossed.begin(), crossed.end());
    // Sloan needs few more flips than there are sides; the square bounds them.
    std::size_t patience = 16 + 4 * crossed.size() * crossed.size();
    while (!left.empty()) {
        if (patience-- == 0) {
            throw std::logic_error("a segment of a face's triangulation cannot be made an edge");
        }
        const auto [from, to] = left.front();
        left.pop_front();
        const Side side = findSide(from, to);
        if (!isConvex(side)) {
            left.push_back({from, to});
            continue;
        }
        const Side beyond = border(side).beyond;
        const int apex = cells_[side.cell].points[side.k];
        const int peak = cells_[beyond.cell].points[beyond.k];
        flip(side);
        if (isCrossed(a, b, apex, peak)) {
            left.push_back({apex, peak});
        } else {
            created.push_back({apex, peak});
        }
    }
    const Side segment = findSide(a, b);
    if (segment.cell < 0) {
        throw std::logic_error("a point lies on a segment of a face's triangulation");
    }
    markSegment(segment);
    std::vector<Side> suspects;
    for (const auto& [from, to] : created) {
        const Side side = findSide(from, to);
        if (side.cell >= 0) {
            suspects.push_back(side);
        }
    }
    restoreDelaunay(std::move(suspects));
}

void FaceTriangulation::appendTriangles(std::vector<Triangle>& triangles) const {
    for (const Cell& cell : cells_) {
        triangles.push_back(cell.points);
    }
}

}  // namespace bspline_curve
