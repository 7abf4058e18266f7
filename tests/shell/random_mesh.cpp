// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_mesh.h"

#include "built_shell.h"
#include "support/meshes.h"
#include "support/random.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace bspline_curve::test_support {
namespace {

// A sum of waves in random directions: smooth bumps of amplitude 1 or so.
class Waves {
public:
    Waves(Random& random, double shortest) {
        for (Wave& wave : waves_) {
            const Vec3 direction = random.point(-1.0, 1.0);
            wave.frequency = 2.0 * std::numbers::pi / random.uniform(shortest, 4.0 * shortest) *
                             direction.normalized();
            wave.phase = random.uniform(0.0, 2.0 * std::numbers::pi);
        }
    }

    [[nodiscard]] double at(const Vec3& p) const {
        double sum = 0.0;
        for (const Wave& wave : waves_) {
            sum += std::sin(wave.frequency.dot(p) + wave.phase);
        }
        return sum / static_cast<double>(waves_.size());
    }

private:
    struct Wave {
        Vec3 frequency;
        double phase = 0.0;
    };

    std::array<Wave, 6> waves_;
};

double logarithmic(Random& random, double low, double high) {
    return std::exp(random.uniform(std::log(low), std::log(high)));
}

TriangleMesh bumpyPlate(Random& random) {
    // One number to a statement: the order of arguments is the compiler's.
    const int columns = random.integer(8, 40);
    const double jitter = random.uniform(0.0, 0.29);
    const int rows = random.integer(8, 40);
    TriangleMesh mesh = jitteredPlate(columns, rows, jitter, 1);
    const Waves waves(random, random.uniform(0.2, 1.0));
    const double height = random.uniform(0.0, 0.15);
    for (Vec3& p : mesh.vertices) {
        p.z() += height * waves.at(p);
    }
    return withNoise(mesh, logarithmic(random, 1e-4, 0.2) / columns, 2);
}

TriangleMesh block(Random& random) {
    const int cells = random.integer(3, 14);
    const double thickness = logarithmic(random, 0.02, 1.0);
    const double width = random.uniform(0.1, 1.0);
    const Vec3 lengths(1.0, width, thickness);
    const double noise = logarithmic(random, 1e-5, 0.1) * lengths.minCoeff() / cells;
    return withNoise(box(cells, lengths), noise, 3);
}

TriangleMesh scan(Random& random) {
    TriangleMesh mesh = icosphere(random.integer(2, 3));
    const double height = random.uniform(0.4, 1.0);
    const double width = random.uniform(0.4, 1.0);
    const Vec3 shape(1.0, width, height);
    const Waves waves(random, random.uniform(0.5, 2.0));
    const double bumps = random.uniform(0.0, 0.25);
    for (Vec3& p : mesh.vertices) {
        p = (1.0 + bumps * waves.at(p)) * p.cwiseProduct(shape);
    }
    mesh = withHoles(mesh, random.integer(1, 6), random);
    return withNoise(std::move(mesh), logarithmic(random, 1e-5, 5e-3), 4);
}

TriangleMesh severalPieces(Random& random) {
    TriangleMesh mesh = icosphere(2);
    double reach = 1.0;
    for (int i = random.integer(1, 3); i > 0; --i) {
        const double radius = logarithmic(random, 0.05, 1.0);
        const double gap = logarithmic(random, 1e-3, 0.3);
        Eigen::Isometry3d aside = random.isometry(0.0);
        aside.translation() = Vec3(reach + gap + radius, 0.0, 0.0);
        const TriangleMesh piece = random.integer(0, 1) == 0 ? icosphere(1) : torus(16, 8, 0.7);
        mesh = joined(mesh, transformed(piece, aside, radius));
        reach += gap + 2.0 * radius;
    }
    return mesh;
}

TriangleMesh plainMesh(RandomKind kind, Random& random) {
    const auto seed = static_cast<std::uint64_t>(random.integer(0, 1000000));
    const auto noisy = [&](const TriangleMesh& mesh, double most) {
        return withNoise(mesh, logarithmic(random, 1e-4, most), seed);
    };
    switch (kind) {
        case RandomKind::NoisySphere:
            return noisy(icosphere(random.integer(2, 3)), 0.04);
        case RandomKind::NoisyTorus: {
            const int segments = random.integer(16, 60);
            const int minorSegments = random.integer(8, 24);
            return noisy(torus(segments, minorSegments, 1.0, random.uniform(0.1, 0.6)), 0.02);
        }
        case RandomKind::BumpyPlate:
            return bumpyPlate(random);
        case RandomKind::Block:
            return block(random);
        case RandomKind::Scan:
            return scan(random);
        case RandomKind::Tube: {
            const int segments = random.integer(8, 40);
            const int rings = random.integer(6, 30);
            return noisy(openCylinder(segments, rings, 1.0, random.uniform(0.5, 4.0)), 0.02);
        }
        case RandomKind::Folds: {
            const bool isSphere = random.integer(0, 1) == 0;
            return withNoise(
                isSphere ? icosphere(2) : plate(12, 12), random.uniform(0.04, 0.15), seed
            );
        }
        case RandomKind::SeveralPieces:
            return severalPieces(random);
    }
    return {};
}

}  // namespace

TriangleMesh randomMesh(RandomKind kind, std::uint64_t seed) {
    Random random(seed);
    TriangleMesh mesh = plainMesh(kind, random);
    if (mesh.faces.size() < 1000 && random.integer(0, 1) == 0) {
        mesh = midpointSubdivide(mesh);
    }
    const double scale = logarithmic(random, 1e-3, 1e3);
    return renumbered(transformed(mesh, random.isometry(10.0 * scale), scale), seed);
}

std::string nameOf(RandomKind kind) {
    constexpr std::array<const char*, kRandomKinds.size()> kNames = {
        "NoisySphere", "NoisyTorus", "BumpyPlate", "Block", "Scan", "Tube", "Folds", "SeveralPieces"
    };
    return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace bspline_curve::test_support
