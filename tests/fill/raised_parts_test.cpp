// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/raised_parts.h"

#include "imprint/part_choice.h"
#include "imprint/projected_polyline.h"
#include "support/meshes.h"
#include "support/orientation.h"
#include "support/refusal.h"
#include "surface/surface.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bspline_curve {

namespace {

using namespace test_support;

int boundaryEdges(const TriangleMesh& mesh) {
    const Surface surface(mesh);  // throws where it is not manifold
    int count = 0;
    for (const Triangle& neighbours : surface.faceNeighbours()) {
        count += static_cast<int>(std::ranges::count_if(neighbours, [](int f) { return f < 0; }));
    }
    return count;
}

/// A closed polyline through points near a surface.
SurfacePolyline projected(const Surface& surface, const std::vector<Vec3>& points) {
    const TriangleTree tree(surface.vertices(), surface.faces());
    return projectedPolyline(surface, tree, {.points = points, .closed = true}, 0.1);
}

/// A closed curve on the unit sphere, at this angle from the pole.
SurfacePolyline circleOfLatitude(const Surface& sphere, double angle) {
    std::vector<Vec3> points;
    for (int i = 0; i < 40; ++i) {
        const double longitude = 2.0 * std::numbers::pi * i / 40;
        points.emplace_back(
            std::sin(angle) * std::cos(longitude),
            std::sin(angle) * std::sin(longitude),
            std::cos(angle)
        );
    }
    return projected(sphere, points);
}

struct Cap {
    explicit Cap(int level = 4) : sphere(icosphere(level)) {}

    Surface sphere;
    ImprintedMesh imprinted =
        imprint(sphere, std::vector{circleOfLatitude(sphere, std::numbers::pi / 4)}, {});
    MeshParts parts = partsOf(imprinted);
    std::vector<int> cap = chosenParts(imprinted, parts, {.which = PartChoice::Which::Smallest});
};

TEST(RaisedParts, OfASphereAreShellsOfTheirHeight) {
    const Cap given;
    const double before = volumeOf(given.imprinted.mesh);
    const double share = (1.0 - std::cos(std::numbers::pi / 4)) / 2.0;  // of the ball, as a cone
    for (const double height : {0.1, -0.1, 1e-6}) {
        const RaisedParts raised = raisedParts(given.imprinted, given.parts, given.cap, height);
        EXPECT_EQ(boundaryEdges(raised.whole.mesh), 0);
        EXPECT_EQ(raised.lower, 0);
        EXPECT_TRUE(raised.whole.crossing.empty());
        const double grown = share * (std::pow(1.0 + height, 3) - 1.0) * before;
        EXPECT_NEAR(volumeOf(raised.whole.mesh) - before, grown, 0.02 * std::abs(grown));
        // What is not raised is as it was.
        for (std::size_t f = 0; f < given.parts.labels.size(); ++f) {
            if (given.parts.labels[f] != given.cap.front()) {
                EXPECT_EQ(raised.whole.mesh.faces[f], given.imprinted.mesh.faces[f]);
            }
        }
        EXPECT_EQ(raised.whole.labels.back(), -1);
        EXPECT_EQ(raised.whole.faces.size(), raised.whole.mesh.faces.size());
        EXPECT_EQ(raised.whole.source.size(), raised.whole.mesh.vertices.size());
    }
}

// Faces of a coarse mesh come to lie at the height, whatever the angles between them: embossed and
// engraved together have twice the area times the height.
TEST(RaisedParts, OfCoarseMeshesHaveTheVolumeOfTheirPrisms) {
    const Cap given(1);
    const double area = given.parts.parts[static_cast<std::size_t>(given.cap.front())].area;
    constexpr double kHeight = 1e-3;
    const auto volume = [&](double height) {
        const RaisedParts raised = raisedParts(given.imprinted, given.parts, given.cap, height);
        EXPECT_EQ(raised.lower, 0);
        return volumeOf(raised.whole.mesh);
    };
    const double moved = volume(kHeight) - volume(-kHeight);
    EXPECT_NEAR(moved, 2.0 * kHeight * area, 1e-5 * moved);
}

TEST(RaisedParts, OfNoHeightAreTheImprint) {
    const Cap given;
    const RaisedParts raised = raisedParts(given.imprinted, given.parts, given.cap, 0.0);
    EXPECT_EQ(raised.whole.mesh.faces, given.imprinted.mesh.faces);
    EXPECT_EQ(raised.whole.mesh.vertices, given.imprinted.mesh.vertices);
}

TEST(RaisedParts, ThatWouldPassThroughThemselvesAreLower) {
    const Cap given;
    const RaisedParts raised = raisedParts(given.imprinted, given.parts, given.cap, -1.5);
    EXPECT_TRUE(raised.whole.crossing.empty());
    EXPECT_GT(raised.lower, 100);
    EXPECT_GT(raised.least, 0.1);
    EXPECT_LT(raised.least, 1.0 / 1.5);
    EXPECT_EQ(boundaryEdges(raised.whole.mesh), 0);
    EXPECT_GT(volumeOf(raised.whole.mesh), 0.0);
}

// Two lobes that meet in one vertex, on a plate whose boundary a third part reaches.
TEST(RaisedParts, ThatMeetInAVertexStayManifold) {
    const Surface plate(jitteredPlate(12, 12, 0.2, 5));
    const Vec3 middle(0.5, 0.5, 0.0);
    const std::vector<Vec3> bow = {
        {0.25, 0.3, 0.0}, middle, {0.75, 0.7, 0.0}, {0.75, 0.3, 0.0}, middle, {0.25, 0.7, 0.0}
    };
    const ImprintedMesh imprinted = imprint(plate, std::vector{projected(plate, bow)}, {});
    const MeshParts parts = partsOf(imprinted);
    ASSERT_EQ(parts.parts.size(), 3U);
    const RaisedParts lobes = raisedParts(imprinted, parts, {1, 2}, 0.1);
    EXPECT_EQ(boundaryEdges(lobes.whole.mesh), 48);
    EXPECT_TRUE(lobes.whole.crossing.empty());
    const RaisedParts around = raisedParts(imprinted, parts, {0}, 0.1);
    EXPECT_TRUE(around.whole.crossing.empty());
    EXPECT_EQ(around.lower, 0);
    EXPECT_EQ(boundaryEdges(around.whole.mesh), 48);
    const double walls = 0.1 * parts.parts[0].perimeter;
    EXPECT_NEAR(Surface(lobes.whole.mesh).area(), 1.0 + walls - 0.1 * 4.0, 1e-9);
}

TEST(RaisedParts, RefuseAHeightThatIsNotFinite) {
    const Cap given;
    expectRefused(
        [&] {
            return raisedParts(
                given.imprinted, given.parts, given.cap, std::numeric_limits<double>::infinity()
            );
        },
        InputErrorCode::BadOption,
        "the height of a relief must be finite"
    );
}

}  // namespace

}  // namespace bspline_curve
