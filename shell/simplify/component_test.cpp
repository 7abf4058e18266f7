// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/simplify/component_test.h"

#include "shell/prism_graph.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace bspline_curve {
namespace {

// Least share of the larger volume that the other layer encloses: far above the rounding of a
// million replacements.
constexpr double kLeastVolumeShare = 1e-9;

}  // namespace

ComponentTest::ComponentTest(const TrackedSurface& surface, const Shell& start) {
    PrismComponents found = findComponents(start.prisms());
    for (int c = 0; c < found.count(); ++c) {
        const int pillar = start.prisms()[found.first[c]].pillars[0];
        components_.push_back({start.pillars()[pillar].middle, found.isClosed[c] != 0, {}});
    }
    componentOf_ = std::move(found.componentOf);
    volumes_.resize(componentOf_.size());
    if (components_.size() > 1) {
        findRepresentatives(surface, found.first);
    }
}

// A vertex at which several components meet stands for one only where they leave no other.
void ComponentTest::findRepresentatives(
    const TrackedSurface& surface, const std::vector<int>& firstPrisms
) {
    constexpr int kNone = -1;
    constexpr int kSeveral = -2;
    const auto forEachCorner = [&](const auto& visit) {
        for (std::size_t f = 0; f < componentOf_.size(); ++f) {
            for (const int v : surface.extended.faces[f]) {
                if (componentOf_[f] >= 0) {
                    visit(v, componentOf_[f]);
                }
            }
        }
    };
    std::vector<int> vertexComponents(surface.extended.vertices.size(), kNone);
    forEachCorner([&](int v, int component) {
        int& known = vertexComponents[v];
        known = known == kNone || known == component ? component : kSeveral;
    });
    std::vector<int> vertices(components_.size(), kNone);
    forEachCorner([&](int v, int component) {
        if (vertices[component] == kNone && vertexComponents[v] == component) {
            vertices[component] = v;
        }
    });
    for (std::size_t c = 0; c < vertices.size(); ++c) {
        const int v =
            vertices[c] == kNone ? surface.extended.faces[firstPrisms[c]][0] : vertices[c];
        sorted_.push_back({surface.extended.vertices[v], static_cast<int>(c)});
    }
    std::ranges::sort(sorted_, {}, [](const Representative& r) {
        return std::tuple(r.position.x(), r.component);
    });
}

void ComponentTest::enter(const PrismComplex& complex, int prism, int face) {
    componentOf_[prism] = componentOf_[face];  // ids are at most faces
    Component& component = components_[componentOf_[prism]];
    const Volumes own = volumesOf(complex, complex.pillarsOf(prism), component.nearby);
    component.volumes.bottom += own.bottom;
    component.volumes.top += own.top;
    volumes_[prism] = own;
}

bool ComponentTest::replace(
    const PrismComplex& complex, std::span<const Triangle> fresh, std::span<const int> old
) {
    component_ = componentOf_[old.front()];
    const bool holdsOthers = !sorted_.empty() && std::ranges::any_of(fresh, [&](const Triangle& p) {
        return holdsOther(complex, p);
    });
    return !holdsOthers && keepsOrientation(complex, fresh, old);
}

// Whether a closed prism holds the representative of another component.
bool ComponentTest::holdsOther(const PrismComplex& complex, const Triangle& pillars) const {
    Eigen::AlignedBox3d box;
    for (const int pillar : pillars) {
        for (const Level level : {Level::Bottom, Level::Middle, Level::Top}) {
            box.extend(complex.point(pillar, level));
        }
    }
    const Triangle slots = slotsOf(pillars);
    const int orientation = orientationOf(pillars);
    auto next = std::ranges::lower_bound(sorted_, box.min().x(), {}, [](const Representative& r) {
        return r.position.x();
    });
    for (; next != sorted_.end() && next->position.x() <= box.max().x(); ++next) {
        const Vec3& p = next->position;
        if (next->component != component_ && box.contains(p) &&
            (Slab{complex.points, slots, orientation, 0}.holds(p) ||
             Slab{complex.points, slots, orientation, 1}.holds(p))) {
            return true;
        }
    }
    return false;
}

bool ComponentTest::keepsOrientation(
    const PrismComplex& complex, std::span<const Triangle> fresh, std::span<const int> old
) {
    freshVolumes_.assign(fresh.size(), {});
    Component& component = components_[component_];
    if (!component.isClosed) {
        return true;
    }
    Volumes after = component.volumes;
    for (const int prism : old) {
        after.bottom -= volumes_[prism].bottom;
        after.top -= volumes_[prism].top;
    }
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        freshVolumes_[i] = volumesOf(complex, fresh[i], component.nearby);
        after.bottom += freshVolumes_[i].bottom;
        after.top += freshVolumes_[i].top;
    }
    const double larger = std::max(std::abs(after.bottom), std::abs(after.top));
    if (after.bottom * after.top <= kLeastVolumeShare * larger * larger) {
        return false;
    }
    component.volumes = after;
    return true;
}

void ComponentTest::setId(int prism, std::size_t indexInFresh) {
    if (prism >= static_cast<int>(volumes_.size())) {
        volumes_.resize(prism + 1);
        componentOf_.resize(prism + 1);
    }
    volumes_[prism] = freshVolumes_[indexInFresh];
    componentOf_[prism] = component_;
}

ComponentTest::Volumes ComponentTest::volumesOf(
    const PrismComplex& complex, const Triangle& pillars, const Vec3& nearby
) {
    const auto volume = [&](Level level) {
        const Vec3 a = complex.point(pillars[0], level) - nearby;
        const Vec3 b = complex.point(pillars[1], level) - nearby;
        const Vec3 c = complex.point(pillars[2], level) - nearby;
        return a.dot(b.cross(c));
    };
    return {volume(Level::Bottom), volume(Level::Top)};
}

}  // namespace bspline_curve
