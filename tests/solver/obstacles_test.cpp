// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/obstacles.h"

#include "solver/barrier.h"
#include "support/meshes.h"
#include "surface/surface_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace bspline_curve {
namespace {

using namespace test_support;

// A noisy sphere every third face of which is avoided, more or less: edges and faces of all kinds.
class ObstaclesOnASphere : public testing::TestWithParam<double> {
protected:
    static Region someFaces(const Surface& surface) {
        std::mt19937_64 random(17);
        Region region;
        for (int f = 0; f < surface.faceCount(); ++f) {
            if (random() % 3 == 0) {
                region.push_back(f);
            }
        }
        return region;
    }

    [[nodiscard]] bool isIn(int face) const { return flags_[face] != 0; }

    Surface surface_{withNoise(icosphere(2), 0.01, 7)};
    ExtendedSurface extended_ = extendSurface(surface_, 3);
    Region region_ = someFaces(surface_);
    std::vector<char> flags_ = faceFlags(surface_.mesh(), region_);
    Obstacles obstacles_{surface_, extended_, region_, GetParam()};
};

TEST_P(ObstaclesOnASphere, AreCloseByOneOnTheRegionAndItsEdgesAlone) {
    for (int f = 0; f < surface_.faceCount(); ++f) {
        EXPECT_EQ(obstacles_.isAvoided(f), isIn(f));
        const bool isEnclosed =
            std::ranges::all_of(surface_.faceNeighbours()[f], [&](int g) { return isIn(g); });
        const SurfacePoint inside{f, Vec3(0.2, 0.3, 0.5)};
        EXPECT_EQ(obstacles_.closeness(inside) == 1.0, isIn(f) || isEnclosed) << "face " << f;
        EXPECT_GE(obstacles_.closeness(inside), 0.0);
        for (int k = 0; k < 3; ++k) {
            Vec3 onEdge = Vec3::Constant(0.4);
            onEdge[k] = 0.0;
            onEdge[(k + 1) % 3] = 0.6;
            const int behind = surface_.faceNeighbours()[f][k];
            const double closeness = obstacles_.closeness({f, onEdge});
            if (isIn(f) || isIn(behind)) {
                EXPECT_NEAR(closeness, 1.0, 1e-12) << "face " << f;
            } else {
                EXPECT_LT(closeness, 1.0 - 1e-3) << "face " << f;
            }
        }
    }
}

TEST_P(ObstaclesOnASphere, AreEquallyCloseFromBothSidesOfAnEdge) {
    for (int f = 0; f < surface_.faceCount(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const int behind = surface_.faceNeighbours()[f][k];
            Vec3 onEdge = Vec3::Constant(0.3);
            onEdge[k] = 0.0;
            onEdge[(k + 1) % 3] = 0.7;
            const SurfacePoint point{f, onEdge};
            EXPECT_NEAR(
                obstacles_.closeness(point),
                obstacles_.closeness(inFace(surface_, point, behind)),
                1e-12
            ) << "face "
              << f;
        }
    }
}

TEST_P(ObstaclesOnASphere, KeepPointsOnTheirEdgeHalfAsClearAsItAllows) {
    for (int f = 0; f < surface_.faceCount(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const int behind = surface_.faceNeighbours()[f][k];
            if (isIn(f) || isIn(behind)) {
                continue;
            }
            double most = 0.0;
            for (int i = 0; i <= 100; ++i) {
                Vec3 onEdge = Vec3::Zero();
                onEdge[(k + 1) % 3] = 0.01 * i;
                onEdge[(k + 2) % 3] = 1.0 - 0.01 * i;
                most = std::max(most, 1.0 - obstacles_.closeness({f, onEdge}));
            }
            for (const double s : {0.0, 0.05, 0.5, 1.0}) {
                Vec3 onEdge = Vec3::Zero();
                onEdge[(k + 1) % 3] = s;
                onEdge[(k + 2) % 3] = 1.0 - s;
                const SurfacePoint kept = obstacles_.keptClear({f, onEdge}, k);
                EXPECT_EQ(kept.barycentric[k], 0.0);
                EXPECT_GE(1.0 - obstacles_.closeness(kept), 0.5 * most - 1e-9) << "face " << f;
                if (1.0 - obstacles_.closeness({f, onEdge}) >= 0.5 * most) {
                    EXPECT_EQ(kept.barycentric, onEdge);
                }
            }
        }
    }
}

TEST_P(ObstaclesOnASphere, CostPathsMoreTheCloserTheyAre) {
    for (int f = 0; f < surface_.faceCount(); ++f) {
        EXPECT_EQ(std::isinf(obstacles_.pathCost(f)), isIn(f));
        EXPECT_GE(obstacles_.pathCost(f), 1.0);
        EXPECT_EQ(obstacles_.pathCost(f) == 1.0, !isIn(f) && obstacles_.isFar(f));
    }
}

// Less than an edge, and several.
INSTANTIATE_TEST_SUITE_P(Margins, ObstaclesOnASphere, testing::Values(0.05, 1.0));

TEST(AvoidanceBarrier, HasTheDerivativesOfItsDifferences) {
    for (const double x : {0.0, 0.1, 0.5, 0.9, 0.999}) {
        const double step = 1e-6 * (1.0 - x);
        const Barrier here = avoidanceBarrier(x);
        const Barrier up = avoidanceBarrier(x + step);
        const Barrier down = avoidanceBarrier(x - step);
        EXPECT_NEAR((up.value - down.value) / (2.0 * step), here.slope, 1e-7 * (1.0 + here.slope));
        EXPECT_NEAR((up.slope - down.slope) / (2.0 * step), here.curvature, 1e-7 * here.curvature);
    }
    EXPECT_EQ(avoidanceBarrier(0.0).value, 0.0);
    EXPECT_EQ(avoidanceBarrier(0.0).slope, 0.0);
}

}  // namespace
}  // namespace bspline_curve
