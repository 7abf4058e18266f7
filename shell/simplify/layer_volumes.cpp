// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/simplify/layer_volumes.h"

#include "shell/prism_components.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bspline_curve {
namespace {

// Either layer encloses more than this share of what the other one does: far above the rounding of
// a million replacements.
constexpr double kLeastShare = 1e-9;

}  // namespace

LayerVolumes::LayerVolumes(const Shell& start) {
    PrismComponents found = findComponents(start.prisms());
    for (int c = 0; c < found.count(); ++c) {
        const int pillar = start.prisms()[found.first[c]].pillars[0];
        components_.push_back({start.pillars()[pillar].middle, found.isClosed[c] != 0, {}});
    }
    componentOf_ = std::move(found.componentOf);
    volumes_.resize(componentOf_.size());
}

void LayerVolumes::enter(const PrismComplex& complex, int prism, int face) {
    componentOf_[prism] = componentOf_[face];  // ids are at most faces
    Component& component = components_[componentOf_[prism]];
    const Volumes own = volumesOf(complex, complex.pillarsOf(prism), component.origin);
    component.volumes.bottom += own.bottom;
    component.volumes.top += own.top;
    volumes_[prism] = own;
}

bool LayerVolumes::replace(
    const PrismComplex& complex, std::span<const Triangle> fresh, std::span<const int> old
) {
    freshComponent_ = componentOf_[old.front()];
    fresh_.assign(fresh.size(), {});
    Component& component = components_[freshComponent_];
    if (!component.isClosed) {
        return true;
    }
    Volumes after = component.volumes;
    for (const int prism : old) {
        after.bottom -= volumes_[prism].bottom;
        after.top -= volumes_[prism].top;
    }
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        fresh_[i] = volumesOf(complex, fresh[i], component.origin);
        after.bottom += fresh_[i].bottom;
        after.top += fresh_[i].top;
    }
    const double larger = std::max(std::abs(after.bottom), std::abs(after.top));
    if (after.bottom * after.top <= kLeastShare * larger * larger) {
        return false;
    }
    component.volumes = after;
    return true;
}

void LayerVolumes::setId(int prism, std::size_t indexInFresh) {
    if (prism >= static_cast<int>(volumes_.size())) {
        volumes_.resize(prism + 1);
        componentOf_.resize(prism + 1);
    }
    volumes_[prism] = fresh_[indexInFresh];
    componentOf_[prism] = freshComponent_;
}

LayerVolumes::Volumes LayerVolumes::volumesOf(
    const PrismComplex& complex, const Triangle& pillars, const Vec3& origin
) const {
    const auto volume = [&](Level level) {
        const Vec3 a = complex.point(pillars[0], level) - origin;
        const Vec3 b = complex.point(pillars[1], level) - origin;
        const Vec3 c = complex.point(pillars[2], level) - origin;
        return a.dot(b.cross(c));
    };
    return {volume(Level::Bottom), volume(Level::Top)};
}

}  // namespace bspline_curve
