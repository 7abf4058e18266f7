// SPDX-License-Identifier: GPL-3.0-or-later
// By which points a line is known that is to become smooth.
#include "design/line_points.h"

#include "design/initial_path.h"
#include "support/places.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

/// Two edges along x with a face on either side, those below the second thrice as high.
TriangleMesh facesOfTwoSizes() {
    return {
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {1.5, 1, 0}, {1.5, -3, 0}},
        {{0, 1, 3}, {1, 0, 4}, {1, 2, 5}, {2, 1, 6}, {1, 5, 3}, {1, 4, 6}}
    };
}

struct KnownLine {
    KnownLine(const TestSurface& ground, const std::vector<Vec3>& vertices) {
        PickPath path =
            makePickPath(ground.surface, ground.extended, ground.nearest(vertices), false, {});
        line.path = std::move(path.path);
        alongEdges =
            findLinePoints(ground.surface, ground.extended, path.picks, {100.0, 1e-6}, line);
        for (const MeasuredLine::Point& point : line.points) {
            points.push_back(ground.extended.frame.toUser(point.position));
        }
    }

    MeasuredLine line;
    std::vector<Vec3> points;
    double alongEdges = 0.0;
};

TEST(LinePoints, LieHalfwayBetweenTheFacesBesideAnEdge) {
    const TestSurface ground(facesOfTwoSizes());
    const KnownLine known(ground, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
    ASSERT_EQ(known.points.size(), 2U);
    EXPECT_LT((known.points[0] - Vec3(0.5, 0, 0)).norm(), 1e-12);
    EXPECT_LT((known.points[1] - Vec3(1.5, -1.0 / 3.0, 0)).norm(), 1e-12);
    // The middles of the faces are 2/3 and 4/3 apart.
    EXPECT_NEAR(known.line.points[0].weight / known.line.points[1].weight, 4.0, 1e-12);
    EXPECT_NEAR(known.alongEdges, 1.0, 1e-12);
}

TEST(LinePoints, AreTheMiddlesOfOtherPieces) {
    const TestSurface ground(facesOfTwoSizes());
    // Across faces, then along the boundary.
    const KnownLine known(ground, {{0.5, 0.2, 0}, {0.5, 1, 0}, {1.5, 1, 0}});
    ASSERT_EQ(known.points.size(), 2U);
    EXPECT_LT((known.points[0] - Vec3(0.5, 0.6, 0)).norm(), 1e-12);
    EXPECT_LT((known.points[1] - Vec3(1.0, 1.0, 0)).norm(), 1e-12);
    EXPECT_DOUBLE_EQ(known.line.points[0].weight, 1.0);
    EXPECT_DOUBLE_EQ(known.line.points[1].weight, 1.0);
    EXPECT_DOUBLE_EQ(known.alongEdges, 0.0);
}

TEST(LinePoints, WeighNoEdgeMuchMoreThanTheMean) {
    TriangleMesh mesh = facesOfTwoSizes();
    mesh.vertices[3].y() = 1e-3;  // the faces beside the first edge are slivers
    mesh.vertices[4].y() = -1e-3;
    const TestSurface ground(mesh);
    const KnownLine known(ground, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
    EXPECT_DOUBLE_EQ(known.line.points[0].weight, 16.0);
    EXPECT_NEAR(known.line.points[1].weight, 0.5, 1e-6);
}

}  // namespace
}  // namespace bspline_curve
