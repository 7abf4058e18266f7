// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/feature_distance.h"

#include "field/make_field.h"
#include "support/meshes.h"
#include "support/refusal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double distanceToBoundary(const Vec3& p) {
    return std::min({p.x(), p.y(), 1.0 - p.x(), 1.0 - p.y()});
}

// Straight fronts are exact, whatever the faces; where two meet, at the diagonals, faces see both.
TEST(FeatureDistance, ToTheSidesOfAPlateIsExactUpToWhereFrontsMeet) {
    const TriangleMesh mesh = jitteredPlate(40, 40, 0.2, 1);
    const Surface surface(mesh);
    const auto distances = distancesTo(surface, boundaryVertices(surface), 10.0);
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const Vec3& p = mesh.vertices[i];
        const double toDiagonal = std::min(std::abs(p.x() - p.y()), std::abs(p.x() + p.y() - 1.0));
        const double tolerance = toDiagonal > 0.05 ? 1e-12 : 0.01;
        EXPECT_NEAR(distances[i], distanceToBoundary(p), tolerance) << i;
    }
}

TEST(FeatureDistance, ToOneVertexConvergesToTheDistance) {
    double before = kInfinity;
    for (const int cells : {20, 40, 80, 160}) {
        const TriangleMesh mesh = jitteredPlate(cells, cells, 0.2, 2);
        const auto distances = distancesTo(Surface(mesh), {0}, 10.0);
        double worst = 0.0;
        for (std::size_t i = 0; i < distances.size(); ++i) {
            const double exact = mesh.vertices[i].norm();
            EXPECT_GT(distances[i], exact - 1e-12);
            worst = std::max(worst, distances[i] - exact);
        }
        EXPECT_LT(worst, 0.75 * before) << cells;  // h log(1/h): 0.6 to 0.7
        before = worst;
    }
    EXPECT_LT(before, 0.02);
}

// Round a cylinder the way is longer than through it.
TEST(FeatureDistance, GoesOverTheSurface) {
    const TriangleMesh mesh = openCylinder(80, 60, 1.0, 0.2);
    const Surface surface(mesh);
    std::vector<int> seam;
    for (int j = 0; j <= 60; ++j) {
        seam.push_back(80 * j);
    }
    const auto distances = distancesTo(surface, seam, 10.0);
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const double angle = std::acos(std::clamp(mesh.vertices[i].x(), -1.0, 1.0));
        EXPECT_NEAR(distances[i], angle, 1e-3 * angle + 1e-9);  // chords of 80 segments
    }
}

TEST(FeatureDistance, EndsAtTheReach) {
    const Surface surface(plate(20, 20));
    const auto distances = distancesTo(surface, {0}, 0.3);
    EXPECT_TRUE(std::ranges::any_of(distances, [](double d) { return d > 0.25 && d <= 0.3; }));
    EXPECT_TRUE(std::ranges::all_of(distances, [](double d) {
        return d <= 0.3 || d == kInfinity;
    }));
    EXPECT_EQ(distances.back(), kInfinity);
}

TEST(FeatureDistance, FindsCreasesByTheirAngle) {
    EXPECT_EQ(creaseVertices(Surface(box(10)), 89.0).size(), 8U + 12U * 9U);
    EXPECT_TRUE(creaseVertices(Surface(box(10)), 91.0).empty());
    EXPECT_EQ(creaseVertices(Surface(openCylinder(8, 1)), 40.0).size(), 16U);
    EXPECT_TRUE(creaseVertices(Surface(openCylinder(8, 1)), 50.0).empty());
}

TEST(FeatureDistance, AsAFieldIsRelativeToTheReach) {
    for (const double unit : {1e-3, 1.0, 1e3}) {
        const TriangleMesh mesh = box(40);
        const Surface surface(transformed(mesh, Eigen::Isometry3d::Identity(), unit));
        const auto field = makeField(surface, {.kind = FieldKind::CreaseDistance}).values();
        for (std::size_t i = 0; i < field.size(); ++i) {
            // On a side of the cube one coordinate is 0 or 1; the other two say how far its edges
            // are.
            Vec3 toSide;
            for (int k = 0; k < 3; ++k) {
                toSide[k] = std::min(mesh.vertices[i][k], 1.0 - mesh.vertices[i][k]);
            }
            std::ranges::sort(toSide);
            const double exact = std::min(1.0, toSide[1] / (0.1 * std::sqrt(3.0)));
            EXPECT_NEAR(field[i], exact, 0.02) << i;
        }
    }
}

TEST(FeatureDistance, LeavesComponentsWithoutFeaturesAtOne) {
    TriangleMesh mesh = joined(plate(4, 4), icosphere(3));
    mesh.vertices.emplace_back(3, 3, 3);
    const auto field = makeField(Surface(mesh), {.kind = FieldKind::BoundaryDistance}).values();
    EXPECT_EQ(field[0], 0.0);
    for (std::size_t i = 25; i < field.size(); ++i) {
        EXPECT_EQ(field[i], 1.0);
    }
}

TEST(FeatureDistance, RefusesMeshesWithoutFeatures) {
    const auto expectNone = [](const TriangleMesh& mesh,
                               const FieldOptions& options,
                               InputErrorCode code,
                               const std::string& said) {
        expectRefused([&] { return makeField(Surface(mesh), options); }, code, said);
    };
    const TriangleMesh sphere = icosphere(3);
    const FieldOptions crease{.kind = FieldKind::CreaseDistance};
    const FieldOptions boundary{.kind = FieldKind::BoundaryDistance};
    const FieldOptions noReach{.kind = FieldKind::BoundaryDistance, .reach = 0.0};
    const InputErrorCode bad = InputErrorCode::BadField;
    const InputErrorCode option = InputErrorCode::BadOption;
    expectNone(sphere, crease, bad, "no edge of the mesh turns by more than the crease angle");
    expectNone(sphere, boundary, bad, "closed");
    expectNone(plate(2, 2), noReach, option, "field reach is 0");
    expectNone(plate(2, 2), {.creaseAngle = 181.0}, option, "crease angle is 181");
}

}  // namespace
}  // namespace bspline_curve
