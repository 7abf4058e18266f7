// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/files.h"
#include "io/ply_header.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace bspline_curve {

namespace {

bool isColour(std::string_view name) {
    constexpr std::array<std::string_view, 4> kColours{"red", "green", "blue", "alpha"};
    return std::ranges::find(kColours, name) != kColours.end();
}

/// For each vertex of a made mesh the nearest one of the mesh that it was made of, -1: none.
std::vector<int> nearestVertices(const MadeMesh& made, const std::vector<Triangle>& parents) {
    std::vector<int> nearest(made.mesh().vertices.size(), -1);
    for (std::size_t f = 0; f < made.mesh().faces.size(); ++f) {
        const int face = static_cast<int>(f);
        const int parent = made.faceOf(face);
        for (int corner = 0; parent >= 0 && corner < 3; ++corner) {
            Eigen::Index largest = 0;
            made.placeOf(face, corner).maxCoeff(&largest);
            nearest[made.mesh().faces[f][corner]] = parents[parent][largest];
        }
    }
    return nearest;
}

/// Makes three channels unit vectors where they are normals.
void normalise(std::vector<MeshChannel>& channels) {
    std::array<MeshChannel*, 3> axes{};
    for (MeshChannel& channel : channels) {
        if (channel.name.size() == 2 && channel.name[0] == 'n' && channel.name[1] >= 'x' &&
            channel.name[1] <= 'z') {
            axes[static_cast<std::size_t>(channel.name[1] - 'x')] = &channel;
        }
    }
    if (std::ranges::find(axes, nullptr) != axes.end()) {
        return;
    }
    for (std::size_t i = 0; i < axes[0]->values.size(); ++i) {
        const Vec3 normal(axes[0]->values[i], axes[1]->values[i], axes[2]->values[i]);
        const double length = normal.norm();
        for (std::size_t k = 0; k < 3 && length > 0.0; ++k) {
            axes[k]->values[i] /= length;
        }
    }
}

template <class Value>
std::vector<std::array<Value, 3>> carriedCorners(
    const std::vector<std::array<Value, 3>>& corners, const MadeMesh& made
) {
    std::vector<std::array<Value, 3>> carried;
    for (std::size_t f = 0; f < made.mesh().faces.size() && !corners.empty(); ++f) {
        const int face = static_cast<int>(f);
        const int parent = made.faceOf(face);
        std::array<Value, 3> values{Value::Zero(), Value::Zero(), Value::Zero()};
        for (int corner = 0; parent >= 0 && corner < 3; ++corner) {
            const Vec3 weights = made.placeOf(face, corner);
            const auto& of = corners[parent];
            values[corner] = weights[0] * of[0] + weights[1] * of[1] + weights[2] * of[2];
        }
        carried.push_back(values);
    }
    return carried;
}

}  // namespace

MeshExtras carriedExtras(
    const MeshExtras& extras, const MadeMesh& made, const std::vector<Triangle>& parents
) {
    MeshExtras carried{
        .vertices = extras.vertices,
        .faces = extras.faces,
        .cornerTexture = carriedCorners(extras.cornerTexture, made),
        .cornerNormals = carriedCorners(extras.cornerNormals, made),
        .textures = extras.textures,
        .libraries = extras.libraries,
        .headings = extras.headings,
        .headingOf = {}
    };
    std::vector<int> nearest;
    for (MeshChannel& channel : carried.vertices) {
        const std::vector<double> before = std::exchange(channel.values, {});
        channel.values = made.carried(before);
        if (isFloating(channel.type)) {
            continue;
        }
        if (isColour(channel.name)) {
            std::ranges::transform(channel.values, channel.values.begin(), [](double x) {
                return std::round(x);
            });
            continue;
        }
        if (nearest.empty()) {
            nearest = nearestVertices(made, parents);
        }
        for (std::size_t v = 0; v < nearest.size(); ++v) {
            channel.values[v] =
                nearest[v] >= 0 ? before[nearest[v]] : std::round(channel.values[v]);
        }
    }
    normalise(carried.vertices);
    for (MeshChannel& channel : carried.faces) {
        const std::vector<double> before = std::exchange(channel.values, {});
        for (std::size_t f = 0; f < made.mesh().faces.size(); ++f) {
            const int parent = made.faceOf(static_cast<int>(f));
            channel.values.push_back(parent >= 0 ? before[parent] : 0.0);
        }
    }
    for (std::array<Vec3, 3>& normals : carried.cornerNormals) {
        for (Vec3& normal : normals) {
            normal.normalize();  // zero stays zero
        }
    }
    for (std::size_t f = 0; f < made.mesh().faces.size() && !extras.headingOf.empty(); ++f) {
        const int parent = made.faceOf(static_cast<int>(f));
        carried.headingOf.push_back(parent >= 0 ? extras.headingOf[parent] : -1);
    }
    return carried;
}

}  // namespace bspline_curve
