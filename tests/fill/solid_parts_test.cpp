// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "fill/based_parts.h"
#include "fill/thick_parts.h"
#include "imprint/part_choice.h"
#include "imprint/projected_polyline.h"
#include "support/meshes.h"
#include "support/orientation.h"
#include "support/refusal.h"
#include "surface/self_intersection.h"
#include "surface/surface.h"
#include "surface/triangle_tree.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

// Parts that become solids, against closed forms.
namespace bspline_curve {

namespace {

using namespace test_support;
using std::numbers::pi;

/// Without a boundary, oriented, manifold, and without faces that cross each other.
void expectSound(const TriangleMesh& mesh) {
    const Surface surface(mesh);  // throws where it is not manifold or not oriented
    for (const Triangle& neighbours : surface.faceNeighbours()) {
        EXPECT_GE(*std::ranges::min_element(neighbours), 0);
    }
    int crossings = 0;
    const TriangleTree tree(mesh.vertices, mesh.faces);
    tree.forEachOverlappingPair([&](int i, int j) {
        crossings += trianglesIntersect(mesh.vertices, mesh.faces[i], mesh.faces[j]) ? 1 : 0;
    });
    EXPECT_EQ(crossings, 0);
}

/// A mesh with closed curves, each through points of a turn.
struct Curves {
    using Points = std::function<Vec3(double turn)>;

    Curves(TriangleMesh mesh, const std::vector<Points>& curves) : surface(std::move(mesh)) {
        const TriangleTree tree(surface.vertices(), surface.faces());
        std::vector<SurfacePolyline> lines;
        for (const Points& at : curves) {
            std::vector<Vec3> points;
            for (int i = 0; i < 80; ++i) {
                points.push_back(at(2.0 * pi * i / 80));
            }
            lines.push_back(
                projectedPolyline(surface, tree, {.points = points, .closed = true}, 0.1)
            );
        }
        imprinted = imprint(surface, lines, {});
        parts = partsOf(imprinted);
    }

    [[nodiscard]] std::vector<int> smallest() const {
        return chosenParts(imprinted, parts, {.which = PartChoice::Which::Smallest});
    }

    Surface surface;
    ImprintedMesh imprinted;
    MeshParts parts;
};

Curves::Points circle(double radius, double height, const Vec3& middle = Vec3::Zero()) {
    return [=](double turn) {
        return Vec3(middle + Vec3(radius * std::cos(turn), radius * std::sin(turn), height));
    };
}

Curves onPlane() {
    return {jitteredPlate(24, 24, 0.2, 3), {circle(0.3, 0.0, {0.5, 0.5, 0.0})}};
}

/// The cap of the unit sphere within 45 degrees of the pole.
Curves onSphere() {
    return {icosphere(5), {circle(std::sin(pi / 4), std::cos(pi / 4))}};
}

/// Between two circles on the outside of a torus: 60 degrees up and down.
Curves onTorus() {
    const double height = 0.3 * std::sin(pi / 3);
    const double radius = 1.0 + 0.3 * std::cos(pi / 3);
    return {torus(160, 60), {circle(radius, height), circle(radius, -height)}};
}

TEST(ThickParts, OfAPlaneArePrisms) {
    const Curves given = onPlane();
    for (const double thickness : {0.1, -0.1, 1e-5, 3.0}) {
        const ThickParts thick =
            thickened(given.imprinted, given.parts, given.smallest(), thickness);
        expectSound(thick.solid.mesh);
        EXPECT_EQ(thick.thinner, 0);
        const double area = given.parts.parts[given.smallest().front()].area;
        const double volume = area * std::abs(thickness);
        EXPECT_NEAR(volumeOf(thick.solid.mesh), volume, 1e-9 * volume);
    }
}

TEST(ThickParts, OfASphereAreShells) {
    const Curves given = onSphere();
    const double solidAngle = 2.0 * pi * (1.0 - std::cos(pi / 4));
    for (const double thickness : {0.2, -0.2, 0.01, -0.9}) {
        const ThickParts thick =
            thickened(given.imprinted, given.parts, given.smallest(), thickness);
        expectSound(thick.solid.mesh);
        EXPECT_EQ(thick.thinner, 0);
        const double volume = solidAngle / 3.0 * std::abs(std::pow(1.0 + thickness, 3) - 1.0);
        EXPECT_NEAR(volumeOf(thick.solid.mesh), volume, 0.01 * volume);
    }
}

TEST(ThickParts, OfATorusAreRingsOfTheirProfile) {
    const Curves given = onTorus();
    for (const double thickness : {0.1, -0.1}) {
        const ThickParts thick =
            thickened(given.imprinted, given.parts, given.smallest(), thickness);
        expectSound(thick.solid.mesh);
        // Pappus: the integral of 2 pi (1 + r cos a) r over the profile's r and a.
        const double angle = 2.0 * pi / 3.0;
        const double outer = std::max(0.3, 0.3 + thickness);
        const double inner = std::min(0.3, 0.3 + thickness);
        const double volume =
            2.0 * pi *
            (angle * (std::pow(outer, 2) - std::pow(inner, 2)) / 2.0 +
             2.0 * std::sin(angle / 2.0) * (std::pow(outer, 3) - std::pow(inner, 3)) / 3.0);
        EXPECT_NEAR(volumeOf(thick.solid.mesh), volume, 0.01 * volume);
    }
}

TEST(ThickParts, OfABoxKeepSharpEdges) {
    // A ring half way up.
    const Curves given(box(6), {[](double turn) {
                           const Vec3 way(std::cos(turn), std::sin(turn), 0.0);
                           return Vec3(Vec3::Constant(0.5) + 0.5 * way / way.cwiseAbs().maxCoeff());
                       }});
    const ThickParts thick = thickened(given.imprinted, given.parts, {0}, 0.25);
    expectSound(thick.solid.mesh);
    Vec3 low = Vec3::Zero();
    Vec3 high = Vec3::Zero();
    for (const Vec3& vertex : thick.solid.mesh.vertices) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    EXPECT_NEAR(std::max(-low.x(), high.x() - 1.0), 0.25, 1e-12);
    EXPECT_NEAR(std::max(-low.z(), high.z() - 1.0), 0.25, 1e-12);
}

TEST(ThickParts, AreThinnerWhereThePartLeavesNoRoom) {
    // A thickness inwards of more than the tube's radius.
    const Curves given = onTorus();
    const ThickParts thick = thickened(given.imprinted, given.parts, given.smallest(), -0.5);
    expectSound(thick.solid.mesh);
    EXPECT_TRUE(thick.solid.crossing.empty());
    EXPECT_GT(thick.thinner, 100);
    EXPECT_LT(thick.least, 0.7);
    EXPECT_GT(volumeOf(thick.solid.mesh), 0.0);
}

TEST(ThickParts, NameFacesWhereThePartCrossesItself) {
    const TriangleMesh plates = crossingPlates();
    const Surface surface(plates);
    const ImprintedMesh imprinted = imprint(surface, {}, {});
    const MeshParts parts = partsOf(imprinted);
    const ThickParts thick = thickened(imprinted, parts, {0, 1}, 0.05);
    EXPECT_FALSE(thick.solid.crossing.empty());
    for (const int face : thick.solid.crossing) {
        EXPECT_LT(face, static_cast<int>(thick.solid.mesh.faces.size()));
    }
}

TEST(ThickParts, RefuseNoThickness) {
    const Curves given = onPlane();
    expectRefused(
        [&] { return thickened(given.imprinted, given.parts, given.smallest(), 0.0); },
        InputErrorCode::BadOption,
        "the thickness must be a number other than 0"
    );
}

TEST(BasedParts, OfAPlaneArePrisms) {
    const Curves given = onPlane();
    const double area = given.parts.parts[given.smallest().front()].area;
    const auto volumeWith = [&](const PartBase& base) {
        const FilledParts solid = based(given.imprinted, given.parts, given.smallest(), base);
        expectSound(solid.mesh);
        EXPECT_TRUE(solid.crossing.empty());
        EXPECT_EQ(solid.source.size(), solid.mesh.vertices.size());
        EXPECT_EQ(solid.faces.size(), solid.mesh.faces.size());
        return volumeOf(solid.mesh);
    };
    EXPECT_NEAR(volumeWith({.length = 0.25}), 0.25 * area, 1e-12);
    // A slanted one: the mean height over the part is that of its middle.
    const Vec3 slanted(1.0, 0.0, -2.0);
    const double height = 1.0;
    const Vec3 middle = given.parts.parts[given.smallest().front()].centroid;
    const double below = height - slanted.normalized().dot(middle);
    EXPECT_NEAR(
        volumeWith({.length = 0.0, .direction = slanted, .height = height}),
        below * area * 2.0 / std::sqrt(5.0),
        1e-12
    );
}

TEST(BasedParts, OfASphereAreCapsOnCylinders) {
    const Curves given = onSphere();
    const FilledParts solid =
        based(given.imprinted, given.parts, given.smallest(), {.length = 0.5});
    expectSound(solid.mesh);
    const double radius = std::sin(pi / 4);
    const double height = 1.0 - std::cos(pi / 4);
    const double volume = pi * height * height * (3.0 - height) / 3.0 + pi * radius * radius * 0.5;
    EXPECT_NEAR(volumeOf(solid.mesh), volume, 0.01 * volume);
}

/// The upper half of a torus has two rims, one in the other.
TEST(BasedParts, OfATorusHaveItsHole) {
    const Curves given(torus(160, 60), {circle(1.3, 0.0), circle(0.7, 0.0)});
    const FilledParts solid = based(
        given.imprinted,
        given.parts,
        given.smallest(),
        {.length = 0.0, .direction = Vec3(0.0, 0.0, -1.0), .height = 0.5}
    );
    expectSound(solid.mesh);
    const bool isUpper = given.parts.parts[given.smallest().front()].centroid.z() > 0.0;
    ASSERT_TRUE(isUpper);
    const double ring = pi * (1.3 * 1.3 - 0.7 * 0.7);
    const double volume = pi * pi * 0.3 * 0.3 + 0.5 * ring;
    EXPECT_NEAR(volumeOf(solid.mesh), volume, 0.01 * volume);
}

TEST(BasedParts, NameFacesWhereWallsPassThroughThePart) {
    // A hole on the inner side of a torus, whose rim is extruded across, to beyond the torus.
    const Curves given(torus(160, 60), {[](double turn) {
                           return Vec3(0.71, 0.12 * std::cos(turn), 0.12 * std::sin(turn));
                       }});
    const FilledParts solid = based(
        given.imprinted,
        given.parts,
        {0},
        {.length = 0.5, .direction = Vec3(-1.0, 0.0, 0.0), .height = std::nullopt}
    );
    EXPECT_FALSE(solid.crossing.empty());
    for (const int face : solid.crossing) {
        EXPECT_EQ(solid.labels[face], -1);
    }
}

TEST(BasedParts, AreRefusedWhereNoPlaneFits) {
    const Curves given = onSphere();
    const auto with = [&](const PartBase& base) {
        return
            [&given, base] { return based(given.imprinted, given.parts, given.smallest(), base); };
    };
    const Vec3 down(0.0, 0.0, -1.0);
    expectRefused(
        with({.length = 0.0}),
        InputErrorCode::BadOption,
        "the length of a base must be a number above 0"
    );
    expectRefused(
        with({.length = 1.0, .direction = Vec3(Vec3::Zero())}),
        InputErrorCode::BadOption,
        "the direction of a base must have numbers, not all 0"
    );
    expectRefused(
        with({.length = 0.0, .direction = down, .height = -0.75}),
        InputErrorCode::NoPath,
        "the base: the part reaches 0.04"
    );
    expectRefused(
        with({.length = 1.0, .direction = Vec3(-down)}),
        InputErrorCode::NoPath,
        "the base: its plane is on the outer side of a part; give the opposite direction"
    );
    expectRefused(
        with({.length = 1.0, .direction = Vec3(1.0, 0.0, 0.0)}),
        InputErrorCode::NoPath,
        "the base: the rim crosses or touches itself as seen along the direction; give another one"
    );
}

}  // namespace

}  // namespace bspline_curve
