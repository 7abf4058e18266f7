// SPDX-License-Identifier: GPL-3.0-or-later
#include "sketch/snapping.h"

#include "surface/closest_point.h"
#include "surface/field_on_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <unordered_set>

namespace bspline_curve {
namespace {

class Snapper {
public:
    Snapper(
        const Surface& surface, const SurfacePoint& point, double reach, const SnapOptions& options
    )
        : surface_(surface),
          from_(surface.position(point)),
          squaredReach_(reach * reach),
          leastCosine_(std::cos(options.creaseAngle * std::numbers::pi / 180.0)) {
        collect(point.face);
    }

    [[nodiscard]] bool holds(int face) const {
        return std::ranges::find(faces_, face) != faces_.end();
    }

    [[nodiscard]] bool isNear(const Vec3& p) const {
        return (p - from_).squaredNorm() <= squaredReach_;
    }

    // The nearest point of the edges of a kind.
    [[nodiscard]] Snap nearestEdge() const {
        Snap snap;
        double least = squaredReach_;
        for (const int face : faces_) {
            for (int k = 0; k < 3; ++k) {
                const SnapKind kind = kindOf(face, k);
                if (kind == SnapKind::None) {
                    continue;
                }
                const Triangle& corners = surface_.faces()[face];
                const Vec3& a = surface_.vertices()[corners[(k + 1) % 3]];
                const Vec3 way = surface_.vertices()[corners[(k + 2) % 3]] - a;
                const double s = std::clamp((from_ - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
                const double squared = (a + s * way - from_).squaredNorm();
                if (squared < least) {
                    least = squared;
                    SurfacePoint point{face, Vec3::Zero()};
                    point.barycentric[(k + 1) % 3] = 1.0 - s;
                    point.barycentric[(k + 2) % 3] = s;
                    snap = {kind, point};
                }
            }
        }
        return snap;
    }

    // The vertex with the largest value, if that is large enough.
    [[nodiscard]] Snap highestVertex(
        SnapKind kind, const std::vector<double>& values, double least
    ) const {
        return bestVertex(kind, [&](int v) { return values[v] - least; });
    }

    [[nodiscard]] Snap nearestVertex() const {
        return bestVertex(SnapKind::Vertex, [&](int v) {
            return squaredReach_ - (surface_.vertices()[v] - from_).squaredNorm();
        });
    }

private:
    // Faces within reach, connected to one. Those across the edges of such a face are looked at.
    void collect(int first) {
        std::unordered_set<int> known{first};
        faces_.push_back(first);
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            for (const int next : surface_.faceNeighbours()[faces_[i]]) {
                if (next >= 0 && known.insert(next).second &&
                    closestPointOnTriangle(surface_.vertices(), surface_.faces()[next], from_)
                            .squaredDistance <= squaredReach_) {
                    faces_.push_back(next);
                }
            }
        }
    }

    [[nodiscard]] SnapKind kindOf(int face, int k) const {
        const int beyond = surface_.faceNeighbours()[face][k];
        if (beyond < 0) {
            return SnapKind::Boundary;
        }
        return surface_.faceNormal(face).dot(surface_.faceNormal(beyond)) < leastCosine_
                   ? SnapKind::Crease
                   : SnapKind::None;
    }

    // The vertex within reach with the largest positive merit, if any.
    template <class Merit>
    [[nodiscard]] Snap bestVertex(SnapKind kind, const Merit& merit) const {
        Snap snap;
        double most = 0.0;
        for (const int face : faces_) {
            for (int k = 0; k < 3; ++k) {
                const int v = surface_.faces()[face][k];
                if (isNear(surface_.vertices()[v]) && merit(v) > most) {
                    most = merit(v);
                    snap = {kind, {face, Vec3::Unit(k)}};
                }
            }
        }
        return snap;
    }

    const Surface& surface_;
    Vec3 from_;
    double squaredReach_;
    double leastCosine_;
    std::vector<int> faces_;
};

Snap nearestPick(
    const Surface& surface, const Snapper& snapper, const Sketch& sketch, int own, const Vec3& from
) {
    Snap snap;
    double least = std::numeric_limits<double>::infinity();
    for (int c = 0; c < static_cast<int>(sketch.curves.size()); ++c) {
        if (c == own || sketch.curves[c]->look.isHidden) {
            continue;
        }
        for (const SketchPick& pick : sketch.curves[c]->picks) {
            const double squared = (pick.position - from).squaredNorm();
            if (squared >= least || !snapper.isNear(pick.position)) {
                continue;
            }
            const auto point = surface.provenance().fromInput(pick.point);
            if (point && snapper.holds(point->face)) {
                least = squared;
                snap = {SnapKind::Pick, *point};
            }
        }
    }
    return snap;
}

}  // namespace

const char* nameOf(SnapKind kind) {
    switch (kind) {
        case SnapKind::None:
            return "";
        case SnapKind::Pick:
            return "another pick";
        case SnapKind::Boundary:
            return "a boundary";
        case SnapKind::Crease:
            return "a crease";
        case SnapKind::Ridge:
            return "a ridge";
        case SnapKind::Valley:
            return "a valley";
        case SnapKind::Vertex:
            return "a vertex";
    }
    throw std::logic_error("no kind of snapping");
}

Snap snap(
    const Surface& surface,
    const Sketch& sketch,
    int own,
    const SurfacePoint& point,
    double reach,
    const SnapOptions& options
) {
    const Snapper snapper(surface, point, reach, options);
    Snap found = nearestPick(surface, snapper, sketch, own, surface.position(point));
    if (found.kind == SnapKind::None) {
        found = snapper.nearestEdge();
    }
    if (found.kind == SnapKind::None && !options.ridge.empty()) {
        found = snapper.highestVertex(
            SnapKind::Ridge, *valuesOn(surface, options.ridge), options.leastCrest
        );
    }
    if (found.kind == SnapKind::None && !options.valley.empty()) {
        found = snapper.highestVertex(
            SnapKind::Valley, *valuesOn(surface, options.valley), options.leastCrest
        );
    }
    if (found.kind == SnapKind::None) {
        found = snapper.nearestVertex();
    }
    return found.kind == SnapKind::None ? Snap{SnapKind::None, point} : found;
}

}  // namespace bspline_curve
