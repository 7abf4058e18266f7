// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/guide_path.h"

#include "support/meshes.h"
#include "surface/surface_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

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

}  // namespace
}  // namespace bspline_curve
