// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/strip_route.h"

#include "surface/surface_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace bspline_curve {
namespace {

// A new path must be shorter by this share to count as shorter.
constexpr double kShorter = 1e-12;
// A path that bends less than this at a vertex counts as straight (radians).
constexpr double kStraight = 1e-9;

std::ptrdiff_t step(std::size_t index) {
    return static_cast<std::ptrdiff_t>(index);
}

bool contains(const std::vector<int>& list, int value) {
    return std::ranges::find(list, value) != list.end();
}

// The angle that the surface has at a vertex: 2 pi in the plane.
double totalAngle(const Surface& surface, int vertex) {
    double sum = 0.0;
    const Vec3& p = surface.vertices()[vertex];
    for (const int f : surface.facesAround(vertex)) {
        const Triangle& face = surface.faces()[f];
        const std::size_t k = (cornerOf(face, vertex));
        const Vec3 a = surface.vertices()[face[(k + 1) % 3]] - p;
        const Vec3 b = surface.vertices()[face[(k + 2) % 3]] - p;
        sum += std::atan2(a.cross(b).norm(), a.dot(b));
    }
    return sum;
}

// Removes detours: a face that follows itself, and spikes f g f.
void removeSpikes(std::vector<int>& strip) {
    std::vector<int> clean;
    clean.reserve(strip.size());
    for (const int face : strip) {
        if (!clean.empty() && clean.back() == face) {
            continue;
        }
        if (clean.size() >= 2 && clean[clean.size() - 2] == face) {
            clean.pop_back();
            continue;
        }
        clean.push_back(face);
    }
    strip.swap(clean);
}

// Where the path in a strip crosses a portal.
Vec3 crossing(const Surface& surface, const StripPath& path, std::size_t portal) {
    const double s = path.crossings[portal];
    return (1.0 - s) * surface.vertices()[path.lefts[portal]] +
           s * surface.vertices()[path.rights[portal]];
}

std::vector<int> openFacesHolding(
    const Surface& surface, KnownCosts& costs, const SurfacePoint& point
) {
    std::vector<int> faces = facesHolding(surface, point);
    std::erase_if(faces, [&](int f) { return !costs.isOpen(f); });
    return faces;
}

}  // namespace

StripRoute::StripRoute(
    const Surface& surface,
    KnownCosts& costs,
    std::vector<int> strip,
    const SurfacePoint& start,
    const SurfacePoint& goal
)
    : surface_(surface),
      costs_(costs),
      start_{-1, start, openFacesHolding(surface, costs, start)},
      goal_{-1, goal, openFacesHolding(surface, costs, goal)},
      strip_(std::move(strip)) {
    pullTight();
}

void StripRoute::pullTight() {
    trim(strip_, start_, goal_);
    path_ = shortestPathInStrip(
        surface_, strip_, pointIn(strip_.front(), start_), pointIn(strip_.back(), goal_)
    );
    cost_ = costNow({0, strip_.size() - 1, 0, -1, start_, goal_});
}

// Each accepted move makes the path cheaper, and each refused one settles a corner, so this ends.
void StripRoute::straighten() {
    while (true) {
        std::vector<Move> moves = cheaperSides();
        if (moves.empty()) {
            return;
        }
        if (!areCheaper(moves)) {
            // Corners change when others move. The sharpest one alone is cheaper unless it was not
            // the way between its neighbours that was the shortest.
            moves.resize(1);
            if (!areCheaper(moves)) {
                settled_.push_back(moves.front().corner);
            }
        }
    }
}

std::vector<std::size_t> StripRoute::sharpestFirst() const {
    std::vector<std::size_t> order;
    for (std::size_t c = 0; c < path_.corners.size(); ++c) {
        if (path_.corners[c].bend > kStraight) {
            order.push_back(c);
        }
    }
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return path_.corners[a].bend > path_.corners[b].bend;
    });
    return order;
}

StripRoute::Window StripRoute::windowAt(std::size_t corner) const {
    const std::vector<StripPath::Corner>& corners = path_.corners;
    Window window{
        0, strip_.size() - 1, corners[corner].portal, corners[corner].vertex, start_, goal_
    };
    if (corner > 0) {
        window.first = corners[corner - 1].portal + 1;
        window.before.vertex = corners[corner - 1].vertex;
    }
    if (corner + 1 < corners.size()) {
        window.last = corners[corner + 1].portal;
        window.after.vertex = corners[corner + 1].vertex;
    }
    return window;
}

// Moves round corners that are no neighbours, the sharpest first.
std::vector<StripRoute::Move> StripRoute::cheaperSides() {
    std::vector<Move> moves;
    // Of corner c at c + 1.
    std::vector<char> isMoved(path_.corners.size() + 2, 0);
    for (const std::size_t c : sharpestFirst()) {
        if (isMoved[c] != 0 || isMoved[c + 2] != 0) {
            continue;
        }
        const Window window = windowAt(c);
        const Corner corner{window.before.vertex, window.vertex, window.after.vertex};
        if (std::ranges::find(settled_, corner) != settled_.end()) {
            continue;
        }
        if (std::optional<Move> move = cheaperSide(window, path_.corners[c].bend)) {
            moves.push_back(std::move(*move));
            isMoved[c + 1] = 1;
        } else {
            settled_.push_back(corner);
        }
    }
    return moves;
}

// The move to the other side of a corner, if the way between its neighbours is cheaper there.
std::optional<StripRoute::Move> StripRoute::cheaperSide(const Window& window, double bend) {
    // The path has the angle pi + bend on the strip's side; less than pi on the other makes that
    // side shorter.
    if (totalAngle(surface_, window.vertex) - std::numbers::pi - bend >= std::numbers::pi) {
        return std::nullopt;
    }
    Strip faces(strip_.begin() + step(window.first), strip_.begin() + step(window.last) + 1);
    if (!rerouteAround(window.vertex, window.portal - window.first, faces)) {
        return std::nullopt;
    }
    removeSpikes(faces);
    Strip between = faces;
    trim(between, window.before, window.after);
    if (shortestCost(between, window.before, window.after) >= costNow(window) * (1.0 - kShorter)) {
        return std::nullopt;
    }
    return Move{
        {window.before.vertex, window.vertex, window.after.vertex},
        window.first,
        window.last,
        std::move(faces)
    };
}

// Moves the strip, if the path in it is cheaper then.
bool StripRoute::areCheaper(const std::vector<Move>& moves) {
    std::vector<const Move*> inOrder;
    for (const Move& move : moves) {
        inOrder.push_back(&move);
    }
    std::ranges::sort(inOrder, {}, &Move::first);
    Strip moved;
    auto next = strip_.cbegin();
    for (const Move* move : inOrder) {
        moved.insert(moved.end(), next, strip_.cbegin() + step(move->first));
        moved.insert(moved.end(), move->faces.begin(), move->faces.end());
        next = strip_.cbegin() + step(move->last) + 1;
    }
    moved.insert(moved.end(), next, strip_.cend());
    removeSpikes(moved);
    strip_.swap(moved);
    StripPath pathBefore = std::move(path_);
    const double costBefore = cost_;
    pullTight();
    if (cost_ < costBefore * (1.0 - kShorter)) {
        return true;
    }
    strip_.swap(moved);
    path_ = std::move(pathBefore);
    cost_ = costBefore;
    return false;
}

// Moves the strip to the other side of a vertex that the path bends around, where that is
// possible. `portal` is the edge between strip[portal] and strip[portal + 1] where the path meets
// it.
bool StripRoute::rerouteAround(int vertex, std::size_t portal, Strip& strip) {
    const auto isAtVertex = [&](std::size_t i) {
        return cornerOf(surface_.faces()[strip[i]], vertex) >= 0;
    };
    std::size_t first = portal;
    while (first > 0 && isAtVertex(first - 1)) {
        --first;
    }
    std::size_t last = portal + 1;
    while (last + 1 < strip.size() && isAtVertex(last + 1)) {
        ++last;
    }
    // The way round: from strip[first] away from strip[first + 1], always over an edge at the
    // vertex.
    Strip moved(strip.begin(), strip.begin() + step(first) + 1);
    int previous = strip[first + 1];
    int face = strip[first];
    while (face != strip[last]) {
        const Triangle& corners = surface_.faces()[face];
        int next = -1;
        for (std::size_t k = 0; k < 3; ++k) {
            const int neighbour = surface_.faceNeighbours()[face][k];
            if (corners[k] != vertex && neighbour != previous) {
                next = neighbour;
            }
        }
        if (next < 0 || !costs_.isOpen(next)) {
            return false;
        }
        previous = face;
        face = next;
        if (face != strip[last]) {
            moved.push_back(face);
        }
    }
    moved.insert(moved.end(), strip.begin() + step(last), strip.end());
    strip.swap(moved);
    return true;
}

bool StripRoute::holds(int face, const End& end) const {
    if (end.vertex >= 0) {
        return cornerOf(surface_.faces()[face], end.vertex) >= 0;
    }
    return contains(end.faces, face);
}

// Keeps the part of a strip from the last face that holds its start to the first after it that
// holds its goal.
void StripRoute::trim(Strip& strip, const End& from, const End& to) const {
    std::size_t first = 0;
    for (std::size_t i = 0; i < strip.size(); ++i) {
        if (holds(strip[i], from)) {
            first = i;
        }
    }
    std::size_t last = first;
    while (last + 1 < strip.size() && !holds(strip[last], to)) {
        ++last;
    }
    strip.erase(strip.begin() + step(last) + 1, strip.end());
    strip.erase(strip.begin(), strip.begin() + step(first));
}

SurfacePoint StripRoute::pointIn(int face, const End& end) const {
    if (end.vertex < 0) {
        return inFace(surface_, end.point, face);
    }
    return {face, Vec3::Unit(cornerOf(surface_.faces()[face], end.vertex))};
}

Vec3 StripRoute::positionOf(const End& end) const {
    return end.vertex >= 0 ? surface_.vertices()[end.vertex] : surface_.position(end.point);
}

// Of the shortest path in a strip.
double StripRoute::shortestCost(const Strip& strip, const End& from, const End& to) {
    const StripPath path = shortestPathInStrip(
        surface_, strip, pointIn(strip.front(), from), pointIn(strip.back(), to)
    );
    double cost = 0.0;
    Vec3 here = positionOf(from);
    for (std::size_t i = 0; i < strip.size(); ++i) {
        const Vec3 next = i + 1 < strip.size() ? crossing(surface_, path, i) : positionOf(to);
        cost += costs_.of(strip[i]) * (next - here).norm();
        here = next;
    }
    return cost;
}

// Of a part of the path.
double StripRoute::costNow(const Window& window) {
    double cost = 0.0;
    Vec3 here = positionOf(window.before);
    for (std::size_t i = window.first; i <= window.last; ++i) {
        const Vec3 next = i < window.last ? crossing(surface_, path_, i) : positionOf(window.after);
        cost += costs_.of(strip_[i]) * (next - here).norm();
        here = next;
    }
    return cost;
}

}  // namespace bspline_curve
