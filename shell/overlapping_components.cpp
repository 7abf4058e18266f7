// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/overlapping_components.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <tuple>

namespace bspline_curve {
namespace {

// Least share of the volume of the middle that top and bottom enclose: below, rounding may have
// turned the sign over.
constexpr double kLeastVolumeShare = 1e-9;

// A point of the pillar that stands for a component.
struct Representative {
    double x;
    int component;
    Level level;
    int pillar;
};

// Sorted along x.
std::vector<Representative> representatives(
    const PillarPoints& points, const std::vector<Prism>& prisms, const PrismComponents& components
) {
    std::vector<Representative> sorted;
    for (int c = 0; c < components.count(); ++c) {
        const int pillar = prisms[components.first[c]].pillars[0];
        for (const Level level : {Level::Bottom, Level::Middle, Level::Top}) {
            sorted.push_back({points.at(pillar, level).x(), c, level, pillar});
        }
    }
    std::ranges::sort(sorted, {}, [](const Representative& r) {
        return std::tuple(r.x, r.component, r.level);
    });
    return sorted;
}

// Six times the volume that each layer of a component encloses, by level.
using Volumes = std::array<double, PillarPoints::kLevels>;

std::vector<Volumes> layerVolumes(
    const PillarPoints& points, const std::vector<Prism>& prisms, const PrismComponents& components
) {
    std::vector<Volumes> volumes(components.count(), Volumes{});
    for (std::size_t i = 0; i < prisms.size(); ++i) {
        const int component = components.componentOf[i];
        if (component < 0 || components.isClosed[component] == 0) {
            continue;
        }
        // Relative to a point near by, for little rounding.
        const Vec3& nearby =
            points.at(prisms[components.first[component]].pillars[0], Level::Middle);
        for (const Level level : {Level::Bottom, Level::Middle, Level::Top}) {
            const auto& [i0, i1, i2] = layerTriangle(prisms[i].pillars, level);
            const Vec3 a = points.points[i0] - nearby;
            const Vec3 b = points.points[i1] - nearby;
            const Vec3 c = points.points[i2] - nearby;
            volumes[component][static_cast<std::size_t>(level)] +=
                prisms[i].orientation * a.dot(b.cross(c));
        }
    }
    return volumes;
}

}  // namespace

std::vector<PrismSlab> findNestedSlabs(
    const PillarPoints& points, const std::vector<Prism>& prisms, const PrismComponents& components
) {
    std::vector<PrismSlab> nested;
    if (components.count() < 2) {
        return nested;
    }
    const std::vector<Representative> sorted = representatives(points, prisms, components);
    for (int i = 0; i < static_cast<int>(prisms.size()); ++i) {
        const Prism& prism = prisms[i];
        for (int slab = 0; prism.orientation != 0 && slab < 2; ++slab) {
            const auto x = [&](int slot, Level level) {
                return points.at(prism.pillars[slot], level).x();
            };
            const Level outer = kOuterLevels[slab];
            const auto [low, high] = std::minmax(
                {x(0, Level::Middle),
                 x(1, Level::Middle),
                 x(2, Level::Middle),
                 x(0, outer),
                 x(1, outer),
                 x(2, outer)}
            );
            const Slab tetrahedra{points, prism.pillars, prism.orientation, slab};
            for (auto next = std::ranges::lower_bound(sorted, low, {}, &Representative::x);
                 next != sorted.end() && next->x <= high;
                 ++next) {
                if (next->component != components.componentOf[i] &&
                    std::ranges::count(prism.pillars, next->pillar) == 0 &&
                    tetrahedra.holds(points.at(next->pillar, next->level))) {
                    nested.push_back({i, slab});
                }
            }
        }
    }
    return nested;
}

std::vector<PrismSlab> findInvertedSlabs(
    const PillarPoints& points, const std::vector<Prism>& prisms, const PrismComponents& components
) {
    const std::vector<Volumes> volumes = layerVolumes(points, prisms, components);
    std::vector<PrismSlab> inverted;
    for (int i = 0; i < static_cast<int>(prisms.size()); ++i) {
        const int component = components.componentOf[i];
        if (component < 0 || components.isClosed[component] == 0) {
            continue;
        }
        const auto volume = [&](Level level) {
            return volumes[component][static_cast<std::size_t>(level)];
        };
        const double middle = volume(Level::Middle);
        for (const int slab : {0, 1}) {
            if (volume(kOuterLevels[slab]) * middle <= kLeastVolumeShare * middle * middle) {
                inverted.push_back({i, slab});
            }
        }
    }
    return inverted;
}

}  // namespace bspline_curve
