// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/geodesic_path.h"

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

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

bool contains(const std::vector<int>& list, int value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

// The angle that the surface has at a vertex: 2 pi in the plane.
double totalAngle(const Surface& surface, int vertex) {
    double sum = 0.0;
    const Vec3& p = surface.vertices()[at(vertex)];
    for (const int f : surface.facesAround(vertex)) {
        const Triangle& face = surface.faces()[at(f)];
        const std::size_t k = at(cornerOf(face, vertex));
        const Vec3 a = surface.vertices()[at(face[(k + 1) % 3])] - p;
        const Vec3 b = surface.vertices()[at(face[(k + 2) % 3])] - p;
        sum += std::atan2(a.cross(b).norm(), a.dot(b));
    }
    return sum;
}

// Removes detours: a face that follows itself, and spikes f g f.
void removeSpikes(std::vector<int>& strip) {
    std::vector<int> clean;
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

// Keeps the part of the strip from the last face that holds the start to the first after it that
// holds the goal.
void trim(
    std::vector<int>& strip, const std::vector<int>& startFaces, const std::vector<int>& goalFaces
) {
    std::size_t first = 0;
    for (std::size_t i = 0; i < strip.size(); ++i) {
        if (contains(startFaces, strip[i])) {
            first = i;
        }
    }
    std::size_t last = first;
    while (last + 1 < strip.size() && !contains(goalFaces, strip[last])) {
        ++last;
    }
    strip = std::vector<int>(
        strip.begin() + static_cast<std::ptrdiff_t>(first),
        strip.begin() + static_cast<std::ptrdiff_t>(last) + 1
    );
}

}  // namespace

// Moves the strip to the other side of a vertex that the path bends around, where that is
// possible. `portal` is the edge between strip[portal] and
// strip[portal + 1] where the path meets it.
bool GeodesicPathFinder::rerouteAround(int vertex, std::size_t portal, Strip& strip) {
    const auto holds = [&](std::size_t i) {
        return cornerOf(surface_.faces()[at(strip[i])], vertex) >= 0;
    };
    std::size_t first = portal;
    while (first > 0 && holds(first - 1)) {
        --first;
    }
    std::size_t last = portal + 1;
    while (last + 1 < strip.size() && holds(last + 1)) {
        ++last;
    }
    // The way round: from strip[first] away from strip[first + 1], always over an edge at the
    // vertex.
    Strip detour;
    int previous = strip[first + 1];
    int face = strip[first];
    while (face != strip[last]) {
        const Triangle& corners = surface_.faces()[at(face)];
        int next = -1;
        for (std::size_t k = 0; k < 3; ++k) {
            const int neighbour = surface_.faceNeighbours()[at(face)][k];
            if (corners[k] != vertex && neighbour != previous) {
                next = neighbour;
            }
        }
        if (next < 0 || !search_.isOpen(next)) {
            return false;
        }
        previous = face;
        face = next;
        if (face != strip[last]) {
            detour.push_back(face);
        }
    }
    Strip moved(strip.begin(), strip.begin() + static_cast<std::ptrdiff_t>(first) + 1);
    moved.insert(moved.end(), detour.begin(), detour.end());
    moved.insert(moved.end(), strip.begin() + static_cast<std::ptrdiff_t>(last), strip.end());
    strip.swap(moved);
    return true;
}

Vec3 GeodesicPathFinder::crossingPosition(const Route& route, std::size_t portal) const {
    const double s = route.path.crossings[portal];
    return (1.0 - s) * surface_.vertices()[at(route.path.lefts[portal])] +
           s * surface_.vertices()[at(route.path.rights[portal])];
}

GeodesicPathFinder::Route GeodesicPathFinder::routeIn(Strip strip, const Ends& ends) {
    Route route;
    route.path = shortestPathInStrip(
        surface_,
        strip,
        inFace(surface_, ends.start, strip.front()),
        inFace(surface_, ends.goal, strip.back())
    );
    route.strip = std::move(strip);
    Vec3 from = surface_.position(ends.start);
    for (std::size_t i = 0; i < route.strip.size(); ++i) {
        const Vec3 to =
            i + 1 < route.strip.size() ? crossingPosition(route, i) : surface_.position(ends.goal);
        route.cost += search_.costOf(route.strip[i]) * (to - from).norm();
        from = to;
    }
    return route;
}

// The route on the other side of a corner, if it is cheaper.
std::optional<GeodesicPathFinder::Route> GeodesicPathFinder::otherSide(
    const Route& route, const StripPath::Corner& corner, const Ends& ends
) {
    // The path has the angle pi + bend on the strip's side; less than pi on the other makes that
    // side shorter.
    const double angle = totalAngle(surface_, corner.vertex) - std::numbers::pi - corner.bend;
    Strip candidate = route.strip;
    if (angle >= std::numbers::pi || !rerouteAround(corner.vertex, corner.portal, candidate)) {
        return std::nullopt;
    }
    removeSpikes(candidate);
    trim(candidate, ends.startFaces, ends.goalFaces);
    Route other = routeIn(std::move(candidate), ends);
    if (other.cost < route.cost * (1.0 - kShorter)) {
        return other;
    }
    return std::nullopt;
}

// Sharpest corner first. Each accepted move makes the path cheaper, so this ends; a corner whose
// other side is not cheaper is left alone.
void GeodesicPathFinder::straighten(Route& route, const Ends& ends) {
    std::vector<int> settled;
    while (true) {
        const StripPath::Corner* sharpest = nullptr;
        for (const StripPath::Corner& corner : route.path.corners) {
            if (corner.bend > kStraight && !contains(settled, corner.vertex) &&
                (sharpest == nullptr || corner.bend > sharpest->bend)) {
                sharpest = &corner;
            }
        }
        if (sharpest == nullptr) {
            return;
        }
        const int vertex = sharpest->vertex;
        std::optional<Route> other = otherSide(route, *sharpest, ends);
        if (other) {
            route = std::move(*other);
            settled.clear();
        } else {
            settled.push_back(vertex);
        }
    }
}

std::optional<GeodesicPath> GeodesicPathFinder::find(
    const SurfacePoint& start, const SurfacePoint& goal
) {
    std::optional<Strip> strip = search_.find(start, goal);
    if (!strip) {
        return std::nullopt;
    }
    const Ends ends{start, goal, search_.openFacesHolding(start), search_.openFacesHolding(goal)};
    trim(*strip, ends.startFaces, ends.goalFaces);
    Route route = routeIn(std::move(*strip), ends);
    straighten(route, ends);

    GeodesicPath result;
    result.points.push_back(inFace(surface_, start, route.strip.front()));
    for (std::size_t i = 0; i + 1 < route.strip.size(); ++i) {
        const Triangle& face = surface_.faces()[at(route.strip[i])];
        SurfacePoint point{route.strip[i], Vec3::Zero()};
        point.barycentric[cornerOf(face, route.path.lefts[i])] = 1.0 - route.path.crossings[i];
        point.barycentric[cornerOf(face, route.path.rights[i])] = route.path.crossings[i];
        result.points.push_back(point);
    }
    result.points.push_back(inFace(surface_, goal, route.strip.back()));
    for (const SurfacePoint& point : result.points) {
        result.positions.push_back(surface_.position(point));
        if (result.positions.size() > 1) {
            result.length += (result.positions.back() - *(result.positions.end() - 2)).norm();
        }
    }
    return result;
}

}  // namespace bspline_curve
