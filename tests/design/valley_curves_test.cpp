// SPDX-License-Identifier: GPL-3.0-or-later
// Curves on a plate with a sinusoidal valley in the field: the stronger the field, the nearer.
#include "curve_checks.h"
#include "either_shell.h"
#include "field_checks.h"
#include "support/meshes.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr double kPi = std::numbers::pi;

double heightOfValley(double x) {
    return std::sin(x);
}

double distanceToValley(const Vec3& p) {
    constexpr int kPieces = 400;
    double least = std::numeric_limits<double>::infinity();
    const auto on = [](int i) {
        const double x = 2.0 * kPi * i / kPieces;
        return Vec3(x, heightOfValley(x), 0.0);
    };
    for (int i = 0; i < kPieces; ++i) {
        least = std::min(least, distanceToSegment(p, on(i), on(i + 1)));
    }
    return least;
}

// A plate [0, 2 pi] x [-2, 2] with a valley along y = sin x; all picks have y = 0, and so lie off
// the valley by up to 0.18.
class Valley : public EitherShell {
protected:
    static constexpr double kEdge = 0.1;  // of a cell

    static TriangleMesh makeMesh() {
        TriangleMesh mesh = plate(63, 40, 2.0 * kPi, 4.0);
        for (Vec3& v : mesh.vertices) {
            v.y() -= 2.0;
        }
        return mesh;
    }

    [[nodiscard]] Curve curveAt(double weight, int degree, const std::vector<double>& field) const {
        SolverOptions options;
        options.degree = degree;
        options.fieldWeight = weight;
        Curve curve = designer_.design(picks_, options, {}, {.field = field});
        expectGoodCurve(designer_, curve, picks_);
        return curve;
    }

    // Farther from the picks than the way into the valley is long.
    [[nodiscard]] double meanDistance(const Curve& curve) const {
        return meanWhere(curve.polyline, distanceToValley, [this](const Vec3& p) {
            return std::ranges::all_of(picks_, [&](const Vec3& pick) {
                return (p - pick).norm() > 0.5;
            });
        });
    }

    TriangleMesh mesh_ = makeMesh();
    CurveDesigner designer_ = designerOn(mesh_);
    std::vector<double> field_ =
        sampled(mesh_, [](const Vec3& v) { return std::pow(v.y() - heightOfValley(v.x()), 2.0); });
    std::vector<Vec3> picks_ = {{0.15, 0, 0}, {kPi, 0, 0}, {6.1, 0, 0}};
};

// The field is linear between the vertices, so its own valley lies off the sine by a few hundredths
// of an edge; what is left at 1e5 is that.
TEST_P(Valley, StrongerFieldsPullTheCurveIn) {
    for (const int degree : {2, 3, 4}) {
        SCOPED_TRACE("degree " + std::to_string(degree));
        double before = std::numeric_limits<double>::infinity();
        for (const double weight : {0.0, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4}) {
            SCOPED_TRACE("mu = " + std::to_string(weight));
            const double mean = meanDistance(curveAt(weight, degree, field_));
            EXPECT_LT(mean, before);
            before = mean;
        }
        EXPECT_LT(before, 0.1 * kEdge);
        EXPECT_LT(meanDistance(curveAt(1e5, degree, field_)), 0.1 * kEdge);
    }
}

TEST_P(Valley, PullsAtTheDefaultWeight) {
    const double free = meanDistance(curveAt(0.0, 3, field_));
    EXPECT_GT(free, 7.0 * kEdge);
    EXPECT_LT(meanDistance(curveAt(SolverOptions().fieldWeight, 3, field_)), 0.3 * kEdge);
}

// The field rises by as much as the noise over three edges.
TEST_P(Valley, NoiseOnTheFieldMovesTheCurveByAnEdge) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        std::vector<double> noisy = field_;
        for (double& value : noisy) {
            value += random.uniform(-0.1, 0.1);
        }
        const Curve curve = curveAt(SolverOptions().fieldWeight, 3, noisy);
        EXPECT_LT(meanDistance(curve), 1.5 * kEdge) << curve.report.knotsLast << " knots";
    }
}

INSTANTIATE_TEST_SUITE_P(Shells, Valley, kEitherShell, nameOfShell);

}  // namespace
}  // namespace bspline_curve
