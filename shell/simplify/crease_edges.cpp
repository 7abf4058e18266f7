// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/simplify/crease_edges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace bspline_curve {
namespace {

// Sharp: normals turn by more than this.
constexpr double kSharpTurn = 50.0 * std::numbers::pi / 180.0;
// A set of sharp edges is a feature where it is longer than this share of the diagonal.
constexpr double kLeastFeature = 0.12;

}  // namespace

std::vector<std::pair<int, int>> findCreases(const ExtendedSurface& extended) {
    const auto normalOf = [&](int f) -> Vec3 {
        const Triangle& face = extended.faces[f];
        return (extended.vertices[face[1]] - extended.vertices[face[0]])
            .cross(extended.vertices[face[2]] - extended.vertices[face[0]])
            .normalized();
    };
    const double sharpCosine = std::cos(kSharpTurn);
    std::vector<std::pair<int, int>> sharp;
    for (int f = 0; f < static_cast<int>(extended.faces.size()); ++f) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int there = extended.faceNeighbours[f][k];
            if (there > f && normalOf(f).dot(normalOf(there)) < sharpCosine) {
                const Triangle& face = extended.faces[f];
                sharp.emplace_back(std::minmax(face[(k + 1) % 3], face[(k + 2) % 3]));
            }
        }
    }
    std::ranges::sort(sharp);

    // Connected sets of sharp edges and their lengths.
    std::vector<int> parents(extended.vertices.size());
    std::iota(parents.begin(), parents.end(), 0);
    const auto find = [&](int v) {
        while (parents[v] != v) {
            v = parents[v] = parents[parents[v]];
        }
        return v;
    };
    for (const auto& [a, b] : sharp) {
        const auto [low, high] = std::minmax({find(a), find(b)});
        parents[high] = low;
    }
    std::vector<double> lengths(extended.vertices.size(), 0.0);
    for (const auto& [a, b] : sharp) {
        lengths[find(a)] += (extended.vertices[a] - extended.vertices[b]).norm();
    }
    std::erase_if(sharp, [&](const std::pair<int, int>& edge) {
        return lengths[find(edge.first)] < kLeastFeature;
    });
    return sharp;
}

}  // namespace bspline_curve
