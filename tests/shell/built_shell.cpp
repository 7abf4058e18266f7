// SPDX-License-Identifier: GPL-3.0-or-later
#include "built_shell.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace bspline_curve::test_support {

BuiltShell::BuiltShell(TriangleMesh mesh, const ShellOptions& options)
    : surface(std::move(mesh)),
      sharedExtended(
          std::make_shared<const ExtendedSurface>(extendSurface(surface, options.smoothingPasses))
      ),
      extended(*sharedExtended),
      build(makeShell(sharedExtended, options)) {}

SimplifiedShell::SimplifiedShell(TriangleMesh mesh, ShellOptions options)
    : BuiltShell(std::move(mesh), (options.kind = ShellKind::Simplified, options)) {}

std::vector<NamedMesh> shellMeshes() {
    Eigen::Isometry3d far(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
    far.pretranslate(Vec3(1e4, -3e3, 5e2));
    return {
        {"Triangle", {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .faces = {{0, 1, 2}}}},
        {"Plate", plate(6, 5)},
        {"JitteredPlate", jitteredPlate(8, 8, 0.28, 1)},
        {"NarrowPlate", plate(40, 2, 1.0, 0.01)},
        {"NotchedPlate", notchedPlate(8)},
        {"NoisyPlate", withNoise(plate(12, 12), 0.03, 2)},
        {"OpenCylinder", openCylinder(16, 5)},
        {"Icosahedron", icosphere(0)},
        {"Sphere", icosphere(3)},
        {"NoisySphere", withNoise(icosphere(3), 0.04, 3)},
        {"Torus", torus(24, 12)},
        {"ThinTorus", torus(40, 6, 1.0, 0.05)},
        {"Box", box(4)},
        {"FlatBox", box(10, Vec3(1.0, 1.0, 0.02))},
        {"TwoComponents", twoComponents()},
        {"SubdividedTorus", midpointSubdivide(torus(16, 8))},
        {"SubdividedNoise", midpointSubdivide(withNoise(icosphere(2), 0.08, 4))},
        {"RenumberedTorus", renumbered(torus(24, 12), 5)},
        {"RenumberedBox", renumbered(box(5), 6)},
        {"FarAwaySphere", transformed(icosphere(2), far, 0.1)},
        {"ParallelPlates", parallelPlates(8, 0.02)},
        {"SphereWithSatellite", sphereWithSatellite()},
        {"FoldedSheet", foldedSheet(40, 4, 0.02)},
        {"SingularVertex", plateWithSingularVertex()},
    };
}

TriangleMesh foldedSheet(int columns, int rows, double gap) {
    // Along the sheet: flat, half a circle, flat back above.
    const double radius = 0.5 * gap;
    const double bend = std::numbers::pi * radius;
    TriangleMesh mesh = plate(columns, rows);
    for (Vec3& p : mesh.vertices) {
        const double s = (2.0 + bend) * p.x();
        const double angle = (s - 1.0) / radius;
        if (s <= 1.0) {
            p = Vec3(s, p.y(), 0.0);
        } else if (s < 1.0 + bend) {
            p = Vec3(1.0 + radius * std::sin(angle), p.y(), radius * (1.0 - std::cos(angle)));
        } else {
            p = Vec3(2.0 + bend - s, p.y(), gap);
        }
    }
    return mesh;
}

TriangleMesh parallelPlates(int cells, double gap) {
    Eigen::Isometry3d above = Eigen::Isometry3d::Identity();
    above.translation() = Vec3(0.0, 0.0, gap);
    return joined(plate(cells, cells), transformed(plate(cells, cells), above));
}

TriangleMesh notchedPlate(int cells) {
    TriangleMesh mesh = plate(cells, cells);
    std::erase_if(mesh.faces, [&](const Triangle& face) {
        Vec3 centre = Vec3::Zero();
        for (const int v : face) {
            centre += mesh.vertices[v] / 3.0;
        }
        return centre.x() < 0.5 && std::abs(centre.y() - 0.5 - 0.5 / cells) < 0.5 / cells;
    });
    return mesh;
}

TriangleMesh plateWithSingularVertex() {
    TriangleMesh mesh = plate(8, 8);
    // The neighbours of the middle vertex rise and fall in turn, steeply: faces look to all sides.
    const int middle = 4 * 9 + 4;
    const double height = 25.0 / 8.0;
    int side = 1;
    for (const auto& [dx, dy] : {std::pair(1, 0), {0, 1}, {-1, 0}, {0, -1}}) {
        const int neighbour = middle + dx + 9 * dy;
        mesh.vertices[neighbour].z() = side * height;
        side = -side;
    }
    return mesh;
}

TriangleMesh tennisBallVertex() {
    TriangleMesh mesh;
    const auto addRing = [&](double azimuthDegrees, double elevationDegrees) {
        const double azimuth = azimuthDegrees * std::numbers::pi / 180.0;
        const double elevation = elevationDegrees * std::numbers::pi / 180.0;
        mesh.vertices.emplace_back(
            std::cos(elevation) * std::cos(azimuth),
            std::cos(elevation) * std::sin(azimuth),
            std::sin(elevation)
        );
    };
    mesh.vertices.emplace_back(0.0, 0.0, 0.0);
    for (const double turn : {0.0, 180.0}) {
        for (const double offset : {-60.0, 0.0, 60.0}) {
            addRing(turn + offset, offset == 0.0 ? 70.0 : 30.0);
        }
        for (const double offset : {-60.0, 0.0, 60.0}) {
            addRing(turn + 90.0 + offset, offset == 0.0 ? -70.0 : -30.0);
        }
    }
    const int count = static_cast<int>(mesh.vertices.size()) - 1;
    for (int i = 0; i < count; ++i) {
        mesh.faces.push_back({0, 1 + i, 1 + (i + 1) % count});
    }
    return mesh;
}

TriangleMesh sphereWithSatellite() {
    const TriangleMesh sphere = icosphere(0);
    Vec3 centre = Vec3::Zero();
    for (const int v : sphere.faces[0]) {
        centre += sphere.vertices[v] / 3.0;
    }
    Eigen::Isometry3d aside = Eigen::Isometry3d::Identity();
    aside.translation() = 1.1 * centre;
    return joined(sphere, transformed(icosphere(1), aside, 0.01));
}

TriangleMesh sphereInSphere() {
    return joined(icosphere(4), icosphere(1, 0.01));
}

TriangleMesh withHoles(const TriangleMesh& mesh, int count, Random& random) {
    TriangleMesh result = mesh;
    // Vertices less than three faces from a hole keep all their faces.
    std::set<int> nearHoles;
    for (int hole = 0; hole < count; ++hole) {
        const int centre = random.integer(0, static_cast<int>(mesh.vertices.size()) - 1);
        std::set<int> near = {centre};
        for (int ring = 0; ring < 3; ++ring) {
            const std::set<int> inner = near;
            for (const Triangle& face : mesh.faces) {
                if (std::ranges::any_of(face, [&](int v) { return inner.contains(v); })) {
                    near.insert(face.begin(), face.end());
                }
            }
        }
        if (std::ranges::none_of(near, [&](int v) { return nearHoles.contains(v); })) {
            nearHoles.merge(near);
            std::erase_if(result.faces, [&](const Triangle& face) {
                return std::ranges::find(face, centre) != face.end();
            });
        }
    }
    return result;
}

bool areSame(const Shell& a, const Shell& b) {
    return std::ranges::equal(
               a.pillars(),
               b.pillars(),
               [](const Pillar& p, const Pillar& q) {
                   return p.bottom == q.bottom && p.middle == q.middle && p.top == q.top;
               }
           ) &&
           std::ranges::equal(
               a.prisms(),
               b.prisms(),
               [](const Prism& p, const Prism& q) {
                   return p.pillars == q.pillars && p.neighbours == q.neighbours &&
                          p.neighbourWalls == q.neighbourWalls && p.orientation == q.orientation;
               }
           ) &&
           a.tracks().offsets == b.tracks().offsets && a.tracks().faces == b.tracks().faces;
}

Names brokenInvariants(const ShellCheck& check) {
    Names names;
    for (const ShellInvariant* invariant : check.invariants()) {
        if (!invariant->holds) {
            names.emplace_back(invariant->name);
        }
    }
    return names;
}

void expectValid(const ShellCheck& check) {
    EXPECT_TRUE(check.passed());
    for (const ShellInvariant* invariant : check.invariants()) {
        EXPECT_TRUE(invariant->holds)
            << invariant->name << ": " << invariant->violations << " violations, first at "
            << testing::PrintToString(invariant->firstIds);
    }
}

void expectWhole(const BuiltShell& built) {
    expectValid(built.check());
    EXPECT_EQ(built.blockedFaces(), std::vector<int>{});
}

}  // namespace bspline_curve::test_support
