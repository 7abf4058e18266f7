// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/obstacle_field.h"

#include "field/make_field.h"
#include "support/meshes.h"
#include "support/places.h"
#include "support/random.h"
#include "support/refusal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace bspline_curve {
namespace {

using namespace test_support;

/// A disc about the origin in the plane z = 0, of rings of 6, 12, 18, … vertices.
TriangleMesh disc(int rings, double radius) {
    TriangleMesh mesh;
    mesh.vertices.push_back(Vec3::Zero());
    const auto idOf = [](int ring, int step) {
        return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + step % (6 * ring);
    };
    for (int ring = 1; ring <= rings; ++ring) {
        for (int step = 0; step < 6 * ring; ++step) {
            const double angle = 2.0 * std::numbers::pi * step / (6 * ring);
            mesh.vertices.push_back(
                radius * ring / rings * Vec3(std::cos(angle), std::sin(angle), 0.0)
            );
        }
    }
    for (int ring = 0; ring < rings; ++ring) {
        for (int sector = 0; sector < 6; ++sector) {
            for (int i = 0; i <= ring; ++i) {
                const int inner = idOf(ring, sector * ring + i);
                const int outer = sector * (ring + 1) + i;
                mesh.faces.push_back({inner, idOf(ring + 1, outer), idOf(ring + 1, outer + 1)});
                if (i < ring) {
                    mesh.faces.push_back(
                        {inner, idOf(ring + 1, outer + 1), idOf(ring, sector * ring + i + 1)}
                    );
                }
            }
        }
    }
    return mesh;
}

std::vector<double> obstacleWhere(
    const Surface& surface, const Predicate& isIn, double value, double slope
) {
    return obstacleField(surface, facesWhere(surface, isIn), value, slope);
}

// s + slope (r^2 - rho^2) / (2 r) solves (26) on a disc; halving the edges quarters the error.
TEST(ObstacleField, OnADiscConvergesToTheExactSolution) {
    constexpr double kRadius = 0.6;
    constexpr double kValue = 0.2;
    constexpr double kSlope = 3.0;
    double before = 1.0;
    for (const int rings : {10, 20, 40, 80}) {
        const TriangleMesh mesh = disc(rings, 1.0);
        const Surface surface(mesh);
        const double inUnits = kSlope / surface.diagonal();
        const auto field = obstacleWhere(surface, ball(Vec3::Zero(), kRadius), kValue, kSlope);
        double worst = 0.0;
        for (std::size_t i = 0; i < field.size(); ++i) {
            const double rho = mesh.vertices[i].norm();
            const double exact =
                kValue + inUnits * (kRadius * kRadius - rho * rho) / (2.0 * kRadius);
            if (rho < kRadius + 1e-9) {
                worst = std::max(worst, std::abs(field[i] - exact));
            } else {
                EXPECT_EQ(field[i], 0.0);
            }
        }
        EXPECT_LT(worst, 0.3 * before) << rings;
        before = worst;
    }
    EXPECT_LT(before, 1e-4);
}

TEST(ObstacleField, IsOneOrALittleMoreInsideByDefault) {
    const Surface surface(disc(60, 1.0));
    const double radius = 0.05 * surface.diagonal();
    const auto region = facesWhere(surface, ball(Vec3::Zero(), radius));
    const auto field =
        makeField(surface, {.kind = FieldKind::Obstacle}, {.region = region}).values();
    EXPECT_NEAR(*std::ranges::max_element(field), 1.0, 0.1);
    for (const int face : region) {
        for (const int vertex : surface.faces()[face]) {
            EXPECT_GE(field[vertex], 1.0) << vertex;
        }
    }
    EXPECT_EQ(naturalCost(FieldKind::Obstacle), FieldCost::Identity);
}

TEST(ObstacleField, IsTheSameInEveryUnitAndPosition) {
    const TriangleMesh mesh = withNoise(icosphere(4), 0.01, 1);
    const Surface surface(mesh);
    const auto region = facesWhere(surface, [](const Vec3& p) { return p.z() > 0.3; });
    const auto field = obstacleField(surface, region, 0.5, 1.0 * surface.diagonal());
    EXPECT_GT(*std::ranges::max_element(field), 0.7);
    for (const double unit : {1e-6, 1.0, 1e6}) {
        const Surface moved(transformed(mesh, Random(2).isometry(5.0), unit));
        // The box turns with the axes, so its diagonal differs.
        const auto same = obstacleField(moved, region, 0.5, 1.0 * moved.diagonal() / unit);
        for (std::size_t i = 0; i < field.size(); ++i) {
            EXPECT_NEAR(same[i], field[i], 1e-6);
        }
    }
}

// Two pieces, one of them a ring: each is what it is alone. The values of a hole are 0.
TEST(ObstacleField, TreatsPiecesAlikeAndKeepsHolesFree) {
    const TriangleMesh mesh = plate(60, 30, 2.0, 1.0);
    const Surface surface(mesh);
    const auto fromCentre = [](const Vec3& p, double x) { return (p - Vec3(x, 0.5, 0)).norm(); };
    const auto isRing = [&](const Vec3& p) {
        return fromCentre(p, 0.5) < 0.4 && fromCentre(p, 0.5) > 0.15;
    };
    const auto isDisc = [&](const Vec3& p) { return fromCentre(p, 1.5) < 0.4; };
    const auto isEither = [&](const Vec3& p) { return isRing(p) || isDisc(p); };
    const auto both = obstacleWhere(surface, isEither, 0, 1);
    const auto ring = obstacleWhere(surface, isRing, 0, 1);
    const auto round = obstacleWhere(surface, isDisc, 0, 1);
    for (std::size_t i = 0; i < both.size(); ++i) {
        EXPECT_NEAR(both[i], ring[i] + round[i], 1e-9);
        const Vec3& p = mesh.vertices[i];
        if (fromCentre(p, 0.5) < 0.1 || fromCentre(p, 0.5) > 0.45) {
            EXPECT_EQ(ring[i], 0.0);
        } else if (fromCentre(p, 0.5) > 0.22 && fromCentre(p, 0.5) < 0.33) {
            EXPECT_GT(ring[i], 0.01);
        }
    }
}

// Half a disc at the boundary of the mesh is like the half of a whole one.
TEST(ObstacleField, GoesOnAsInAMirrorWhereTheMeshEnds) {
    const Surface whole(plate(40, 40));
    const Surface half(plate(40, 20, 1.0, 0.5));
    const Predicate inside = ball({0.5, 0.5, 0}, 0.3);
    const auto field = obstacleWhere(whole, inside, 0.0, whole.diagonal());
    const auto mirrored = obstacleWhere(half, inside, 0.0, half.diagonal());
    EXPECT_GT(mirrored[20 * 41 + 20], 0.1);
    for (std::size_t i = 0; i < mirrored.size(); ++i) {
        EXPECT_NEAR(mirrored[i], field[i], 1e-9) << i;
    }
}

TEST(ObstacleField, SurvivesSlivers) {
    TriangleMesh mesh = plate(30, 30);
    for (Vec3& p : mesh.vertices) {
        // Columns of 1e-12 of their width beside wide ones.
        const double column = std::round(30.0 * p.x());
        if (static_cast<int>(column) % 5 == 1) {
            p.x() = (column - 1.0 + 1e-12) / 30.0;
        }
    }
    const auto field = obstacleWhere(Surface(mesh), ball({0.5, 0.5, 0}, 0.3), 0.0, std::sqrt(2.0));
    EXPECT_GT(*std::ranges::max_element(field), 0.1);
    EXPECT_LT(*std::ranges::max_element(field), 0.3);
    EXPECT_GT(*std::ranges::min_element(field), -0.05);
}

// A vertex whose faces are all tiny has hardly any mass.
TEST(ObstacleField, SurvivesTinyFaces) {
    TriangleMesh mesh = plate(30, 30);
    const Triangle face = mesh.faces[900];
    const int first = static_cast<int>(mesh.vertices.size());
    Vec3 centre = Vec3::Zero();
    for (const int corner : face) {
        centre += mesh.vertices[corner] / 3.0;
    }
    for (const int corner : face) {
        mesh.vertices.push_back(centre + 1e-9 * (mesh.vertices[corner] - centre));
    }
    mesh.vertices.push_back(centre);
    mesh.faces[900] = {first, first + 1, first + 3};
    mesh.faces.push_back({first + 1, first + 2, first + 3});
    mesh.faces.push_back({first + 2, first, first + 3});
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        mesh.faces.push_back({face[k], face[next], first + next});
        mesh.faces.push_back({face[k], first + next, first + k});
    }
    const Predicate inside = ball({0.5, 0.5, 0}, 0.3);
    const auto expected = obstacleWhere(Surface(plate(30, 30)), inside, 0.0, std::sqrt(2.0));
    const auto field = obstacleWhere(Surface(mesh), inside, 0.0, std::sqrt(2.0));
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(field[i], expected[i], 0.01) << i;
    }
}

TEST(ObstacleField, IsTheBoundaryValueWhereNoVertexIsInside) {
    const auto field = obstacleField(Surface(plate(4, 4)), std::vector<int>{5}, 2.0, 1.0);
    EXPECT_EQ(std::ranges::count(field, 2.0), 3);
    EXPECT_EQ(std::ranges::count(field, 0.0), 22);
}

TEST(ObstacleField, RefusesRegionsThatMakeNone) {
    const Surface surface(joined(plate(2, 2), plate(6, 6)));
    const auto expectNone = [&](const std::vector<int>& region,
                                const std::string& said,
                                InputErrorCode code = InputErrorCode::BadField) {
        expectRefused(
            [&] {
                const FieldOptions options{.kind = FieldKind::Obstacle, .obstacleValue = 0.0};
                return makeField(surface, options, {.region = region});
            },
            code,
            said
        );
    };
    expectNone({}, "the region has no faces");
    expectNone({80}, "no face of the mesh", InputErrorCode::IndexOutOfRange);
    expectNone({-1}, "no face of the mesh", InputErrorCode::IndexOutOfRange);
    expectNone({20}, "no vertex lies inside");
    expectNone({0, 1, 2, 3, 4, 5, 6, 7}, "covers all of 1 component of the mesh (with faces 0)");
}

TEST(ObstacleField, RefusesOptionsThatMakeNone) {
    EXPECT_THROW(FieldOptions{.obstacleSlope = 0.0}.validate(), InputError);
    EXPECT_THROW(FieldOptions{.obstacleValue = std::nan("")}.validate(), InputError);
}

}  // namespace
}  // namespace bspline_curve
