// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/guide_path.h"

#include "support/meshes.h"
#include "surface/surface_point.h"
#include "surface/triangle_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

/// How far inside of the box from the origin to a corner a point lies.
double depthInBox(const Vec3& p, const Vec3& corner) {
    return std::min(p.minCoeff(), (corner - p).minCoeff());
}

/// Paths on a rough sphere with as many faces as it takes to find ways among patches.
class GuidePaths : public testing::Test {
protected:
    [[nodiscard]] PickPath path(PathKind kind) const {
        const std::vector<SurfacePoint> picks = {
            {0, Vec3(1.0, 0.0, 0.0)}, {7000, Vec3(0.2, 0.3, 0.5)}, {14000, Vec3(0.0, 0.5, 0.5)}
        };
        return makePickPath(
            surface_, base_, picks, true, {.blockedFaces = {}, .patches = &patches_, .kind = kind}
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
        for (std::size_t i = 1; i < path.guide.points.size(); ++i) {
            gaps += shareAFace(path.guide.points[i - 1].point, path.guide.points[i].point) ? 0 : 1;
        }
        return gaps;
    }

private:
    Surface surface_{withNoise(icosphere(5), 0.003, 3)};
    ShellBase base_ = makeShellBase(surface_, 3);
    PatchLevels patches_{surface_};
};

TEST_F(GuidePaths, LieOnTheSurfaceWhereAsked) {
    const PickPath onSurface = path(PathKind::OnSurface);
    EXPECT_EQ(gapsIn(onSurface), 0);
    EXPECT_GT(gapsIn(path(PathKind::Quick)), 0);
    EXPECT_EQ(onSurface.guide.points.back().parameter, 1.0);
    EXPECT_TRUE(std::ranges::is_sorted(onSurface.guide.points, {}, &GuidePath::Point::parameter));
}

TEST_F(GuidePaths, AreAsLongEitherWay) {
    const auto lengthOf = [](const PickPath& path) {
        double length = 0.0;
        for (std::size_t i = 1; i < path.guide.points.size(); ++i) {
            length += (path.guide.points[i].position - path.guide.points[i - 1].position).norm();
        }
        return length;
    };
    const double quick = lengthOf(path(PathKind::Quick));
    EXPECT_NEAR(lengthOf(path(PathKind::OnSurface)), quick, 0.02 * quick);
}

// The way leads round the disc, and a string pulled taut would leave that way again.
TEST(GuidePathsBesideObstacles, StayOutside) {
    const Surface surface(plate(70, 70));
    const ShellBase base = makeShellBase(surface, 3);
    const PatchLevels patches(surface);
    ASSERT_FALSE(patches.levels().empty());
    const Vec3 centre(0.5, 0.5, 0.0);
    Region disc;
    for (int f = 0; f < surface.faceCount(); ++f) {
        if ((surface.position({f, Vec3::Constant(1.0 / 3.0)}) - centre).norm() < 0.1) {
            disc.push_back(f);
        }
    }
    const Obstacles obstacles(surface, base, disc, 0.02);
    const TriangleTree tree(surface.vertices(), surface.faces());
    const PickPath path = makePickPath(
        surface,
        base,
        {tree.closestPoint({0.1, 0.48, 0.0}).point, tree.closestPoint({0.9, 0.49, 0.0}).point},
        false,
        {.blockedFaces = {}, .obstacles = &obstacles, .patches = &patches}
    );
    for (const GuidePath::Point& point : path.guide.points) {
        EXPECT_FALSE(obstacles.isAvoided(point.point.face));
    }
}

// Faces are so small beside the points' distances that no walk leads over the edges.
TEST(GuidePathsOverEdges, DoNotPassThroughTheBox) {
    constexpr double kThickness = 0.03;
    for (const double height : {1.0, kThickness}) {
        SCOPED_TRACE("height " + std::to_string(height));
        const Surface surface(box(60, {1.0, 1.0, height}));
        const ShellBase base = makeShellBase(surface, 3);
        const PatchLevels patches(surface);
        ASSERT_FALSE(patches.levels().empty());
        const TriangleTree tree(surface.vertices(), surface.faces());
        const SurfacePoint onTop = tree.closestPoint({0.5, 0.3, height}).point;
        const SurfacePoint below = tree.closestPoint({0.55, 0.7, 0.0}).point;
        for (const PathKind kind : {PathKind::Quick, PathKind::OnSurface}) {
            const PickPath path = makePickPath(
                surface,
                base,
                {onTop, below},
                false,
                {.blockedFaces = {}, .patches = &patches, .kind = kind}
            );
            double length = 0.0;
            double deepest = 0.0;
            for (std::size_t i = 1; i < path.guide.points.size(); ++i) {
                const Vec3 from = surface.position(path.guide.points[i - 1].point);
                const Vec3 to = surface.position(path.guide.points[i].point);
                length += (to - from).norm();
                deepest = std::max(deepest, depthInBox(0.5 * (from + to), {1.0, 1.0, height}));
            }
            EXPECT_GT(length, 0.79 + height);
            EXPECT_LT(length, 1.1 + height);
            EXPECT_LT(deepest, kind == PathKind::OnSurface ? 1e-9 : 0.02);
        }
    }
}

}  // namespace
}  // namespace bspline_curve
