// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/nested_components.h"

#include "shell/prism_components.h"
#include "shell/slab.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace bspline_curve {
namespace {

// Whether the closed slab holds a point.
bool holds(const PillarLayers& layers, const Prism& prism, int slab, const Vec3& point) {
    return slabHolds(
        slab == 0 ? prism.orientation : -prism.orientation,
        [&](int slot, bool outer) -> const Vec3& {
            return layers.point(outer ? slab : 2, prism.pillars[slot]);
        },
        point
    );
}

// A middle or tip that stands for its component, or for a layer of it.
struct Candidate {
    double x;
    int component;
    std::size_t layer;
};

}  // namespace

std::vector<NestedVertex> findNestedComponents(
    const PillarLayers& layers,
    const std::vector<Prism>& prisms,
    const std::vector<Triangle>& faceNeighbours,
    const std::vector<char>& blocked
) {
    const PrismComponents components = findComponents(faceNeighbours, blocked);
    const auto vertexOf = [&](int component) {
        return prisms[components.first[component]].pillars[0];
    };
    std::vector<NestedVertex> nested;
    if (components.count() < 2) {
        return nested;
    }
    // Middles and tips of a vertex of each component along x; each slab looks at those in its
    // range.
    std::vector<Candidate> sorted;
    for (int c = 0; c < components.count(); ++c) {
        for (std::size_t layer = 0; layer < 3; ++layer) {
            sorted.push_back({layers.point(layer, vertexOf(c)).x(), c, layer});
        }
    }
    std::ranges::sort(sorted, {}, [](const Candidate& candidate) {
        return std::tuple(candidate.x, candidate.component, candidate.layer);
    });
    for (std::size_t f = 0; f < prisms.size(); ++f) {
        if (blocked[f] != 0) {
            continue;
        }
        for (const int slab : {0, 1}) {
            const auto x = [&](int slot, std::size_t layer) {
                return layers.point(layer, prisms[f].pillars[slot]).x();
            };
            const auto [low, high] =
                std::minmax({x(0, 2), x(1, 2), x(2, 2), x(0, slab), x(1, slab), x(2, slab)});
            for (auto next = std::ranges::lower_bound(sorted, low, {}, &Candidate::x);
                 next != sorted.end() && next->x <= high;
                 ++next) {
                const int vertex = vertexOf(next->component);
                const Vec3& point = layers.point(next->layer, vertex);
                if (next->component != components.componentOf[f] &&
                    std::ranges::count(prisms[f].pillars, vertex) == 0 &&
                    holds(layers, prisms[f], slab, point)) {
                    nested.push_back({vertex, static_cast<int>(f), slab});
                }
            }
        }
    }
    return nested;
}

}  // namespace bspline_curve
