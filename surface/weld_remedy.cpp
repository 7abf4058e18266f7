// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/weld_remedy.h"

#include "bspline_curve/progress.h"
#include "surface/near_vertices.h"
#include "surface/picks.h"
#include "surface/repair.h"
#include "utility/disjoint_sets.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace bspline_curve {
namespace {

constexpr std::array kDistances = {
    1e-6, 2e-6, 5e-6, 1e-5, 2e-5, 5e-5, 1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 1e-2
};
/// So many are tried on the whole mesh.
constexpr int kMostTries = 3;

/// The edges of boundaries, and what becomes of them where vertices are joined.
class BoundaryEdges {
public:
    explicit BoundaryEdges(const Surface& surface)
        : surface_(surface), ids_(indicesWhere<int>(surface.vertices().size(), [&](std::size_t v) {
              return surface.isBoundaryVertex(static_cast<int>(v));
          })) {
        for (const int v : ids_) {
            positions_.push_back(surface.vertices()[v]);
        }
        for (int f = 0; f < surface.faceCount(); ++f) {
            const Triangle& face = surface.faces()[f];
            for (int k = 0; k < 3; ++k) {
                if (surface.faceNeighbours()[f][k] < 0) {
                    edges_.push_back(
                        {indexIn(ids_, face[(k + 1) % 3]),
                         indexIn(ids_, face[(k + 2) % 3]),
                         surface.faceComponents()[f]}
                    );
                }
            }
        }
    }

    /// Components that share an edge where vertices within a distance are one.
    [[nodiscard]] DisjointSets joined(double distance) const {
        DisjointSets components(surface_.componentCount());
        DisjointSets near = nearVertices(positions_, distance);
        std::vector<std::tuple<int, int, int>> found;  // vertices, component
        for (const auto& [a, b, component] : edges_) {
            const auto [low, high] = std::minmax({near.find(a), near.find(b)});
            if (low != high) {
                found.emplace_back(low, high, component);
            }
        }
        std::ranges::sort(found);
        for (std::size_t i = 1; i < found.size(); ++i) {
            const auto& [low, high, component] = found[i];
            const auto& [lowBefore, highBefore, before] = found[i - 1];
            if (low == lowBefore && high == highBefore) {
                components.unite(component, before);
            }
        }
        return components;
    }

private:
    const Surface& surface_;
    std::vector<int> ids_;  // of the vertices, ascending
    std::vector<Vec3> positions_;
    std::vector<std::array<int, 3>> edges_;  // two of these vertices, component
};

/// Whether picks lie on one component once vertices within so many diagonals are joined.
bool helps(
    const TriangleMesh& mesh,
    double distance,
    const std::vector<Vec3>& picks,
    bool closed,
    const Progress& progress
) {
    try {
        const Surface surface(repairMesh(mesh, distance).mesh, progress);
        const TriangleTree tree(surface.vertices(), surface.faces(), progress);
        static_cast<void>(locatePicks(surface, tree, picks, closed));
        return true;
    } catch (const InputError&) {
        return false;
    }
}

}  // namespace

Remedy weldFor(
    const Surface& surface,
    const TriangleTree& tree,
    const std::vector<Vec3>& picks,
    bool closed,
    const Progress& progress
) {
    std::vector<int> components;
    std::vector<Vec3> places;  // on the surface, however far from it picks may be
    for (const Vec3& pick : picks) {
        const TriangleTree::Closest closest = tree.closestPoint(pick);
        components.push_back(surface.faceComponents()[closest.point.face]);
        places.push_back(closest.position);
    }
    const BoundaryEdges boundaries(surface);
    const Progress untilCancelled = [&](double, const char* stage) {
        report(progress, 1.0, stage);  // no more of the work follows
        return true;
    };
    int tries = 0;
    for (const double distance : kDistances) {
        report(progress, 1.0, "looking for gaps");
        DisjointSets joined = boundaries.joined(distance * surface.diagonal());
        const bool mayHelp = std::ranges::all_of(components, [&](int component) {
            return joined.find(component) == joined.find(components.front());
        });
        if (!mayHelp) {
            continue;
        }
        if (helps(surface.mesh(), distance, places, closed, untilCancelled)) {
            return {.kind = Remedy::Kind::Weld, .distance = distance};
        }
        ++tries;
        if (tries == kMostTries) {
            break;
        }
    }
    return {};
}

}  // namespace bspline_curve
