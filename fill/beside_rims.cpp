// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/beside_rims.h"

#include <Eigen/Geometry>

#include <utility>

namespace bspline_curve {

namespace {

constexpr int kSizeAverages = 4;  // along the rim, since faces beside curves are uneven

Vec3 normalOf(const TriangleMesh& mesh, const Triangle& face) {
    const Vec3& a = mesh.vertices[face[0]];
    return (mesh.vertices[face[1]] - a).cross(mesh.vertices[face[2]] - a);
}

/// For each vertex on no rim, of the sides of faces that end there and on no rim either.
std::vector<MeanLength> lengthsOffRims(const TriangleMesh& mesh, const RimPlaces& places) {
    std::vector<MeanLength> result(mesh.vertices.size());
    for (const Triangle& face : mesh.faces) {
        for (int k = 0; k < 3; ++k) {
            const int a = face[k];
            const int b = face[(k + 1) % 3];
            if (places.placeOf(a) < 0 && places.placeOf(b) < 0) {
                const double length = (mesh.vertices[b] - mesh.vertices[a]).norm();
                result[a].add(length);
                result[b].add(length);
            }
        }
    }
    return result;
}

}  // namespace

std::vector<Beside> besideRims(const TriangleMesh& mesh, const RimPlaces& places) {
    const std::vector<MeanLength> offRims = lengthsOffRims(mesh, places);
    std::vector<Beside> result(places.count());
    for (const Triangle& face : mesh.faces) {
        for (int k = 0; k < 3; ++k) {
            const int place = places.placeOf(face[k]);
            if (place < 0) {
                continue;
            }
            Beside& beside = result[place];
            const Vec3 normal = normalOf(mesh, face);
            const int next = face[(k + 1) % 3];
            const int last = face[(k + 2) % 3];
            const Vec3 side = mesh.vertices[last] - mesh.vertices[next];
            // The sum of cotangent weights times differences within one face.
            beside.laplacian += 0.5 * side.cross(normal.stableNormalized());
            beside.normal += normal;
            for (const int end : {next, last}) {
                beside.sides.add((mesh.vertices[end] - mesh.vertices[face[k]]).norm());
                if (places.placeOf(end) >= 0) {
                    beside.neighbours.push_back(places.placeOf(end));
                } else if (offRims[end].count > 0) {
                    beside.beyond.add(offRims[end].mean());
                }
            }
        }
    }
    return result;
}

std::vector<double> averagedAlong(std::vector<double> sizes) {
    const std::size_t count = sizes.size();
    for (int pass = 0; pass < kSizeAverages; ++pass) {
        std::vector<double> averaged(count);
        for (std::size_t i = 0; i < count; ++i) {
            averaged[i] =
                0.25 * (sizes[(i + count - 1) % count] + sizes[(i + 1) % count]) + 0.5 * sizes[i];
        }
        sizes = std::move(averaged);
    }
    return sizes;
}

}  // namespace bspline_curve
