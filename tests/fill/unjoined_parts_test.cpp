// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that are cut out over seams.
#include "fill/unjoined_parts.h"

#include "fill/raised_parts.h"
#include "imprint/projected_polyline.h"
#include "imprint/unjoined_imprint.h"
#include "support/meshes.h"
#include "support/random.h"
#include "surface/surface.h"
#include "surface/triangle_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace bspline_curve {

namespace {

using namespace test_support;

/// A round curve on a mesh near the unit sphere, about an axis that is on no vertex.
SurfacePolyline roundCurve(const Surface& surface) {
    std::vector<Vec3> points;
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), Vec3(0.9, 0.07, 0.35));
    for (int i = 0; i < 40; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 40;
        points.push_back(turn * Vec3(0.6 * std::cos(angle), 0.6 * std::sin(angle), 0.8));
    }
    const TriangleTree tree(surface.vertices(), surface.faces());
    return projectedPolyline(surface, tree, {.points = points, .closed = true}, 0.1);
}

/// A sphere with seams, and a round curve over them.
struct SeamedBall {
    explicit SeamedBall(const TriangleMesh& mesh) : surface(mesh, MendingOptions()) {
        EXPECT_TRUE(surface.provenance().hasInputCorners());
        SurfacePolyline curve = roundCurve(surface);
        surface.provenance().bringToInput(curve);
        joined = imprint(surface, std::vector{curve}, {});
        whole = unjoined(surface, joined);
        parts = partsOf(joined);
        smallest = chosenParts(joined, parts, {.which = PartChoice::Which::Smallest});
    }

    [[nodiscard]] FilledParts unjoinedOf(const FilledParts& taken) const {
        return unjoined(taken, joined, whole);
    }

    Surface surface;
    ImprintedMesh joined, whole;
    MeshParts parts;
    std::vector<int> smallest;
};

std::vector<SeamedBall> seamedBalls() {
    TriangleMesh ball = icosphere(2);
    std::vector<int> labels;
    Random random(2);
    for (std::size_t f = 0; f < ball.faces.size(); ++f) {
        labels.push_back(random.integer(0, 3));
    }
    std::vector<int> halves;
    for (const Triangle& face : ball.faces) {
        const double y =
            ball.vertices[face[0]].y() + ball.vertices[face[1]].y() + ball.vertices[face[2]].y();
        halves.push_back(y < 0.0 ? 0 : 1);
    }
    std::vector<SeamedBall> balls;
    balls.emplace_back(partedByLabels(ball, halves));
    balls.emplace_back(partedByLabels(ball, labels));
    return balls;
}

/// Boundary edges of a mesh whose seams are joined.
int openEdges(const TriangleMesh& mesh) {
    const Surface surface(mesh, MendingOptions());
    int count = 0;
    for (const Triangle& neighbours : surface.faceNeighbours()) {
        count += static_cast<int>(std::ranges::count(neighbours, -1));
    }
    return count;
}

/// The same faces at the same places, those of the imprint with the vertices of their sides.
void expectSameParts(const SeamedBall& ball, const FilledParts& before, const FilledParts& after) {
    ASSERT_EQ(after.mesh.faces.size(), before.mesh.faces.size());
    ASSERT_EQ(after.source.size(), after.mesh.vertices.size());
    ASSERT_EQ(after.faces, before.faces);
    ASSERT_EQ(after.labels, before.labels);
    std::vector<char> isUsed(after.source.size(), 0);
    for (std::size_t f = 0; f < after.faces.size(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const int vertex = after.mesh.faces[f][k];
            isUsed[vertex] = 1;
            ASSERT_EQ(after.mesh.vertices[vertex], before.mesh.vertices[before.mesh.faces[f][k]]);
            if (after.faces[f] >= 0) {
                ASSERT_EQ(after.source[vertex], ball.whole.mesh.faces[after.faces[f]][k]);
            } else {
                const int source = before.source[before.mesh.faces[f][k]];
                ASSERT_EQ(after.source[vertex] < 0, source < 0);
            }
        }
    }
    ASSERT_EQ(std::ranges::count(isUsed, 1), std::ssize(isUsed));
    ASSERT_EQ(openEdges(after.mesh), openEdges(before.mesh));
}

TEST(UnjoinedParts, AreOpenedWithTheirSeams) {
    for (const SeamedBall& ball : seamedBalls()) {
        const CutMesh cut = openedAlongCurves(ball.joined);
        for (const std::vector<int>& chosen : {ball.smallest, std::vector{0, 1}}) {
            const FilledParts open = openParts(cut, ball.parts, chosen);
            expectSameParts(ball, open, ball.unjoinedOf(open));
        }
    }
}

TEST(UnjoinedParts, AreFilledOnOneSide) {
    for (const SeamedBall& ball : seamedBalls()) {
        for (const FillShape shape : {FillShape::Flat, FillShape::Smooth}) {
            const FilledParts filled = fillAround(ball.joined, ball.parts, ball.smallest, shape);
            const FilledParts after = ball.unjoinedOf(filled);
            expectSameParts(ball, filled, after);
            EXPECT_EQ(openEdges(after.mesh), 0);
            ASSERT_EQ(after.rims.size(), 1U);
            for (std::size_t i = 0; i < after.rims[0].size(); ++i) {
                EXPECT_EQ(
                    after.mesh.vertices[after.rims[0][i]], filled.mesh.vertices[filled.rims[0][i]]
                );
            }
            EXPECT_EQ(after.endOfNew - after.firstNew[0], filled.endOfNew - filled.firstNew[0]);
            for (int v = after.firstNew[0]; v < after.endOfNew; ++v) {
                EXPECT_EQ(after.source[v], -1);
            }
            // New vertices have values as before, here harmonic heights.
            std::vector<double> heights;
            for (const Vec3& vertex : ball.whole.mesh.vertices) {
                heights.push_back(vertex.z());
            }
            std::vector<double> heightsBefore;
            for (const Vec3& vertex : ball.joined.mesh.vertices) {
                heightsBefore.push_back(vertex.z());
            }
            if (shape == FillShape::Smooth) {
                EXPECT_NEAR(
                    after.carried(heights).at(after.firstNew[0]),
                    filled.carried(heightsBefore).at(filled.firstNew[0]),
                    1e-14
                );
            }
        }
    }
}

TEST(UnjoinedParts, AreRaisedWithSeamsInTheirWalls) {
    for (const SeamedBall& ball : seamedBalls()) {
        const FilledParts raised = raisedParts(ball.joined, ball.parts, ball.smallest, 0.1).whole;
        const FilledParts after = ball.unjoinedOf(raised);
        expectSameParts(ball, raised, after);
        EXPECT_EQ(openEdges(after.mesh), 0);
        // Vertices of the input are still the first ones, raised or not.
        for (std::size_t v = 0; v < ball.whole.mesh.vertices.size(); ++v) {
            EXPECT_EQ(after.source[v], static_cast<int>(v));
        }
    }
    // A seam between halves leads up the wall: it stays one line, at which nothing else is open.
    const SeamedBall halves = std::move(seamedBalls().front());
    const FilledParts after =
        halves.unjoinedOf(raisedParts(halves.joined, halves.parts, halves.smallest, 0.1).whole);
    const Surface open(after.mesh);
    EXPECT_EQ(open.componentCount(), 2);
}

}  // namespace

}  // namespace bspline_curve
