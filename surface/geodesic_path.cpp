// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/geodesic_path.h"

#include "surface/strip_unfolding.h"
#include "surface/surface_point.h"
#include "surface/window_search.h"
#include "utility/index_sets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

namespace bspline_curve {
namespace {

// A new path must be shorter by this share to count as shorter.
constexpr double kShorter = 1e-12;
// A path that bends less than this at a vertex counts as straight (radians).
constexpr double kStraight = 1e-9;
// For the second look. Half of 1431 paths on meshes of all kinds need 5 windows, a twentieth more
// than 10,000; without needles in the first path none needs more than this, ...
constexpr std::size_t kMostWindows = 50'000;
// ... and with needles the most are 800,000: half a second, 70 MB.
constexpr std::size_t kMostWindowsOverNeedles = 1'000'000;
constexpr double kNeedle = 8.0;

using Strip = std::vector<int>;

std::ptrdiff_t step(std::size_t index) {
    return static_cast<std::ptrdiff_t>(index);
}

// Removes detours: a face that follows itself, and spikes f g f.
void removeSpikes(Strip& strip) {
    Strip clean;
    clean.reserve(strip.size());
    for (const int face : strip) {
        if (clean.size() >= 2 && clean[clean.size() - 2] == face) {
            clean.pop_back();
        } else if (clean.empty() || clean.back() != face) {
            clean.push_back(face);
        }
    }
    strip.swap(clean);
}

// Pulls the way in a strip tight: wherever the path bends round a vertex whose other side is
// cheaper, the strip is moved to that side, until none is left. The strip leads from one of the
// faces that hold the start to one that holds the goal.
class Straightener {
public:
    Straightener(
        const Surface& surface,
        KnownCosts& costs,
        Strip strip,
        const SurfacePoint& start,
        const SurfacePoint& goal
    )
        : surface_(surface),
          costs_(costs),
          start_{-1, start, costs.openFacesHolding(surface, start)},
          goal_{-1, goal, costs.openFacesHolding(surface, goal)},
          strip_(std::move(strip)) {
        pullTight();
    }

    // A corner of the path is judged between the corners before and after it, and all that are to
    // move and do not touch each other move at once, so that a try costs as much as the way between
    // three corners is long. Each accepted move makes the path cheaper, and each refused one
    // settles a corner, so this ends.
    std::vector<SurfacePoint> run() {
        while (true) {
            std::vector<Move> moves = cheaperSides();
            if (moves.empty()) {
                return points();
            }
            if (!apply(moves)) {
                // Corners change when others move. The sharpest one alone is cheaper unless it was
                // not the way between its neighbours that was the shortest.
                moves.resize(1);
                if (!apply(moves)) {
                    settled_.push_back(moves.front().corner);
                }
            }
        }
    }

    /// What the way costs.
    [[nodiscard]] double cost() const { return cost_; }

private:
    // Where the way between two corners begins or ends.
    struct End {
        int vertex;  // of a corner, or -1
        SurfacePoint point;
        std::vector<int> faces;  // open ones that hold the point, unless it is a corner
    };

    // A corner, by its vertex and those of its neighbours.
    struct Corner {
        int before, vertex, after;

        friend bool operator==(const Corner&, const Corner&) = default;
    };

    // The part of the way from the corner before a corner to the one after it.
    struct Window {
        std::size_t first, last;  // faces, in the strip
        std::size_t portal;       // of the corner, in the strip
        End before, after;
        Corner corner;
    };

    // What a part of the strip is to become.
    struct Move {
        Corner corner;
        std::size_t first, last;
        Strip faces;
    };

    // The start, a point on each edge that the path crosses, and the goal.
    [[nodiscard]] std::vector<SurfacePoint> points() const {
        std::vector<SurfacePoint> points{inFace(surface_, start_.point, strip_.front())};
        for (std::size_t i = 0; i + 1 < strip_.size(); ++i) {
            const Triangle& corners = surface_.faces()[strip_[i]];
            SurfacePoint point{strip_[i], Vec3::Zero()};
            point.barycentric[cornerOf(corners, path_.lefts[i])] = 1.0 - path_.crossings[i];
            point.barycentric[cornerOf(corners, path_.rights[i])] = path_.crossings[i];
            points.push_back(point);
        }
        points.push_back(inFace(surface_, goal_.point, strip_.back()));
        return points;
    }

    void pullTight() {
        trim(strip_, start_, goal_);
        path_ = pathIn(strip_, start_, goal_);
        cost_ = costOf(strip_, path_, 0, start_, goal_);
    }

    [[nodiscard]] StripPath pathIn(const Strip& strip, const End& from, const End& to) const {
        return shortestPathInStrip(
            surface_,
            strip,
            inFace(surface_, from.point, strip.front()),
            inFace(surface_, to.point, strip.back())
        );
    }

    // Of the part of a path in some faces, of which the first is followed by a portal.
    [[nodiscard]] double costOf(
        std::span<const int> faces,
        const StripPath& path,
        std::size_t portal,
        const End& from,
        const End& to
    ) {
        double cost = 0.0;
        Vec3 here = surface_.position(from.point);
        for (std::size_t i = 0; i < faces.size(); ++i, ++portal) {
            const bool isLast = i + 1 == faces.size();
            const Vec3 next = isLast ? surface_.position(to.point) : crossing(path, portal);
            cost += costs_.of(faces[i]) * (next - here).norm();
            here = next;
        }
        return cost;
    }

    [[nodiscard]] Vec3 crossing(const StripPath& path, std::size_t portal) const {
        const double s = path.crossings[portal];
        return (1.0 - s) * surface_.vertices()[path.lefts[portal]] +
               s * surface_.vertices()[path.rights[portal]];
    }

    [[nodiscard]] std::vector<std::size_t> sharpestFirst() const {
        std::vector<std::size_t> order;
        for (std::size_t c = 0; c < path_.corners.size(); ++c) {
            if (path_.corners[c].bend > kStraight) {
                order.push_back(c);
            }
        }
        std::ranges::stable_sort(order, std::ranges::greater(), [&](std::size_t c) {
            return path_.corners[c].bend;
        });
        return order;
    }

    [[nodiscard]] End endAt(int vertex) const {
        const int face = *surface_.facesAround(vertex).begin();
        return {vertex, {face, Vec3::Unit(cornerOf(surface_.faces()[face], vertex))}, {}};
    }

    [[nodiscard]] Window windowAt(std::size_t c) const {
        const std::vector<StripPath::Corner>& corners = path_.corners;
        const bool isFirst = c == 0;
        const bool isLast = c + 1 == corners.size();
        Window window{
            .first = isFirst ? 0 : corners[c - 1].portal + 1,
            .last = isLast ? strip_.size() - 1 : corners[c + 1].portal,
            .portal = corners[c].portal,
            .before = isFirst ? start_ : endAt(corners[c - 1].vertex),
            .after = isLast ? goal_ : endAt(corners[c + 1].vertex),
            .corner = {},
        };
        window.corner = {window.before.vertex, corners[c].vertex, window.after.vertex};
        return window;
    }

    // Moves round corners that are no neighbours, the sharpest first.
    std::vector<Move> cheaperSides() {
        std::vector<Move> moves;
        // Of corner c at c + 1.
        std::vector<char> isMoved(path_.corners.size() + 2, 0);
        for (const std::size_t c : sharpestFirst()) {
            if (isMoved[c] != 0 || isMoved[c + 2] != 0) {
                continue;
            }
            const Window window = windowAt(c);
            if (contains(settled_, window.corner)) {
                continue;
            }
            if (std::optional<Move> move = cheaperSide(window, path_.corners[c].bend)) {
                moves.push_back(std::move(*move));
                isMoved[c + 1] = 1;
            } else {
                settled_.push_back(window.corner);
            }
        }
        return moves;
    }

    // The move to the other side of a corner, if the way between its neighbours is cheaper there.
    std::optional<Move> cheaperSide(const Window& window, double bend) {
        // The path has the angle pi + bend on the strip's side; less than pi on the other makes
        // that side shorter.
        const int vertex = window.corner.vertex;
        if (totalAngle(surface_, vertex) - std::numbers::pi - bend >= std::numbers::pi) {
            return std::nullopt;
        }
        const std::span<const int> now =
            std::span(strip_).subspan(window.first, window.last - window.first + 1);
        Strip faces(now.begin(), now.end());
        if (!rerouteAround(vertex, window.portal - window.first, faces)) {
            return std::nullopt;
        }
        removeSpikes(faces);
        Strip between = faces;
        trim(between, window.before, window.after);
        const StripPath path = pathIn(between, window.before, window.after);
        const double cost = costOf(between, path, 0, window.before, window.after);
        const double costNow = costOf(now, path_, window.first, window.before, window.after);
        if (cost >= costNow * (1.0 - kShorter)) {
            return std::nullopt;
        }
        return Move{window.corner, window.first, window.last, std::move(faces)};
    }

    // Moves the strip, if the path in it is cheaper then.
    bool apply(const std::vector<Move>& moves) {
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
    // possible. `portal` is the edge between strip[portal] and strip[portal + 1] where the path
    // meets it.
    bool rerouteAround(int vertex, std::size_t portal, Strip& strip) {
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
        Strip moved(strip.begin(), strip.begin() + step(first));
        int previous = strip[first + 1];
        for (int face = strip[first]; face != strip[last];) {
            moved.push_back(face);
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
            previous = std::exchange(face, next);
        }
        moved.insert(moved.end(), strip.begin() + step(last), strip.end());
        strip.swap(moved);
        return true;
    }

    [[nodiscard]] bool holds(int face, const End& end) const {
        return end.vertex >= 0 ? cornerOf(surface_.faces()[face], end.vertex) >= 0
                               : contains(end.faces, face);
    }

    // Keeps the part of a strip from the last face that holds its start to the first after it that
    // holds its goal.
    void trim(Strip& strip, const End& from, const End& to) const {
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

    const Surface& surface_;
    KnownCosts& costs_;
    End start_, goal_;
    Strip strip_;
    StripPath path_;
    double cost_ = 0.0;
    std::vector<Corner> settled_;  // whose other sides are not cheaper
};

}  // namespace

double needleLength(const Surface& surface, int face) {
    const auto& [a, b, c] = surface.faces()[face];
    const Vec3 ab = surface.vertices()[b] - surface.vertices()[a];
    const Vec3 ac = surface.vertices()[c] - surface.vertices()[a];
    const double squared = std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
    return squared > kNeedle * ab.cross(ac).norm() ? std::sqrt(squared) : 0.0;
}

std::optional<GeodesicPath> GeodesicPathFinder::find(
    const SurfacePoint& start, const SurfacePoint& goal, int mostPatches
) {
    std::optional<StripSearch::Way> way = search_.find(start, goal, mostPatches);
    if (!way) {
        return std::nullopt;
    }
    if (way->strip.empty()) {
        way->overPatches.insert(way->overPatches.begin(), start);
        way->overPatches.push_back(goal);
        return pathOver(std::move(way->overPatches), true);
    }
    const bool hasNeedles = std::ranges::any_of(way->strip, [&](int face) {
        return needleLength(surface_, face) > 0.0;
    });
    Straightener first(surface_, search_.costs(), std::move(way->strip), start, goal);
    GeodesicPath path = pathOver(first.run(), false);
    path.cost = first.cost();
    const std::size_t mostWindows = hasNeedles ? kMostWindowsOverNeedles : kMostWindows;
    return shorterBy(kDetour, std::move(path), start, goal, mostWindows);
}

std::optional<GeodesicPath> GeodesicPathFinder::findShortest(
    const SurfacePoint& start, const SurfacePoint& goal
) {
    std::optional<GeodesicPath> path = find(start, goal);
    if (!path) {
        return std::nullopt;
    }
    return shorterBy(1.0, std::move(*path), start, goal, kMostWindowsOverNeedles);
}

GeodesicPath GeodesicPathFinder::shorterBy(
    double factor,
    GeodesicPath path,
    const SurfacePoint& start,
    const SurfacePoint& goal,
    std::size_t mostWindows
) {
    if (path.points.size() <= 2 || !search_.costs().costs().areLengths) {
        return path;
    }
    std::optional<Strip> strip = windows_.find(start, goal, path.length / factor, mostWindows);
    if (!strip) {
        return path;
    }
    Straightener straightener(surface_, search_.costs(), std::move(*strip), start, goal);
    GeodesicPath second = pathOver(straightener.run(), false);
    second.cost = straightener.cost();
    return second.cost < path.cost ? second : path;
}

GeodesicPath GeodesicPathFinder::pathOver(
    std::vector<SurfacePoint> points, bool isOverPatches
) const {
    GeodesicPath path{.points = std::move(points), .positions = {}, .isOverPatches = isOverPatches};
    for (const SurfacePoint& point : path.points) {
        path.positions.push_back(surface_.position(point));
        if (path.positions.size() > 1) {
            path.length += (path.positions.back() - *(path.positions.end() - 2)).norm();
        }
    }
    return path;
}

}  // namespace bspline_curve
