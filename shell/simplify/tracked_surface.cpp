// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/simplify/tracked_surface.h"

#include "surface/spatial_order.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace bspline_curve {
namespace {

// Normals of needles thinner than this (area by squared longest edge) are mostly rounding.
constexpr double kLeastShape = 1e-9;

FaceBound boundOf(const Vec3& a, const Vec3& b, const Vec3& c) {
    FaceBound bound;
    const Vec3 centre = (a + b + c) / 3.0;
    const double radius = std::max({(a - centre).norm(), (b - centre).norm(), (c - centre).norm()});
    const Vec3 normal = (b - a).cross(c - a);
    const double length = normal.norm();
    const double longest =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    for (int k = 0; k < 3; ++k) {
        bound.centre[k] = static_cast<float>(centre[k]);
        bound.normal[k] =
            length > kLeastShape * longest ? static_cast<float>(normal[k] / length) : 0.0F;
    }
    bound.radius = static_cast<float>(radius) + kFloatMargin;
    return bound;
}

// Indices along a space-filling curve, those with isLast after the others.
template <class CentreOf, class IsLast>
std::vector<int> orderOf(std::size_t count, const CentreOf& centreOf, const IsLast& isLast) {
    std::vector<int> order;
    order.reserve(count);
    const std::vector<MortonKey> keys = spatialOrder(count, centreOf);
    for (const bool last : {false, true}) {
        for (const MortonKey& key : keys) {
            if (isLast(key.index) == last) {
                order.push_back(key.index);
            }
        }
    }
    return order;
}

std::vector<int> inverseOf(const std::vector<int>& order) {
    std::vector<int> inverse(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        inverse[order[i]] = static_cast<int>(i);
    }
    return inverse;
}

}  // namespace

TrackedSurface::TrackedSurface(const ExtendedSurface& input) {
    creases = findCreases(input);
    std::vector<char> onCrease(input.vertices.size(), 0);
    for (const auto& [a, b] : creases) {
        onCrease[a] = onCrease[b] = 1;
    }
    const std::vector<int> vertices = orderOf(
        input.vertices.size(),
        [&](std::size_t v) -> const Vec3& { return input.vertices[v]; },
        [&](int v) { return onCrease[v] != 0; }
    );
    inputFaces = orderOf(
        input.faces.size(),
        [&](std::size_t f) -> const Vec3& { return input.vertices[input.faces[f][0]]; },
        [&](int f) { return f >= input.surfaceFaceCount; }
    );
    const std::vector<int> vertexNumbers = inverseOf(vertices);
    const std::vector<int> faceNumbers = inverseOf(inputFaces);

    extended.frame = input.frame;
    extended.surfaceVertexCount = input.surfaceVertexCount;
    extended.surfaceFaceCount = input.surfaceFaceCount;
    extended.vertices.reserve(vertices.size());
    extended.directions.reserve(vertices.size());
    extended.edgeLengths.reserve(vertices.size());
    for (const int v : vertices) {
        extended.vertices.push_back(input.vertices[v]);
        extended.directions.push_back(input.directions[v]);
        extended.edgeLengths.push_back(input.edgeLengths[v]);
    }
    extended.faces.reserve(inputFaces.size());
    extended.faceNeighbours.reserve(inputFaces.size());
    for (const int f : inputFaces) {
        const Triangle& face = input.faces[f];
        const Triangle& near = input.faceNeighbours[f];
        const auto neighbour = [&](std::size_t k) {
            return near[k] < 0 ? -1 : faceNumbers[near[k]];
        };
        extended.faces.push_back(
            {vertexNumbers[face[0]], vertexNumbers[face[1]], vertexNumbers[face[2]]}
        );
        extended.faceNeighbours.push_back({neighbour(0), neighbour(1), neighbour(2)});
    }
    for (const int v : input.unseenVertices) {
        extended.unseenVertices.push_back(vertexNumbers[v]);
    }
    for (auto& [a, b] : creases) {
        const auto [low, high] = std::minmax(vertexNumbers[a], vertexNumbers[b]);
        a = low;
        b = high;
    }
    std::ranges::sort(creases);
}

void TrackedSurface::prepareForEditing() {
    // Assigning {} would keep the memory.
    extended.faceNeighbours = std::vector<Triangle>();
    extended.directions = std::vector<Vec3>();
    extended.edgeLengths = std::vector<double>();
    bounds.reserve(extended.faces.size());
    for (int face = 0; face < static_cast<int>(extended.faces.size()); ++face) {
        bounds.push_back(boundOf(corner(face, 0), corner(face, 1), corner(face, 2)));
    }
}

}  // namespace bspline_curve
