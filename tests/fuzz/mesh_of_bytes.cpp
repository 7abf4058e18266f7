// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/mesh_of_bytes.h"

#include "support/meshes.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace bspline_curve::fuzz {

namespace {

using namespace test_support;

Vec3 latticePoint(ByteSource& bytes) {
    return {
        static_cast<double>(bytes.integer(0, 4)),
        static_cast<double>(bytes.integer(0, 4)),
        static_cast<double>(bytes.integer(0, 4))
    };
}

/// Faces that nobody meant to be a surface.
TriangleMesh soup(ByteSource& bytes) {
    TriangleMesh mesh;
    const int vertices = bytes.integer(3, 12);
    const int faces = bytes.integer(1, 24);
    for (int i = 0; i < vertices; ++i) {
        mesh.vertices.push_back(latticePoint(bytes));
    }
    for (int i = 0; i < faces; ++i) {
        mesh.faces.push_back(
            {bytes.integer(0, vertices - 1),
             bytes.integer(0, vertices - 1),
             bytes.integer(0, vertices - 1)}
        );
    }
    return mesh;
}

/// Faces round one vertex, closed or not, each corner at a height of its own.
TriangleMesh fan(ByteSource& bytes) {
    TriangleMesh mesh;
    const int valence = bytes.integer(3, 40);
    const bool isClosed = bytes.oneIn(2);
    mesh.vertices.emplace_back(0.0, 0.0, bytes.unit());
    for (int i = 0; i < valence; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / valence;
        mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), bytes.unit() - 0.5);
    }
    for (int i = 0; i < (isClosed ? valence : valence - 1); ++i) {
        mesh.faces.push_back({0, 1 + i, 1 + (i + 1) % valence});
    }
    return mesh;
}

/// Reads one number per statement: the order in which arguments are evaluated is the compiler's,
/// and the same bytes shall be the same mesh in the fuzzer and in the tests.
TriangleMesh surfaceOfKind(ByteSource& bytes) {
    switch (bytes.integer(0, 11)) {
        case 0:
            return soup(bytes);
        case 1:
            return fan(bytes);
        case 2: {
            const int across = bytes.integer(1, 16);
            const int along = bytes.integer(1, 16);
            return plate(across, along, 0.01 + bytes.unit());
        }
        case 3: {
            const int around = bytes.integer(3, 20);
            const int along = bytes.integer(1, 12);
            return openCylinder(around, along, 0.05 + bytes.unit());
        }
        case 4:
            return icosphere(bytes.integer(0, 2));
        case 5: {
            const int around = bytes.integer(3, 24);
            const int across = bytes.integer(3, 12);
            return torus(around, across, 1.0, 0.05 + bytes.unit());
        }
        case 6: {
            const int across = bytes.integer(1, 6);
            return box(across, {1.0, 1.0, 1e-6 + bytes.unit()});
        }
        case 7:
            return wedge(bytes.integer(1, 5));
        case 8:
            return crossingPlates();
        case 9:
            return moebiusStrip(bytes.integer(3, 24));
        case 10:
            return twoComponents();
        default:
            return bytes.oneIn(2) ? threeFacesAtAnEdge() : bowTie();
    }
}

void damage(TriangleMesh& mesh, ByteSource& bytes) {
    const auto anyVertex = [&] {
        return bytes.integer(0, static_cast<int>(mesh.vertices.size()) - 1);
    };
    const int vertex = anyVertex();
    const int face = bytes.integer(0, static_cast<int>(mesh.faces.size()) - 1);
    switch (bytes.integer(0, 5)) {
        case 0:
            mesh.vertices[vertex] = mesh.vertices[anyVertex()];
            break;
        case 1:
            mesh.vertices[vertex] += 0.2 * (latticePoint(bytes) - Vec3::Constant(2.0));
            break;
        case 2:
            mesh.faces.push_back(mesh.faces[face]);
            break;
        case 3:
            std::swap(mesh.faces[face][0], mesh.faces[face][1]);
            break;
        case 4:
            mesh.faces[face][bytes.integer(0, 2)] = vertex;
            break;
        default:
            if (mesh.faces.size() > 1) {
                mesh.faces.erase(mesh.faces.begin() + face);
            }
            break;
    }
}

}  // namespace

TriangleMesh meshOf(ByteSource& bytes) {
    constexpr std::array<double, 6> kScales{1.0, 1.0, 1e-9, 1e9, 1e-160, 1e160};
    constexpr std::array<double, 4> kShifts{0.0, 0.0, 1e6, 1e12};
    const double scale = kScales[static_cast<std::size_t>(bytes.integer(0, 5))];
    const double shift = kShifts[static_cast<std::size_t>(bytes.integer(0, 3))];
    const double roughness = bytes.unit();
    const double noise = 0.3 * roughness * bytes.unit();
    const int damages = bytes.oneIn(3) ? bytes.integer(1, 6) : 0;
    TriangleMesh mesh = surfaceOfKind(bytes);
    if (noise > 0.0) {
        mesh = withNoise(std::move(mesh), 0.1 * noise, bytes.byte());
    }
    for (int i = 0; i < damages; ++i) {
        damage(mesh, bytes);
    }
    for (Vec3& vertex : mesh.vertices) {
        vertex = scale * (vertex + Vec3::Constant(shift));
    }
    return mesh;
}

}  // namespace bspline_curve::fuzz
