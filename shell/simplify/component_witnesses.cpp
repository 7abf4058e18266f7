// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/simplify/component_witnesses.h"

#include "shell/prism_components.h"
#include "shell/slab.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace bspline_curve {
namespace {

// Whether a closed prism holds a point.
bool holds(const PrismComplex& complex, const Triangle& pillars, const Vec3& point) {
    const Triangle slots = slotsOf(pillars);
    const int orientation = orientationOf(pillars);
    for (const Level outer : {Level::Top, Level::Bottom}) {
        const auto pointOf = [&](int slot, bool isOuter) -> const Vec3& {
            return complex.point(slots[slot], isOuter ? outer : Level::Middle);
        };
        if (slabHolds(outer == Level::Top ? orientation : -orientation, pointOf, point)) {
            return true;
        }
    }
    return false;
}

}  // namespace

ComponentWitnesses::ComponentWitnesses(const TrackedSurface& surface, const Shell& start) {
    PrismComponents components = findComponents(start.prisms());
    if (components.first.size() < 2) {
        return;
    }
    // A vertex at which several components meet stands for one only where they leave no other.
    constexpr int kNone = -1;
    constexpr int kSeveral = -2;
    std::vector<int> vertexComponents(start.pillars().size(), kNone);
    for (std::size_t f = 0; f < components.componentOf.size(); ++f) {
        const int component = components.componentOf[f];
        for (const int v : surface.extended.faces[f]) {
            int& known = vertexComponents[v];
            if (component >= 0) {
                known = known == kNone || known == component ? component : kSeveral;
            }
        }
    }
    std::vector<int> vertices(components.first.size(), kNone);
    for (std::size_t f = 0; f < components.componentOf.size(); ++f) {
        const int component = components.componentOf[f];
        for (const int v : surface.extended.faces[f]) {
            if (component >= 0 && vertices[component] == kNone &&
                vertexComponents[v] == component) {
                vertices[component] = v;
            }
        }
    }
    for (std::size_t c = 0; c < vertices.size(); ++c) {
        const int v =
            vertices[c] == kNone ? surface.extended.faces[components.first[c]][0] : vertices[c];
        sorted_.push_back({surface.extended.vertices[v], static_cast<int>(c)});
    }
    std::ranges::sort(sorted_, [](const Witness& a, const Witness& b) {
        return std::tuple(a.position.x(), a.component) < std::tuple(b.position.x(), b.component);
    });
    componentOf_ = std::move(components.componentOf);
}

bool ComponentWitnesses::areHeld(
    const PrismComplex& complex, std::span<const Triangle> prisms, int face
) const {
    if (sorted_.empty()) {
        return false;
    }
    const int component = face < 0 ? -1 : componentOf_[face];
    for (const Triangle& pillars : prisms) {
        Vec3 low = complex.point(pillars[0], Level::Middle);
        Vec3 high = low;
        for (const int pillar : pillars) {
            for (const Level level : {Level::Bottom, Level::Middle, Level::Top}) {
                low = low.cwiseMin(complex.point(pillar, level));
                high = high.cwiseMax(complex.point(pillar, level));
            }
        }
        auto next = std::ranges::lower_bound(sorted_, low.x(), {}, [](const Witness& witness) {
            return witness.position.x();
        });
        for (; next != sorted_.end() && next->position.x() <= high.x(); ++next) {
            const Vec3& p = next->position;
            if (next->component != component && (p.array() >= low.array()).all() &&
                (p.array() <= high.array()).all() && holds(complex, pillars, p)) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace bspline_curve
