// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/initial_path.h"

#include "support/meshes.h"
#include "surface/surface_point.h"
#include "surface/triangle_tree.h"
#include "utility/worker_thread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

/// Paths on a rough sphere with as many faces as it takes to find ways among patches.
class InitialPaths : public testing::Test {
protected:
    static constexpr double kChordDistance = 1e-4;

    [[nodiscard]] PickPath path(PathKind kind, WorkerThread* side = nullptr) const {
        const std::vector<SurfacePoint> picks = {
            {0, Vec3(1.0, 0.0, 0.0)}, {7000, Vec3(0.2, 0.3, 0.5)}, {14000, Vec3(0.0, 0.5, 0.5)}
        };
        return makePickPath(
            surface_,
            extended_,
            picks,
            true,
            {.blockedFaces = {},
             .patches = &patches_,
             .kind = kind,
             .chordDistance = kChordDistance,
             .side = side}
        );
    }

    [[nodiscard]] bool shareAFace(const SurfacePoint& a, const SurfacePoint& b) const {
        const std::vector<int> first = facesHolding(surface_, a);
        const std::vector<int> second = facesHolding(surface_, b);
        std::vector<int> common;
        std::ranges::set_intersection(first, second, std::back_inserter(common));
        return !common.empty();
    }

    /// Between how many of its points a path leaves the surface.
    [[nodiscard]] int gapsIn(const PickPath& path) const {
        int gaps = 0;
        for (std::size_t i = 1; i < path.path.points.size(); ++i) {
            gaps += shareAFace(path.path.points[i - 1].point, path.path.points[i].point) ? 0 : 1;
        }
        return gaps;
    }

    /// From the surface, both in the shell's frame.
    [[nodiscard]] double distanceAt(const Vec3& point) const {
        return std::sqrt(tree_.closestPoint(extended_.frame.toUser(point)).squaredDistance) /
               extended_.frame.scale;
    }

private:
    Surface surface_{withNoise(icosphere(5), 0.003, 3)};
    TriangleTree tree_{surface_.vertices(), surface_.faces()};
    ExtendedSurface extended_ = extendSurface(surface_, 3);
    PatchLevels patches_{surface_};
};

TEST_F(InitialPaths, AreTheSameOnTwoThreads) {
    WorkerThread side;
    for (const PathKind kind : {PathKind::Quick, PathKind::Close, PathKind::OnSurface}) {
        const PickPath alone = path(kind);
        const PickPath both = path(kind, &side);
        ASSERT_EQ(alone.path.points.size(), both.path.points.size());
        for (std::size_t i = 0; i < alone.path.points.size(); ++i) {
            EXPECT_EQ(alone.path.points[i].parameter, both.path.points[i].parameter);
            EXPECT_EQ(alone.path.points[i].position, both.path.points[i].position);
        }
    }
}

TEST_F(InitialPaths, LieOnTheSurfaceWhereAsked) {
    const PickPath onSurface = path(PathKind::OnSurface);
    EXPECT_EQ(gapsIn(onSurface), 0);
    EXPECT_GT(gapsIn(path(PathKind::Quick)), 0);
    EXPECT_EQ(onSurface.path.points.back().parameter, 1.0);
    EXPECT_TRUE(std::ranges::is_sorted(onSurface.path.points, {}, &InitialPath::Point::parameter));
}

TEST_F(InitialPaths, HaveChordsCloseToTheSurfaceWhereAsked) {
    const auto farthest = [this](const PickPath& path) {
        double most = 0.0;
        const std::vector<InitialPath::Point>& points = path.path.points;
        for (std::size_t i = 1; i < points.size(); ++i) {
            most = std::max(most, distanceAt(0.5 * (points[i - 1].position + points[i].position)));
        }
        return most;
    };
    EXPECT_GT(farthest(path(PathKind::Quick)), 10.0 * kChordDistance);
    EXPECT_LE(farthest(path(PathKind::Close)), kChordDistance);
}

TEST_F(InitialPaths, AreAsLongEitherWay) {
    const auto lengthOf = [](const PickPath& path) {
        double length = 0.0;
        for (std::size_t i = 1; i < path.path.points.size(); ++i) {
            length += (path.path.points[i].position - path.path.points[i - 1].position).norm();
        }
        return length;
    };
    const double quick = lengthOf(path(PathKind::Quick));
    EXPECT_NEAR(lengthOf(path(PathKind::OnSurface)), quick, 0.02 * quick);
    EXPECT_NEAR(lengthOf(path(PathKind::Close)), quick, 0.02 * quick);
}

// The way leads round the disc, and a string pulled taut would leave that way again.
TEST(InitialPathsBesideObstacles, StayOutside) {
    const Surface surface(plate(70, 70));
    const ExtendedSurface extended = extendSurface(surface, 3);
    const PatchLevels patches(surface);
    ASSERT_FALSE(patches.levels().empty());
    const Vec3 centre(0.5, 0.5, 0.0);
    Region disc;
    for (int f = 0; f < surface.faceCount(); ++f) {
        if ((surface.position({f, Vec3::Constant(1.0 / 3.0)}) - centre).norm() < 0.1) {
            disc.push_back(f);
        }
    }
    const Obstacles obstacles(surface, extended, disc, 0.02);
    const TriangleTree tree(surface.vertices(), surface.faces());
    const PickPath path = makePickPath(
        surface,
        extended,
        {tree.closestPoint({0.1, 0.48, 0.0}).point, tree.closestPoint({0.9, 0.49, 0.0}).point},
        false,
        {.blockedFaces = {}, .obstacles = &obstacles, .patches = &patches}
    );
    for (const InitialPath::Point& point : path.path.points) {
        EXPECT_FALSE(obstacles.isAvoided(point.point.face));
    }
}

/// A quick path between the points of a mesh that are nearest to two others.
std::vector<Vec3> quickPath(const TriangleMesh& mesh, const Vec3& from, const Vec3& to) {
    const Surface surface(mesh);
    const ExtendedSurface extended = extendSurface(surface, 3);
    const PatchLevels patches(surface);
    const TriangleTree tree(surface.vertices(), surface.faces());
    const PickPath path = makePickPath(
        surface,
        extended,
        {tree.closestPoint(from).point, tree.closestPoint(to).point},
        false,
        {.blockedFaces = {}, .patches = &patches}
    );
    std::vector<Vec3> points;
    for (const InitialPath::Point& point : path.path.points) {
        points.push_back(surface.position(point.point));
    }
    return points;
}

double lengthOf(const std::vector<Vec3>& points) {
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        length += (points[i] - points[i - 1]).norm();
    }
    return length;
}

// No walk leads over the edge of the wedge, but the string stays one, with a path over the edge.
TEST(InitialPathsOverEdges, ArePolylinesBesideThese) {
    constexpr int kCells = 100;
    const std::vector<Vec3> points = quickPath(wedge(kCells), {0.3, 0.4, 1.0}, {0.76, 0.6, 0.2});
    int apart = 0;
    bool isOnEdge = false;
    for (std::size_t i = 1; i < points.size(); ++i) {
        apart += (points[i] - points[i - 1]).norm() > 1.5 / kCells ? 1 : 0;
        isOnEdge = isOnEdge || (points[i] - Vec3(1.0, points[i].y(), 1.0)).norm() < 1e-9;
    }
    EXPECT_GT(apart, 27);  // of 32
    EXPECT_TRUE(isOnEdge);
}

TEST(InitialPathsOverEdges, DoNotPassThroughAThinPlate) {
    const double length =
        lengthOf(quickPath(box(60, {1.0, 1.0, 0.01}), {0.7, 0.5, 0.01}, {0.7, 0.52, 0.0}));
    EXPECT_GT(length, 0.6);
    EXPECT_LT(length, 0.7);
}

}  // namespace
}  // namespace bspline_curve
