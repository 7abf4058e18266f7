// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/window_search.h"

#include "surface/plane_vectors.h"
#include "surface/surface_point.h"
#include "utility/index_sets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bspline_curve {
namespace {

using Point2 = Eigen::Vector2d;

// A way is dropped where another is shorter by more than this share: rounding drops none.
constexpr double kRoundedShare = 1e-11;
// Vertices with more than 2 pi by less than this (radians) count as flat.
constexpr double kFlatAngle = 1e-9;
// Shares of an edge: thinner windows, and sources nearer to its line, are rounding.
constexpr double kThinShare = 1e-12;

constexpr double kFarthest = std::numeric_limits<double>::infinity();

// Places of offers: windows are even, vertices odd.
constexpr int placeOfWindow(int window) {
    return 2 * window;
}

constexpr int placeOfVertex(int vertex) {
    return 2 * vertex + 1;
}

// Where the straight line from a source above the x axis through another, lower point crosses it.
double crossingOfAxis(const Point2& source, const Point2& lower) {
    return source.x() + (lower.x() - source.x()) * source.y() / (source.y() - lower.y());
}

// Position along and height over the edge from a to b, of a given length.
Point2 overEdge(const Vec3& point, const Vec3& a, const Vec3& b, double width) {
    const Vec3 along = (b - a) / width;
    return {along.dot(point - a), along.cross(point - a).norm()};
}

// The same point in a frame with another origin and direction of x.
Point2 inFrame(const Point2& point, const Point2& origin, const Point2& direction) {
    return {direction.dot(point - origin), cross(direction, point - origin)};
}

}  // namespace

double totalAngle(const Surface& surface, int vertex) {
    double sum = 0.0;
    const Vec3& p = surface.vertices()[vertex];
    for (const int f : surface.facesAround(vertex)) {
        const Triangle& face = surface.faces()[f];
        const int k = cornerOf(face, vertex);
        const Vec3 a = surface.vertices()[face[(k + 1) % 3]] - p;
        const Vec3 b = surface.vertices()[face[(k + 2) % 3]] - p;
        sum += std::atan2(a.cross(b).norm(), a.dot(b));
    }
    return sum;
}

std::optional<std::vector<int>> WindowSearch::find(
    const SurfacePoint& start, const SurfacePoint& goal, double longest, std::size_t mostWindows
) {
    windows_.clear();
    arrivals_.clear();
    queue_.clear();
    startFaces_ = costs_.openFacesHolding(surface_, start);
    goalFaces_ = costs_.openFacesHolding(surface_, goal);
    goal_ = surface_.position(goal);
    goalFace_ = -1;
    shortest_ = longest;
    leaveStart(start);
    while (!queue_.empty() && queue_.top().estimate < shortest_ && windows_.size() < mostWindows) {
        const Offer best = queue_.top();
        queue_.pop();
        if (best.place % 2 == 0) {
            pass(best.place / 2);
        } else if (best.cost <= lengthTo(best.place / 2)) {
            leave(best.place / 2);
        }
    }
    return goalFace_ < 0 ? std::nullopt : strip();
}

void WindowSearch::leaveStart(const SurfacePoint& start) {
    const Vec3 from = surface_.position(start);
    for (const int f : startFaces_) {
        for (int k = 0; k < 3; ++k) {
            const int vertex = surface_.faces()[f][k];
            reach(vertex, (surface_.vertices()[vertex] - from).norm(), kAtStart);
        }
    }
    for (const int f : startFaces_) {
        for (int k = 0; k < 3; ++k) {
            radiate(3 * f + k, from, 0.0, kAtStart);
        }
    }
}

int WindowSearch::faceBehind(int crossing) const {
    return surface_.faceNeighbours()[crossing / 3][crossing % 3];
}

WindowSearch::Gate WindowSearch::gateOf(int crossing) const {
    const Triangle& here = surface_.faces()[crossing / 3];
    const int k = crossing % 3;
    Gate gate{};
    gate.right = here[(k + 1) % 3];
    gate.left = here[(k + 2) % 3];
    gate.face = faceBehind(crossing);
    const Triangle& there = surface_.faces()[gate.face];
    const int right = cornerOf(there, gate.right);
    const int left = cornerOf(there, gate.left);
    gate.apex = there[3 - right - left];
    gate.overRightSide = 3 * gate.face + left;
    gate.overLeftSide = 3 * gate.face + right;
    const Vec3& a = surface_.vertices()[gate.right];
    const Vec3& b = surface_.vertices()[gate.left];
    gate.width = (b - a).norm();
    gate.apexAt = overEdge(surface_.vertices()[gate.apex], a, b, gate.width);
    gate.apexAt.y() = -gate.apexAt.y();
    return gate;
}

double WindowSearch::lengthTo(int vertex) const {
    const Arrival* const arrival = arrivals_.find(vertex);
    return arrival == nullptr ? kFarthest : arrival->length;
}

void WindowSearch::reach(int vertex, double length, int parent) {
    const double estimate = length + (goal_ - surface_.vertices()[vertex]).norm();
    if (estimate >= shortest_) {
        return;
    }
    Arrival& arrival = arrivals_.at(vertex, {kFarthest, kAtStart});
    if (length < arrival.length) {
        arrival = {length, parent};
        queue_.push({estimate, length, placeOfVertex(vertex)});
    }
}

// A window as wide as an edge, for straight ways from a point of the face before it.
void WindowSearch::radiate(int crossing, const Vec3& from, double before, int parent) {
    const Triangle& face = surface_.faces()[crossing / 3];
    const Vec3& a = surface_.vertices()[face[(crossing + 1) % 3]];
    const Vec3& b = surface_.vertices()[face[(crossing + 2) % 3]];
    const double width = (b - a).norm();
    add({crossing, 0.0, width, width, overEdge(from, a, b, width), before, parent}, Side::None);
}

// `side`: where the ways came into the face that they leave, seen along them.
void WindowSearch::add(const Window& window, Side side) {
    const int next = faceBehind(window.crossing);
    if (next < 0 || !costs_.isOpen(next) ||
        window.end - window.begin <= kThinShare * window.width ||
        window.source.y() <= kThinShare * window.width) {
        return;
    }
    const Triangle& face = surface_.faces()[window.crossing / 3];
    const int k = window.crossing % 3;
    const int right = face[(k + 1) % 3];
    const int left = face[(k + 2) % 3];
    const Vec3& a = surface_.vertices()[right];
    const Vec3& b = surface_.vertices()[left];
    const Point2 begin(window.begin, 0.0);
    const Point2 end(window.end, 0.0);
    // Ways over a corner of the face cross all ways of the window, and are shorter.
    const double slack = 1.0 - kRoundedShare;
    const double toBegin = slack * (window.before + (begin - window.source).norm());
    const double toEnd = slack * (window.before + (end - window.source).norm());
    if (lengthTo(right) + window.end < toEnd ||
        lengthTo(left) + window.width - window.begin < toBegin) {
        return;
    }
    if (side != Side::None) {
        const Point2 opposite = overEdge(surface_.vertices()[face[k]], a, b, window.width);
        const double over = lengthTo(face[k]);
        if (side == Side::Right ? over + (begin - opposite).norm() < toBegin
                                : over + (end - opposite).norm() < toEnd) {
            return;
        }
    }
    // No way is shorter than the one over the window to the goal, laid flat behind it.
    Point2 goal = overEdge(goal_, a, b, window.width);
    goal.y() = -goal.y();
    const Point2 over(
        std::clamp(crossingOfAxis(window.source, goal), window.begin, window.end), 0.0
    );
    const double estimate = window.before + (over - window.source).norm() + (goal - over).norm();
    if (estimate < shortest_) {
        queue_.push({estimate, window.before, placeOfWindow(static_cast<int>(windows_.size()))});
        windows_.push_back(window);
    }
}

// Into the face behind: to its corner, to the goal if it lies there, and to the two other edges.
void WindowSearch::pass(int index) {
    const Window window = windows_[index];
    const Gate gate = gateOf(window.crossing);
    const auto sees = [&](double crossing) {
        const double slack = kThinShare * gate.width;
        return crossing >= window.begin - slack && crossing <= window.end + slack;
    };
    const double split = crossingOfAxis(window.source, gate.apexAt);
    if (sees(split)) {
        reach(gate.apex, window.before + (gate.apexAt - window.source).norm(), index);
    }
    if (contains(goalFaces_, gate.face)) {
        Point2 goal = overEdge(
            goal_, surface_.vertices()[gate.right], surface_.vertices()[gate.left], gate.width
        );
        goal.y() = -goal.y();
        arrive(
            sees(crossingOfAxis(window.source, goal))
                ? window.before + (goal - window.source).norm()
                : kFarthest,
            index,
            gate.face
        );
    }
    const auto addBehind = [&](Side side, const Point2& origin, const Point2& target) {
        const double width = (target - origin).norm();
        const Point2 direction = (target - origin) / width;
        const Point2 source = inFrame(window.source, origin, direction);
        const auto along = [&](double crossing) {
            const Point2 through = inFrame({crossing, 0.0}, origin, direction);
            return std::clamp(crossingOfAxis(source, through), 0.0, width);
        };
        const bool isRight = side == Side::Right;
        add({isRight ? gate.overRightSide : gate.overLeftSide,
             isRight || window.begin > split ? along(window.begin) : 0.0,
             !isRight || window.end < split ? along(window.end) : width,
             width,
             source,
             window.before,
             index},
            side);
    };
    if (window.begin < split) {
        addBehind(Side::Right, {0.0, 0.0}, gate.apexAt);
    }
    if (window.end > split) {
        addBehind(Side::Left, gate.apexAt, {gate.width, 0.0});
    }
}

void WindowSearch::arrive(double length, int parent, int face) {
    if (length < shortest_) {
        shortest_ = length;
        goalParent_ = parent;
        goalFace_ = face;
    }
}

// Along the edges at a vertex, and where it bends shortest paths, into its faces.
void WindowSearch::leave(int vertex) {
    const Vec3& here = surface_.vertices()[vertex];
    const Arrival arrival = *arrivals_.find(vertex);
    const int parent = fromVertex(vertex);
    const bool bends = arrival.length > 0.0 && bendsWays(vertex);
    for (const int f : surface_.facesAround(vertex)) {
        if (!costs_.isOpen(f)) {
            continue;
        }
        const int k = cornerOf(surface_.faces()[f], vertex);
        for (const int other : {(k + 1) % 3, (k + 2) % 3}) {
            const int neighbour = surface_.faces()[f][other];
            const double length = (surface_.vertices()[neighbour] - here).norm();
            reach(neighbour, arrival.length + length, parent);
        }
        if (contains(goalFaces_, f)) {
            arrive(arrival.length + (goal_ - here).norm(), parent, f);
        }
        if (bends) {
            radiate(3 * f + k, here, arrival.length, parent);
        }
    }
}

bool WindowSearch::bendsWays(int vertex) {
    const auto isClosed = [&](int face) { return !costs_.isOpen(face); };
    return surface_.isBoundaryVertex(vertex) ||
           totalAngle(surface_, vertex) > 2.0 * std::numbers::pi + kFlatAngle ||
           std::ranges::any_of(surface_.facesAround(vertex), isClosed);
}

// Nothing where faces of the way meet in a vertex alone, so that no strip leads over it.
std::optional<std::vector<int>> WindowSearch::strip() {
    std::vector<int> strip{goalFace_};
    int parent = goalParent_;
    while (parent != kAtStart) {
        if (parent >= 0) {
            strip.push_back(windows_[parent].crossing / 3);
            parent = windows_[parent].parent;
            continue;
        }
        const int vertex = vertexOf(parent);
        parent = arrivals_.find(vertex)->parent;
        std::vector<int> faces = startFaces_;
        if (parent >= 0) {
            faces = {faceBehind(windows_[parent].crossing)};
        } else if (parent != kAtStart) {
            const auto around = surface_.facesAround(vertexOf(parent));
            faces.assign(around.begin(), around.end());
        }
        if (!turnAt(vertex, faces, strip)) {
            return std::nullopt;
        }
    }
    std::ranges::reverse(strip);
    return strip;
}

// Goes on round a vertex to one of some faces.
bool WindowSearch::turnAt(int vertex, const std::vector<int>& faces, std::vector<int>& strip) {
    const std::size_t size = strip.size();
    for (const int turn : {1, 2}) {
        while (!contains(faces, strip.back())) {
            const int face = strip.back();
            const int k = cornerOf(surface_.faces()[face], vertex);
            const int next = surface_.faceNeighbours()[face][(k + turn) % 3];
            if (next < 0 || !costs_.isOpen(next) || next == strip[size - 1]) {
                break;
            }
            strip.push_back(next);
        }
        if (contains(faces, strip.back())) {
            return true;
        }
        strip.resize(size);
    }
    return false;
}

}  // namespace bspline_curve
