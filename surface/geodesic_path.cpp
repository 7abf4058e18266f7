// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/geodesic_path.h"

#include "surface/strip_unfolding.h"
#include "surface/surface_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

namespace bspline_curve {
namespace {

// A new path must be shorter by this share to count as shorter.
constexpr double kShorter = 1e-12;
// A path that bends less than this at a vertex counts as straight (radians).
constexpr double kStraight = 1e-9;
constexpr double kFar = std::numeric_limits<double>::infinity();

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

GeodesicPathFinder::GeodesicPathFinder(const Surface& surface, std::vector<char> blocked)
    : surface_(surface),
      blocked_(std::move(blocked)),
      cost_(3 * surface.faces().size(), kFar),
      parent_(3 * surface.faces().size(), -1) {}

bool GeodesicPathFinder::isBlocked(int face) const {
    return !blocked_.empty() && blocked_[at(face)] != 0;
}

std::vector<int> GeodesicPathFinder::openFacesHolding(const SurfacePoint& point) const {
    std::vector<int> faces = facesHolding(surface_, point);
    std::erase_if(faces, [this](int f) { return isBlocked(f); });
    return faces;
}

// NOLINTNEXTLINE(readability-function-size, readability-function-cognitive-complexity)
std::optional<GeodesicPathFinder::Strip> GeodesicPathFinder::findStrip(
    const SurfacePoint& start, const SurfacePoint& goal
) {
    const std::vector<int> startFaces = openFacesHolding(start);
    const std::vector<int> goalFaces = openFacesHolding(goal);
    for (const int f : startFaces) {
        if (contains(goalFaces, f)) {
            return Strip{f};
        }
    }
    const Vec3 from = surface_.position(start);
    const Vec3 to = surface_.position(goal);
    // Node 3 f + k: leaving face f over the edge opposite to its corner k, at the edge's midpoint.
    const auto middle = [this](int node) {
        const Triangle& face = surface_.faces()[at(node / 3)];
        return Vec3(
            0.5 * (surface_.vertices()[at(face[at((node + 1) % 3 == 0 ? 0 : node % 3 + 1)])] +
                   surface_.vertices()[at(face[at((node % 3 + 2) % 3)])])
        );
    };
    using Entry = std::pair<double, int>;  // cost plus distance to the goal; node
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (const int node : touched_) {
        cost_[at(node)] = kFar;
    }
    touched_.clear();
    const auto offer = [&](int node, double cost, const Vec3& position, int parent) {
        const int there = surface_.faceNeighbours()[at(node / 3)][at(node % 3)];
        if (there < 0 || isBlocked(there) || cost >= cost_[at(node)]) {
            return;
        }
        if (cost_[at(node)] == kFar) {
            touched_.push_back(node);
        }
        cost_[at(node)] = cost;
        parent_[at(node)] = parent;
        queue.emplace(cost + (to - position).norm(), node);
    };
    for (const int f : startFaces) {
        for (int k = 0; k < 3; ++k) {
            const Vec3 position = middle(3 * f + k);
            offer(3 * f + k, (position - from).norm(), position, -1);
        }
    }
    while (!queue.empty()) {
        const auto [estimate, node] = queue.top();
        queue.pop();
        const Vec3 here = middle(node);
        if (estimate > cost_[at(node)] + (to - here).norm()) {
            continue;  // found cheaper since
        }
        const int face = surface_.faceNeighbours()[at(node / 3)][at(node % 3)];
        if (contains(goalFaces, face)) {
            Strip strip{face};
            for (int n = node; n >= 0; n = parent_[at(n)]) {
                strip.push_back(n / 3);
            }
            std::reverse(strip.begin(), strip.end());
            return strip;
        }
        for (int k = 0; k < 3; ++k) {
            if (surface_.faceNeighbours()[at(face)][at(k)] != node / 3) {
                const Vec3 next = middle(3 * face + k);
                offer(3 * face + k, cost_[at(node)] + (next - here).norm(), next, node);
            }
        }
    }
    return std::nullopt;
}

// Moves the strip to the other side of a vertex that the path bends around, if that is shorter: if
// the angle on the other side is less than pi. `portal` is the edge between strip[portal] and
// strip[portal + 1] where the path meets it.
bool GeodesicPathFinder::rerouteAround(int vertex, std::size_t portal, Strip& strip) const {
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
        if (next < 0 || isBlocked(next)) {
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

// NOLINTNEXTLINE(readability-function-size, readability-function-cognitive-complexity)
std::optional<GeodesicPath> GeodesicPathFinder::find(
    const SurfacePoint& start, const SurfacePoint& goal
) {
    std::optional<Strip> found = findStrip(start, goal);
    if (!found) {
        return std::nullopt;
    }
    Strip strip = std::move(*found);
    const std::vector<int> startFaces = openFacesHolding(start);
    const std::vector<int> goalFaces = openFacesHolding(goal);
    trim(strip, startFaces, goalFaces);

    const auto pathLength = [&](const StripPath& path, const Strip& faces) {
        double length = 0.0;
        Vec3 from = surface_.position(start);
        for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
            const Vec3 to = (1.0 - path.crossings[i]) * surface_.vertices()[at(path.lefts[i])] +
                            path.crossings[i] * surface_.vertices()[at(path.rights[i])];
            length += (to - from).norm();
            from = to;
        }
        return length + (surface_.position(goal) - from).norm();
    };
    const auto pull = [&](const Strip& faces) {
        return shortestPathInStrip(
            surface_,
            faces,
            inFace(surface_, start, faces.front()),
            inFace(surface_, goal, faces.back())
        );
    };

    StripPath path = pull(strip);
    double length = pathLength(path, strip);
    // Each accepted move shortens the path, so this ends; a corner whose other side is not shorter
    // is left alone.
    std::vector<int> settled;
    while (true) {
        const StripPath::Corner* sharpest = nullptr;
        for (const StripPath::Corner& corner : path.corners) {
            if (corner.bend > kStraight && !contains(settled, corner.vertex) &&
                (sharpest == nullptr || corner.bend > sharpest->bend)) {
                sharpest = &corner;
            }
        }
        if (sharpest == nullptr) {
            break;
        }
        const int vertex = sharpest->vertex;
        Strip candidate = strip;
        // The path has the angle pi + bend on the strip's side; less than pi on the other makes
        // that side shorter.
        const double otherAngle = totalAngle(surface_, vertex) - std::numbers::pi - sharpest->bend;
        if (otherAngle < std::numbers::pi && rerouteAround(vertex, sharpest->portal, candidate)) {
            removeSpikes(candidate);
            trim(candidate, startFaces, goalFaces);
            StripPath other = pull(candidate);
            const double otherLength = pathLength(other, candidate);
            if (otherLength < length * (1.0 - kShorter)) {
                strip.swap(candidate);
                path = std::move(other);
                length = otherLength;
                settled.clear();
                continue;
            }
        }
        settled.push_back(vertex);
    }

    GeodesicPath result;
    result.length = length;
    result.points.push_back(inFace(surface_, start, strip.front()));
    for (std::size_t i = 0; i + 1 < strip.size(); ++i) {
        SurfacePoint point{strip[i], Vec3::Zero()};
        const Triangle& face = surface_.faces()[at(strip[i])];
        point.barycentric[cornerOf(face, path.lefts[i])] = 1.0 - path.crossings[i];
        point.barycentric[cornerOf(face, path.rights[i])] = path.crossings[i];
        result.points.push_back(point);
    }
    result.points.push_back(inFace(surface_, goal, strip.back()));
    for (const SurfacePoint& point : result.points) {
        result.positions.push_back(surface_.position(point));
    }
    return result;
}

}  // namespace bspline_curve
