// SPDX-License-Identifier: GPL-3.0-or-later
#include "handmade_shell.h"

#include "shell/face_geometry.h"
#include "support/coarse_shell.h"
#include "support/meshes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bspline_curve::test_support {
namespace {

std::vector<Vec3> vertexNormals(const TriangleMesh& mesh) {
    std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
    for (const Triangle& face : mesh.faces) {
        const Vec3& a = mesh.vertices[face[0]];
        const Vec3 normal =
            (mesh.vertices[face[1]] - a).cross(mesh.vertices[face[2]] - a).normalized();
        for (const int v : face) {
            normals[v] += normal;
        }
    }
    for (Vec3& normal : normals) {
        normal.normalize();
    }
    return normals;
}

Vec3 bump(const Vec3& p, double amplitude) {
    return amplitude * Vec3(
                           std::sin(5.0 * p.y() + p.z()),
                           std::sin(4.0 * p.z() + p.x()),
                           std::sin(6.0 * p.x() + 3.0 * p.y())
                       );
}

TriangleMesh shifted(TriangleMesh mesh, const Vec3& by) {
    for (Vec3& vertex : mesh.vertices) {
        vertex += by;
    }
    return mesh;
}

}  // namespace

HandmadeShell::HandmadeShell(const TriangleMesh& middle, TriangleMesh fine, double halfThickness)
    : surface(std::make_shared<const Surface>(std::move(fine))),
      extended(std::make_shared<const ExtendedSurface>(extendSurface(*surface, 3))),
      prisms(prismsOver(Surface(middle))) {
    const std::vector<Vec3> normals = vertexNormals(middle);
    for (std::size_t v = 0; v < middle.vertices.size(); ++v) {
        const Vec3 reach = halfThickness * normals[v];
        pillars.push_back(
            {extended->frame.toUnit(middle.vertices[v] - reach),
             extended->frame.toUnit(middle.vertices[v]),
             extended->frame.toUnit(middle.vertices[v] + reach)}
        );
    }
    track();
}

Shell HandmadeShell::shell() const {
    return {pillars, prisms, tracks, extended};
}

ShellCheck HandmadeShell::check(const ShellCheckOptions& options) const {
    return checkShell(*surface, *extended, shell(), blockedFaces, options);
}

void HandmadeShell::track() {
    tracks = {.offsets = {0}, .faces = {}};
    for (const Prism& prism : prisms) {
        Eigen::AlignedBox3d box;
        for (const int pillar : prism.pillars) {
            box.extend(pillars[pillar].bottom);
            box.extend(pillars[pillar].middle);
            box.extend(pillars[pillar].top);
        }
        for (int f = 0; f < static_cast<int>(extended->faces.size()); ++f) {
            const auto [a, b, c] = cornersOf(*extended, f);
            if (Eigen::AlignedBox3d(a).extend(b).extend(c).intersects(box) &&
                !std::ranges::binary_search(blockedFaces, f)) {
                tracks.faces.push_back(f);
            }
        }
        tracks.offsets.push_back(static_cast<int>(tracks.faces.size()));
    }
}

bool HandmadeShell::forget(int prism, int face) {
    const auto first = tracks.faces.begin() + tracks.offsets[prism];
    const auto last = tracks.faces.begin() + tracks.offsets[prism + 1];
    const auto entry = std::find(first, last, face);
    if (entry == last) {
        return false;
    }
    tracks.faces.erase(entry);
    for (std::size_t i = prism + 1; i < tracks.offsets.size(); ++i) {
        --tracks.offsets[i];
    }
    return true;
}

int HandmadeShell::faceInside(int prism) const {
    Vec3 centre = Vec3::Zero();
    for (const int pillar : prisms[prism].pillars) {
        centre += pillars[pillar].middle / 3.0;
    }
    int nearest = -1;
    double distance = std::numeric_limits<double>::infinity();
    for (int f = 0; f < extended->surfaceFaceCount; ++f) {
        const double here = (extended->position({f, Vec3::Constant(1.0 / 3.0)}) - centre).norm();
        if (here < distance) {
            distance = here;
            nearest = f;
        }
    }
    return nearest;
}

TriangleMesh displaced(
    TriangleMesh mesh, int subdivisions, const std::function<Vec3(const Vec3&)>& displacement
) {
    for (int i = 0; i < subdivisions; ++i) {
        mesh = midpointSubdivide(mesh);
    }
    for (Vec3& vertex : mesh.vertices) {
        vertex += displacement(vertex);
    }
    return mesh;
}

HandmadeShell coarseSphere(int level, int subdivisions) {
    // Chords of the icosahedron are up to 0.205 below the sphere.
    return {icosphere(level), icosphere(level + subdivisions), level == 0 ? 0.3 : 0.15};
}

HandmadeShell coarsePlate() {
    const TriangleMesh fine =
        displaced(plate(4, 4), 2, [](const Vec3& p) { return bump(p, 0.03); });
    return {shifted(plate(3, 3, 1.5, 1.5), Vec3(-0.25, -0.25, 0.0)), fine, 0.2};
}

HandmadeShell flatPlate() {
    return {shifted(plate(3, 3, 1.5, 1.5), Vec3(-0.25, -0.25, 0.0)), plate(8, 8), 0.2};
}

HandmadeShell coarseTorus() {
    const TriangleMesh middle = torus(16, 8);
    return {middle, displaced(middle, 2, [](const Vec3& p) { return bump(p, 0.01); }), 0.08};
}

HandmadeShell coarseBox() {
    const TriangleMesh middle = box(2);
    const auto displacement = [](const Vec3& p) -> Vec3 {
        // None at the edges: faces beyond a crease cannot be seen.
        const Vec3 q = p.cwiseProduct(Vec3::Ones() - p);
        return (q[0] * q[1] + q[1] * q[2] + q[2] * q[0]) * bump(p, 0.5);
    };
    return {middle, displaced(middle, 3, displacement), 0.1};
}

std::vector<NamedHandmadeShell> handmadeShells() {
    return {
        {"Sphere", [] { return coarseSphere(); }},
        {"CoarserSphere", [] { return coarseSphere(0, 3); }},
        {"Plate", coarsePlate},
        {"FlatPlate", flatPlate},
        {"Torus", coarseTorus},
        {"Box", coarseBox},
    };
}

}  // namespace bspline_curve::test_support
