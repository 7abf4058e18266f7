// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/lines_over_parted_edges.h"

#include "bspline_curve/error.h"
#include "surface/face_adjacency.h"
#include "surface/rejoining.h"
#include "surface/strict_line.h"
#include "surface/surface_point.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

namespace bspline_curve {

namespace {

bool hasAll(const Triangle& face, const std::vector<int>& vertices) {
    return std::ranges::all_of(vertices, [&](int v) { return cornerOf(face, v) >= 0; });
}

/// Follows a polyline over faces whose vertices are the roots of those of the surface.
class LineFollower {
public:
    LineFollower(const Surface& surface, const std::vector<int>& roots, const PartedEdges& parted)
        : surface_(surface),
          parted_(parted),
          mesh_{.vertices = surface.vertices(), .faces = facesBeforeParting(surface.mesh(), roots)},
          facesAt_(listFacesAtVertices(mesh_)) {}

    /// Its steps from face to face, in their order, whatever mending has parted there; none where a
    /// segment lies in no face. `line`: with the surface's own faces.
    [[nodiscard]] std::optional<std::vector<Step>> follow(const SurfacePolyline& line) {
        steps_.clear();
        const std::vector<SurfacePoint>& points = line.surfacePoints;
        const std::size_t segments = points.size() - (line.closed ? 0 : 1);
        int first = -1;
        int face = -1;
        for (std::size_t i = 0; i < segments; ++i) {
            const int next = faceOf(points[i], points[(i + 1) % points.size()], face);
            if (next < 0) {
                return std::nullopt;
            }
            if (face < 0) {
                first = next;
            } else if (!pass(points[i], face, next)) {
                return std::nullopt;
            }
            face = next;
        }
        if (line.closed && !pass(points.front(), face, first)) {
            return std::nullopt;
        }
        return std::move(steps_);
    }

private:
    /// The vertices that a point depends on.
    [[nodiscard]] std::vector<int> supportOf(const SurfacePoint& point) const {
        std::vector<int> support;
        for (int k = 0; k < 3; ++k) {
            if (point.barycentric[k] > kOnEdgeBarycentric) {
                support.push_back(mesh_.faces[point.face][k]);
            }
        }
        return support;
    }

    [[nodiscard]] std::span<const int> facesAround(int vertex) const {
        const int first = facesAt_.offsets[vertex];
        const int last = facesAt_.offsets[vertex + 1];
        return std::span(facesAt_.faces).subspan(first, last - first);
    }

    /// A face that holds a segment: the given one or those of its ends, where they do; or -1.
    [[nodiscard]] int faceOf(const SurfacePoint& from, const SurfacePoint& to, int before) const {
        std::vector<int> support = supportOf(from);
        std::ranges::copy(supportOf(to), std::back_inserter(support));
        const auto holds = [&](int face) {
            return face >= 0 && hasAll(mesh_.faces[face], support);
        };
        for (const int face : {before, from.face, to.face}) {
            if (holds(face)) {
                return face;
            }
        }
        const std::span<const int> around = facesAround(support.front());
        const auto found = std::ranges::find_if(around, holds);
        return found == around.end() ? -1 : *found;
    }

    /// Adds the steps from a face to another one at a point of both.
    [[nodiscard]] bool pass(const SurfacePoint& at, int from, int to) {
        if (from == to) {
            return true;
        }
        const std::vector<int> support = supportOf(at);
        if (support.size() == 1) {
            return passRound(support[0], from, to);
        }
        if (support.size() != 2) {
            return false;
        }
        const Triangle& face = mesh_.faces[at.face];
        addStep(from, to, support, at.barycentric[cornerOf(face, support[1])]);
        return true;
    }

    /// `share`: of the edge, from its first end.
    void addStep(int from, int to, const std::vector<int>& edge, double share) {
        const auto sideAt = [&](int face) {
            const Triangle& corners = mesh_.faces[face];
            const int next = (cornerOf(corners, edge[0]) + 1) % 3;
            const int k = corners[next] == edge[1] ? (next + 1) % 3 : next;
            return sideOf(face, k);
        };
        const auto key = [&](int v) {
            const Vec3& p = mesh_.vertices[v];
            return std::tuple(p.x(), p.y(), p.z());
        };
        const bool isLow = key(edge[0]) < key(edge[1]);
        const int side = sideAt(from);
        steps_.push_back({side, sideAt(to), isLow ? share : 1.0 - share, parted_.edgeAt(side)});
    }

    /// Over edges at a vertex: as few parted ones as can be, and then as few as can be.
    [[nodiscard]] bool passRound(int vertex, int from, int to) {
        struct Arrival {
            int cost, before;
            std::vector<int> edge;
        };

        const int parting = static_cast<int>(facesAround(vertex).size());
        std::map<int, Arrival> arrivals{{from, {0, -1, {}}}};
        std::deque<int> open{from};
        while (!open.empty()) {
            const int face = open.front();
            open.pop_front();
            const int cost = arrivals.at(face).cost;
            for (const int other : facesAround(vertex)) {
                for (const int end : mesh_.faces[face]) {
                    if (other == face || end == vertex || cornerOf(mesh_.faces[other], end) < 0) {
                        continue;
                    }
                    const bool isJoined =
                        std::ranges::count(surface_.faceNeighbours()[face], other) > 0;
                    const int there = cost + (isJoined ? 1 : parting);
                    const auto [arrival, isNew] = arrivals.try_emplace(other);
                    if (isNew || there < arrival->second.cost) {
                        arrival->second = {there, face, {vertex, end}};
                        open.push_back(other);
                    }
                }
            }
        }
        if (!arrivals.contains(to)) {
            return false;
        }
        std::vector<int> way{to};
        while (way.back() != from) {
            way.push_back(arrivals.at(way.back()).before);
        }
        for (std::size_t i = way.size() - 1; i > 0; --i) {
            addStep(way[i], way[i - 1], arrivals.at(way[i - 1]).edge, 0.0);
        }
        return true;
    }

    const Surface& surface_;
    const PartedEdges& parted_;
    TriangleMesh mesh_;
    VertexFaces facesAt_;
    std::vector<Step> steps_;
};

/// Goes straight on from part to part of one face of the input.
class PartWalk {
public:
    PartWalk(const Surface& surface, SurfacePoint from)
        : surface_(surface), provenance_(surface.provenance()), at_(std::move(from)) {}

    /// The points on edges between parts that lie before `to`, on the input; none where that is not
    /// in a part of the same face.
    [[nodiscard]] std::optional<std::vector<SurfacePoint>> to(const SurfacePoint& to, int part) {
        const std::vector<int> goals = facesHolding(surface_, to);
        const Vec3 goal = provenance_.toInput(inFace(surface_, to, part)).barycentric;
        std::vector<SurfacePoint> passed;
        const int face = provenance_.inputFace(at_.face);
        std::size_t left = provenance_.facesFromInput(std::span(&face, 1)).size();
        while (std::ranges::count(goals, at_.face) == 0) {
            if (--left == 0) {
                return std::nullopt;  // rounding led back to a part
            }
            Eigen::Matrix3d corners;
            for (int k = 0; k < 3; ++k) {
                const SurfacePoint corner{.face = at_.face, .barycentric = Vec3::Unit(k)};
                corners.col(k) = provenance_.toInput(corner).barycentric;
            }
            if (!leave(corners.inverse() * goal, passed)) {
                return std::nullopt;
            }
        }
        return passed;
    }

private:
    /// On to the next part, on the way to a place outside of this one.
    bool leave(const Vec3& goal, std::vector<SurfacePoint>& passed) {
        Vec3& here = at_.barycentric;
        int exit = -1;
        double share = 1.0;
        for (int k = 0; k < 3; ++k) {
            const double reached = here[k] / (here[k] - goal[k]);
            if (goal[k] < 0.0 && reached < share) {
                exit = k;
                share = reached;
            }
        }
        const int next = exit < 0 ? -1 : surface_.faceNeighbours()[at_.face][exit];
        if (next < 0 || provenance_.inputFace(next) != provenance_.inputFace(at_.face)) {
            return false;
        }
        here = (here + share * (goal - here)).cwiseMax(0.0);
        here[exit] = 0.0;
        here /= here.sum();
        if (share > 0.0) {
            passed.push_back(provenance_.toInput(at_));
        }
        at_ = inFace(surface_, at_, next);
        return true;
    }

    const Surface& surface_;
    const Provenance& provenance_;
    SurfacePoint at_;
};

/// Between two points of a surface, those where the way leaves a part of a face of the input.
std::vector<SurfacePoint> pointsBetween(
    const Surface& surface, const SurfacePoint& from, const SurfacePoint& to
) {
    if (commonFace(surface, from, to) >= 0) {
        return {};
    }
    const std::vector<int> goals = facesHolding(surface, to);
    for (const int start : facesHolding(surface, from)) {
        for (const int goal : goals) {
            const Provenance& provenance = surface.provenance();
            if (provenance.inputFace(start) == provenance.inputFace(goal)) {
                auto passed = PartWalk(surface, inFace(surface, from, start)).to(to, goal);
                if (passed) {
                    return *std::move(passed);
                }
            }
        }
    }
    return {};
}

/// With the surface's faces; none where one of them was removed, or there are not two points.
std::optional<SurfacePolyline> ownLine(const Surface& surface, SurfacePolyline line) {
    for (SurfacePoint& point : line.surfacePoints) {
        const std::optional<SurfacePoint> there = surface.provenance().fromInput(point);
        if (!there) {
            return std::nullopt;
        }
        point = *there;
    }
    return line.surfacePoints.size() < 2 ? std::nullopt : std::optional(std::move(line));
}

/// A polyline of the input with further points where it passes from one part of a face of that to
/// another one.
SurfacePolyline dividedLine(const Surface& surface, const SurfacePolyline& line) {
    const std::optional<SurfacePolyline> own = ownLine(surface, line);
    if (!own || isStrict(surface, *own)) {
        return line;
    }
    SurfacePolyline divided;
    divided.closed = line.closed;
    const std::size_t count = line.points.size();
    for (std::size_t i = 0; i < count; ++i) {
        divided.surfacePoints.push_back(line.surfacePoints[i]);
        divided.points.push_back(line.points[i]);
        if (i + 1 < count || line.closed) {
            for (const SurfacePoint& point : pointsBetween(
                     surface, own->surfacePoints[i], own->surfacePoints[(i + 1) % count]
                 )) {
                divided.surfacePoints.push_back(point);
                divided.points.push_back(positionOf(surface.input(), point));
            }
        }
    }
    return divided;
}

}  // namespace

void checkLine(const Surface& surface, const SurfacePolyline& line, const std::string& name) {
    const std::optional<SurfacePolyline> own = ownLine(surface, line);
    const std::vector<int> roots = surface.provenance().vertexRoots();
    const auto isInFaces = [&] {
        const PartedEdges parted(surface, roots);
        return LineFollower(surface, roots, parted).follow(*own).has_value();
    };
    if (!own || roots.empty() || isStrict(surface, *own) || !isInFaces()) {
        static_cast<void>(strictLine(surface, line, name));
    }
}

JoinedLines joinedFor(
    const std::shared_ptr<const Surface>& surface, std::span<const SurfacePolyline> lines
) {
    JoinedLines result{.surface = surface, .lines = {lines.begin(), lines.end()}};
    const std::vector<int> roots = surface->provenance().vertexRoots();
    if (roots.empty()) {
        return result;
    }
    std::vector<SurfacePolyline> own;
    bool areStrict = true;
    for (const SurfacePolyline& line : lines) {
        if (std::optional<SurfacePolyline> there = ownLine(*surface, line)) {
            own.push_back(*std::move(there));
            areStrict = areStrict && isStrict(*surface, own.back());
        }
    }
    if (areStrict) {
        return result;
    }
    const PartedEdges parted(*surface, roots);
    LineFollower follower(*surface, roots, parted);
    std::vector<Step> steps;
    for (const SurfacePolyline& line : own) {
        if (const std::optional<std::vector<Step>> more = follower.follow(line)) {
            steps.insert(steps.end(), more->begin(), more->end());
        }
    }
    MeshRepair again = rejoined(surface->mesh(), roots, parted, passagesOf(steps));
    TriangleMesh mesh = std::move(again.mesh);
    Provenance provenance(surface->provenance(), surface->mesh(), again);
    try {
        result.surface = std::make_shared<const Surface>(std::move(mesh), std::move(provenance));
    } catch (const InputError&) {
        return result;  // it is none with these passages
    }
    for (SurfacePolyline& line : result.lines) {
        line = dividedLine(*result.surface, line);
    }
    return result;
}

}  // namespace bspline_curve
