// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/everted_layers.h"

#include "shell/prism_components.h"

#include <Eigen/Geometry>

#include <array>

namespace bspline_curve {
namespace {

constexpr std::size_t kMiddles = 2;
// Tips that enclose less than this share of what the middles do are too near to turning over.
constexpr double kLeastShare = 1e-9;

// Six times the volume that each layer of a component encloses.
using Volumes = std::array<double, 3>;

std::vector<Volumes> volumesOf(
    const PrismComponents& components, const PillarLayers& layers, const std::vector<Prism>& prisms
) {
    std::vector<Volumes> volumes(components.first.size(), Volumes{});
    for (std::size_t i = 0; i < prisms.size(); ++i) {
        const int component = components.componentOf[i];
        if (component < 0 || components.isClosed[component] == 0) {
            continue;
        }
        // Near by, for little rounding.
        const int originPillar = prisms[components.first[component]].pillars[0];
        const Vec3& origin = layers.point(kMiddles, originPillar);
        for (std::size_t layer = 0; layer < 3; ++layer) {
            std::array<Vec3, 3> p;
            for (std::size_t k = 0; k < 3; ++k) {
                p[k] = layers.point(layer, prisms[i].pillars[k]) - origin;
            }
            volumes[component][layer] += prisms[i].orientation * p[0].dot(p[1].cross(p[2]));
        }
    }
    return volumes;
}

}  // namespace

std::vector<EvertedPrism> findEvertedLayers(
    const PillarLayers& layers,
    const std::vector<Prism>& prisms,
    const std::vector<Triangle>& faceNeighbours,
    const std::vector<char>& blocked
) {
    const PrismComponents components = findComponents(faceNeighbours, blocked);
    const std::vector<Volumes> volumes = volumesOf(components, layers, prisms);
    std::vector<EvertedPrism> everted;
    for (std::size_t i = 0; i < prisms.size(); ++i) {
        const int component = components.componentOf[i];
        if (component < 0 || components.isClosed[component] == 0) {
            continue;
        }
        const Volumes& volume = volumes[component];
        for (const int slab : {0, 1}) {
            if (volume[slab] * volume[kMiddles] <=
                kLeastShare * volume[kMiddles] * volume[kMiddles]) {
                everted.push_back({static_cast<int>(i), slab});
            }
        }
    }
    return everted;
}

}  // namespace bspline_curve
