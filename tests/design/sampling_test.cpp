// SPDX-License-Identifier: GPL-3.0-or-later
// The strict polyline: as fine as asked, and the same curve at every sampling.
#include "curve_checks.h"

#include <algorithm>
#include <cmath>

namespace bspline_curve {
namespace {

using namespace test_support;

class Sampling : public testing::TestWithParam<std::tuple<ShellKind, bool>> {
protected:
    [[nodiscard]] SurfacePolyline drawn(const SamplingOptions& sampling) const {
        return designer_.design(picks_, options_, sampling).polyline;
    }

    TriangleMesh mesh_ = withNoise(icosphere(3), 0.01, 29);
    CurveDesigner designer_ = designerIn(std::get<0>(GetParam()), mesh_);
    std::vector<Vec3> picks_ = verticesOf(mesh_, {5, 100, 400});
    SolverOptions options_{.closed = std::get<1>(GetParam())};
    Curve curve_ = designer_.design(picks_, options_);
};

double longestSegment(const SurfacePolyline& line) {
    double longest = 0.0;
    for (std::size_t i = line.closed ? 0 : 1; i < line.points.size(); ++i) {
        const Vec3& before = i > 0 ? line.points[i - 1] : line.points.back();
        longest = std::max(longest, (line.points[i] - before).norm());
    }
    return longest;
}

// Every vertex of `coarse` is one of `fine`.
void expectVerticesIn(const SurfacePolyline& coarse, const SurfacePolyline& fine) {
    std::size_t j = 0;
    for (std::size_t i = 0; i < coarse.points.size(); ++i) {
        while (j < fine.points.size() && fine.parameters[j] < coarse.parameters[i] - 1e-12) {
            ++j;
        }
        ASSERT_LT(j, fine.points.size()) << "vertex " << i;
        EXPECT_NEAR(fine.parameters[j], coarse.parameters[i], 1e-12) << "vertex " << i;
        EXPECT_LT((fine.points[j] - coarse.points[i]).norm(), 1e-11) << "vertex " << i;
    }
}

TEST_P(Sampling, IsStrictAtEverySampling) {
    for (const int samples : {0, 1, 2, 3, 10, 256, 5000}) {
        for (const double longest : {0.0, 0.03, 0.002}) {
            SCOPED_TRACE(
                std::to_string(samples) + " samples, segments up to " + std::to_string(longest)
            );
            const SurfacePolyline line = drawn({samples, longest});
            expectStrict(designer_.surface(), line);
            if (longest > 0.0) {
                EXPECT_LE(longestSegment(line), longest);
            }
        }
    }
}

TEST_P(Sampling, HasTheParametersAskedFor) {
    const int samples = 100;
    const SurfacePolyline line = drawn({samples, 0.0});
    for (int i = 0; i < samples; ++i) {
        const double t = static_cast<double>(i) / samples;
        EXPECT_TRUE(
            std::ranges::any_of(
                line.parameters, [&](double value) { return std::abs(value - t) < 1e-9; }
            )
        ) << "t = "
          << t;
    }
}

TEST_P(Sampling, DrawingAgainGivesTheSamePolyline) {
    const SurfacePolyline line = drawn({});
    ASSERT_EQ(line.points.size(), curve_.polyline.points.size());
    EXPECT_EQ(line.picks, curve_.polyline.picks);
    EXPECT_EQ(line.closed, curve_.polyline.closed);
    expectVerticesIn(curve_.polyline, line);
}

TEST_P(Sampling, FinerPolylinesContainCoarserOnes) {
    const SurfacePolyline none = drawn({0, 0.0});
    const SurfacePolyline some = drawn({64, 0.0});
    const SurfacePolyline many = drawn({512, 0.0});
    const SurfacePolyline shortOnes = drawn({64, 0.004});
    EXPECT_LT(none.points.size(), some.points.size());
    EXPECT_LT(some.points.size(), many.points.size());
    expectVerticesIn(none, some);
    expectVerticesIn(some, many);
    expectVerticesIn(some, shortOnes);
}

// The polyline is the shadow of the spline: nearer than the largest distance that was measured.
TEST_P(Sampling, PolylinesFollowTheSpline) {
    const SurfacePolyline& line = curve_.polyline;
    const double edge = designer_.surface().averageEdgeLength();
    double largest = 0.0;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const Vec3 p = pointOfSpline(curve_.spline, line.parameters[i]);
        largest = std::max(largest, (p - line.points[i]).norm() / edge);
    }
    EXPECT_LT(largest, 0.1);
    EXPECT_LT(largest, 1.2 * curve_.report.maxDistance);
    EXPECT_GT(largest, 0.8 * curve_.report.maxDistance);
}

TEST_P(Sampling, PicksAreVerticesOfEverySampling) {
    for (const int samples : {0, 256}) {
        const SurfacePolyline line = drawn({samples, 0.0});
        for (std::size_t i = 0; i < picks_.size(); ++i) {
            const int index = line.picks[i];
            EXPECT_EQ(line.parameters[index], curve_.spline.pickParameters[i]);
            EXPECT_EQ(line.points[index], curve_.polyline.points[curve_.polyline.picks[i]]);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    OpenAndClosed,
    Sampling,
    testing::Combine(kEitherShell, testing::Bool()),
    [](const auto& instance) {
        return (std::get<1>(instance.param) ? "Closed" : "Open") +
               nameOf(std::get<0>(instance.param));
    }
);

}  // namespace
}  // namespace bspline_curve
