// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/simplify/creases.h"

#include "shell/face_geometry.h"
#include "utility/disjoint_sets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bspline_curve {
namespace {

// Least angle between the normals of the faces at a sharp edge, in radians.
constexpr double kSharpTurn = 50.0 * std::numbers::pi / 180.0;
// Least length of a connected set of sharp edges that is a feature, relative to the diagonal.
constexpr double kLeastFeature = 0.12;

}  // namespace

Edges findCreases(const ExtendedSurface& extended) {
    const double sharpCosine = std::cos(kSharpTurn);
    Edges sharp;
    for (int f = 0; f < static_cast<int>(extended.faces.size()); ++f) {
        const Triangle& face = extended.faces[f];
        for (std::size_t k = 0; k < 3; ++k) {
            const int there = extended.faceNeighbours[f][k];
            if (there > f &&
                areaNormal(extended, f).normalized().dot(areaNormal(extended, there).normalized()) <
                    sharpCosine) {
                sharp.emplace_back(std::minmax(face[(k + 1) % 3], face[(k + 2) % 3]));
            }
        }
    }
    std::ranges::sort(sharp);
    DisjointSets sets(extended.vertices.size());
    for (const auto& [a, b] : sharp) {
        sets.unite(a, b);
    }
    std::vector<double> lengths(extended.vertices.size(), 0.0);
    for (const auto& [a, b] : sharp) {
        lengths[sets.find(a)] += (extended.vertices[a] - extended.vertices[b]).norm();
    }
    std::erase_if(sharp, [&](const std::pair<int, int>& edge) {
        return lengths[sets.find(edge.first)] < kLeastFeature;
    });
    return sharp;
}

Creases::Creases(Edges edges, int pillarCount)
    : edges_(std::move(edges)), degrees_(pillarCount, 0) {
    for (const auto& [a, b] : edges_) {
        ++degrees_[a];
        ++degrees_[b];
    }
}

bool Creases::holdEdge(int a, int b) const {
    return std::ranges::binary_search(edges_, std::pair(std::min(a, b), std::max(a, b)));
}

void Creases::collapse(int removed, int kept) {
    const auto firstOf = [&](const std::pair<int, int>& edge) {
        return std::ranges::lower_bound(edges_, edge);
    };
    // The collapsed edge goes; the other one of `removed` becomes one of `kept`. Edges are few.
    const auto other = std::ranges::find_if(edges_, [&](const std::pair<int, int>& edge) {
        return (edge.first == removed && edge.second != kept) ||
               (edge.second == removed && edge.first != kept);
    });
    const int far = other->first == removed ? other->second : other->first;
    edges_.erase(other);
    edges_.erase(firstOf({std::min(removed, kept), std::max(removed, kept)}));
    const std::pair<int, int> moved(std::min(far, kept), std::max(far, kept));
    edges_.insert(firstOf(moved), moved);
    degrees_[removed] = 0;
}

}  // namespace bspline_curve
