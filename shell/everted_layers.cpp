// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/everted_layers.h"

#include <Eigen/Geometry>

#include <array>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

constexpr std::size_t kMiddles = 2;
// Tips that enclose less than this share of what the middles do are too near to turning over.
constexpr double kLeastShare = 1e-9;

struct Component {
    std::vector<int> prisms;
    bool isClosed = true;
};

// The component of a prism; marks its prisms as visited.
Component componentOf(
    int first,
    const std::vector<Triangle>& faceNeighbours,
    const std::vector<char>& blocked,
    std::vector<char>& visited
) {
    Component component{{first}};
    visited[at(first)] = 1;
    for (std::size_t i = 0; i < component.prisms.size(); ++i) {
        for (const int there : faceNeighbours[at(component.prisms[i])]) {
            if (there < 0 || blocked[at(there)] != 0) {
                component.isClosed = false;
            } else if (visited[at(there)] == 0) {
                visited[at(there)] = 1;
                component.prisms.push_back(there);
            }
        }
    }
    return component;
}

// Six times the volume that a layer of a closed component encloses.
double volumeOf(
    const Component& component,
    const PillarLayers& layers,
    const std::vector<Prism>& prisms,
    std::size_t layer
) {
    const Vec3& origin =
        layers.point(kMiddles, at(prisms[at(component.prisms.front())].pillars[0]));
    double volume = 0.0;
    for (const int i : component.prisms) {
        const Prism& prism = prisms[at(i)];
        std::array<Vec3, 3> p;
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = layers.point(layer, at(prism.pillars[k])) - origin;
        }
        volume += prism.orientation * p[0].dot(p[1].cross(p[2]));
    }
    return volume;
}

}  // namespace

std::vector<EvertedPrism> findEvertedLayers(
    const PillarLayers& layers,
    const std::vector<Prism>& prisms,
    const std::vector<Triangle>& faceNeighbours,
    const std::vector<char>& blocked
) {
    std::vector<EvertedPrism> everted;
    std::vector<char> visited = blocked;
    for (int first = 0; first < static_cast<int>(prisms.size()); ++first) {
        if (visited[at(first)] != 0) {
            continue;
        }
        const Component component = componentOf(first, faceNeighbours, blocked, visited);
        if (!component.isClosed) {
            continue;
        }
        const double middle = volumeOf(component, layers, prisms, kMiddles);
        for (const int slab : {0, 1}) {
            const double tips = volumeOf(component, layers, prisms, at(slab));
            if (tips * middle > kLeastShare * middle * middle) {
                continue;
            }
            for (const int prism : component.prisms) {
                everted.push_back({prism, slab});
            }
        }
    }
    return everted;
}

}  // namespace bspline_curve
