// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/coarse_shell.h"

#include "shell/shell_builder.h"
#include "support/meshes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bspline_curve::test_support {
namespace {

constexpr int kSmoothingPasses = 3;

std::vector<Pillar> pillarsOn(const Surface& middle, const ShellFrame& frame, double height) {
    std::vector<Vec3> normals(middle.vertices().size(), Vec3::Zero());
    for (const Triangle& face : middle.faces()) {
        const Vec3& a = middle.vertices()[face[0]];
        const Vec3 normal = (middle.vertices()[face[1]] - a).cross(middle.vertices()[face[2]] - a);
        for (const int v : face) {
            normals[v] += normal;
        }
    }
    const double length = height * middle.averageEdgeLength() / frame.scale;
    std::vector<Pillar> pillars;
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const Vec3 extended = frame.toUnit(middle.vertices()[v]);
        const Vec3 up = length * normals[v].normalized();
        pillars.push_back({extended - up, extended, extended + up});
    }
    return pillars;
}

SurfaceTracks tracksByBoxes(
    const std::vector<Pillar>& pillars,
    const std::vector<Prism>& prisms,
    const ExtendedSurface& extended
) {
    constexpr double kMargin = 1e-6;
    SurfaceTracks tracks;
    tracks.offsets.push_back(0);
    for (const Prism& prism : prisms) {
        Eigen::AlignedBox3d box;
        for (const int pillar : prism.pillars) {
            box.extend(pillars[pillar].bottom);
            box.extend(pillars[pillar].middle);
            box.extend(pillars[pillar].top);
        }
        box.min().array() -= kMargin;
        box.max().array() += kMargin;
        for (std::size_t f = 0; f < extended.faces.size(); ++f) {
            Eigen::AlignedBox3d faceBox;
            for (const int v : extended.faces[f]) {
                faceBox.extend(extended.vertices[v]);
            }
            if (box.intersects(faceBox)) {
                tracks.faces.push_back(static_cast<int>(f));
            }
        }
        tracks.offsets.push_back(static_cast<int>(tracks.faces.size()));
    }
    return tracks;
}

Shell makeShell(
    const Surface& middle, const std::shared_ptr<const ExtendedSurface>& extended, double height
) {
    std::vector<Pillar> pillars = pillarsOn(middle, extended->frame, height);
    std::vector<Prism> prisms = prismsOver(middle);
    SurfaceTracks tracks = tracksByBoxes(pillars, prisms, *extended);
    return {std::move(pillars), std::move(prisms), std::move(tracks), extended};
}

// Turned by an angle that aligns nothing.
TriangleMesh turned(const TriangleMesh& mesh) {
    return transformed(
        mesh, Eigen::Isometry3d(Eigen::AngleAxisd(0.37, Vec3(1.0, 2.0, -0.5).normalized()))
    );
}

TriangleMesh subdivided(TriangleMesh mesh, int times) {
    for (int i = 0; i < times; ++i) {
        mesh = midpointSubdivide(mesh);
    }
    return mesh;
}

// Waves along z, in the plane's unit.
TriangleMesh wavy(TriangleMesh mesh, double amplitude) {
    for (Vec3& p : mesh.vertices) {
        p.z() += amplitude * std::sin(9.0 * p.x()) * std::cos(7.0 * p.y() + 1.0);
    }
    return mesh;
}

// A plate from -0.2 to 1.2 that holds the unit plate and its ghosts.
TriangleMesh largePlate(int cells) {
    TriangleMesh mesh = plate(cells, cells, 1.4, 1.4);
    for (Vec3& p : mesh.vertices) {
        p -= Vec3(0.2, 0.2, 0.0);
    }
    return mesh;
}

// Over its creases, fibres of one side see the faces of the other from behind.
TriangleMesh centredBox(double size, int subdivisions) {
    TriangleMesh mesh = subdivided(box(1), subdivisions);
    for (Vec3& p : mesh.vertices) {
        p = size * (p - Vec3::Constant(0.5));
    }
    return mesh;
}

}  // namespace

CoarseShell::CoarseShell(TriangleMesh fine, const TriangleMesh& coarse, double height)
    : surface(std::move(fine)),
      extended(std::make_shared<ExtendedSurface>(extendSurface(surface, kSmoothingPasses))),
      shell(makeShell(Surface(coarse), extended, height)) {}

CoarseShell::CoarseShell(TriangleMesh fine)
    : surface(std::move(fine)),
      extended(std::make_shared<ExtendedSurface>(extendSurface(surface, kSmoothingPasses))),
      shell(buildShell(*extended, ShellOptions()).shell) {}

std::vector<Prism> prismsOver(const Surface& middle) {
    std::vector<Prism> prisms;
    for (int f = 0; f < middle.faceCount(); ++f) {
        const Triangle& face = middle.faces()[f];
        Prism prism;
        std::array<int, 3> corners = {0, 1, 2};
        std::sort(corners.begin(), corners.end(), [&](int a, int b) { return face[a] < face[b]; });
        for (std::size_t slot = 0; slot < 3; ++slot) {
            prism.pillars[slot] = face[corners[slot]];
            prism.neighbours[slot] = middle.faceNeighbours()[f][corners[slot]];
            prism.faceCorner[slot] = static_cast<signed char>(corners[slot]);
        }
        prism.orientation = corners[1] == (corners[0] + 1) % 3 ? 1 : -1;
        prisms.push_back(prism);
    }
    for (Prism& prism : prisms) {
        for (std::size_t slot = 0; slot < 3; ++slot) {
            if (prism.neighbours[slot] < 0) {
                continue;
            }
            const Prism& other = prisms[prism.neighbours[slot]];
            for (std::size_t wall = 0; wall < 3; ++wall) {
                if (std::find(prism.pillars.begin(), prism.pillars.end(), other.pillars[wall]) ==
                    prism.pillars.end()) {
                    prism.neighbourWalls[slot] = static_cast<signed char>(wall);
                }
            }
        }
    }
    return prisms;
}

Shell asSimplified(const Shell& thin, const std::shared_ptr<const ExtendedSurface>& extended) {
    SurfaceTracks tracks;
    tracks.offsets.push_back(0);
    for (std::size_t i = 0; i < thin.prisms().size(); ++i) {
        if (thin.prisms()[i].orientation != 0) {
            std::vector<int> faces{static_cast<int>(i)};
            for (const int next : extended->faceNeighbours[i]) {
                if (next >= 0) {
                    faces.push_back(next);
                }
            }
            std::sort(faces.begin(), faces.end());
            tracks.faces.insert(tracks.faces.end(), faces.begin(), faces.end());
        }
        tracks.offsets.push_back(static_cast<int>(tracks.faces.size()));
    }
    return {thin.pillars(), thin.prisms(), std::move(tracks), extended};
}

std::ostream& operator<<(std::ostream& stream, const CoarseShellCase& named) {
    return stream << named.name;
}

std::vector<CoarseShellCase> coarseShellCases() {
    const TriangleMesh coarseTorus = torus(12, 8, 1.0, 0.4);
    return {
        {"AlignedSphere", icosphere(3), icosphere(1), 0.3},
        {"TurnedSphere", turned(icosphere(3)), icosphere(1), 0.3},
        {"NoisySphere", withNoise(turned(icosphere(3)), 0.01, 31), icosphere(1), 0.3},
        {"FlatPlate", plate(12, 12), largePlate(4), 0.2},
        {"AlignedPlate", subdivided(plate(3, 3), 2), plate(3, 3), 0.2},
        {"WavyPlate", wavy(jitteredPlate(14, 14, 0.2, 32), 0.02), largePlate(4), 0.2},
        {"Torus", withNoise(subdivided(coarseTorus, 2), 0.005, 33), coarseTorus, 0.3},
        {"Box", centredBox(1.03, 3), centredBox(1.0, 1), 0.2},
    };
}

}  // namespace bspline_curve::test_support
