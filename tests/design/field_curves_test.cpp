// SPDX-License-Identifier: GPL-3.0-or-later
// What of a field counts and what does not; the stronger a field, the nearer its valley.
#include "bspline_curve/field.h"
#include "curve_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bspline_curve {
namespace {

using namespace test_support;

class FieldOnASphere : public EitherShell {
protected:
    [[nodiscard]] Curve curveWith(
        const std::function<double(const Vec3&)>& field, const SolverOptions& options = {}
    ) const {
        return designer_.design(picks_, options, {}, {.field = sampled(mesh_, field)});
    }

    TriangleMesh mesh_ = withNoise(icosphere(3), 0.01, 23);
    CurveDesigner designer_ = designerOn(mesh_);
    std::vector<Vec3> picks_ = verticesOf(mesh_, {5, 100, 400});
    double epsilon_ = 0.1 * designer_.surface().averageEdgeLength();
};

double heightOf(const Vec3& v) {
    return v.z();
}

std::string figures(const Curve& curve, const Curve& reference) {
    return std::to_string(curve.report.knotsLast) + " instead of " +
           std::to_string(reference.report.knotsLast) + " knots, " + name(curve.report.status);
}

using Cost = std::pair<FieldCost, std::function<double(double)>>;

const std::vector<Cost> kCosts = {
    {FieldCost::Identity, [](double x) { return x; }},
    {FieldCost::Square, [](double x) { return x * x; }},
    {FieldCost::ExpMinus, [](double x) { return std::exp(-x); }},
};

TEST_P(FieldOnASphere, ConstantFieldsChangeNothing) {
    const Curve reference = designer_.design(picks_);
    for (const auto& [kind, cost] : kCosts) {
        for (const double constant : {0.0, 0.1, 1.0, 1000.0, -5.0}) {
            SCOPED_TRACE(std::string(name(kind)) + ", constant " + std::to_string(constant));
            const Curve curve =
                curveWith([&](const Vec3&) { return constant; }, {.fieldCost = kind});
            expectSameBits(curve, reference);
            EXPECT_EQ(curve.report.fieldCost, cost(constant));
            EXPECT_TRUE(curve.report.fieldAtRest);
        }
    }
}

TEST_P(FieldOnASphere, FieldsWithoutWeightChangeNothing) {
    const Curve with = curveWith(heightOf, {.fieldWeight = 0.0});
    const Curve without = designer_.design(picks_);
    expectSameBits(with, without);
    EXPECT_EQ(with.report.fieldCost, 0.0);
    EXPECT_TRUE(with.report.fieldAtRest);
}

// Their energy is far below the digits that the solver asks for, so that only rounding is left.
TEST_P(FieldOnASphere, FieldsOfHardlyAnyWeightChangeHardlyAnything) {
    const Curve reference = designer_.design(picks_);
    for (const double scale : {1e-300, 1e-20, 1e-14}) {
        SCOPED_TRACE("scale " + std::to_string(std::log10(scale)));
        const Curve low = curveWith([&](const Vec3& v) { return scale * v.z(); });
        EXPECT_LT(largestGap(low.spline, reference.spline), 1e-9) << figures(low, reference);
        const Curve light = curveWith(heightOf, {.fieldWeight = scale});
        EXPECT_LT(largestGap(light.spline, reference.spline), 1e-9) << figures(light, reference);
    }
}

// Only differences of a field matter where c(x) = x; also below zero.
TEST_P(FieldOnASphere, ConstantsAddedToTheFieldChangeNothing) {
    const Curve reference = curveWith(heightOf);
    for (const double constant : {1.0, 1000.0, -1000.0}) {
        const Curve curve = curveWith([&](const Vec3& v) { return heightOf(v) + constant; });
        EXPECT_TRUE(curve.report.usable);
        // 1e-10 measured: 1000 costs three digits of sums that stop at 1e-4.
        EXPECT_LT(largestGap(curve.spline, reference.spline), 1e-3 * epsilon_)
            << "constant " << constant << ", " << figures(curve, reference);
    }
}

// The mean of c(I) over t, by the trapezoidal rule at the vertices of the polyline.
double meanCostOver(
    const Surface& surface,
    const SurfacePolyline& line,
    const std::vector<double>& field,
    const std::function<double(double)>& cost
) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        const double here = cost(valueAt(surface, line.surfacePoints[i], field));
        const double next = cost(valueAt(surface, line.surfacePoints[i + 1], field));
        sum += 0.5 * (here + next) * (line.parameters[i + 1] - line.parameters[i]);
    }
    return sum;
}

TEST_P(FieldOnASphere, TheReportedCostIsTheMeanAlongTheCurve) {
    const std::vector<double> field =
        sampled(mesh_, [](const Vec3& v) { return v.z() + 0.5 * v.x(); });
    for (const auto& [kind, cost] : kCosts) {
        SCOPED_TRACE(name(kind));
        const SolverOptions options{.fieldWeight = 10.0, .fieldCost = kind};
        const Curve curve = designer_.design(picks_, options, {.samples = 4000}, {.field = field});
        const double expected = meanCostOver(designer_.surface(), curve.polyline, field, cost);
        // The shell of the curve's last round, and the thinner one of its polyline, project
        // differently: by 1e-4 in a simplified shell.
        EXPECT_NEAR(curve.report.fieldCost, expected, 1e-3 * std::abs(expected));
    }
    EXPECT_EQ(designer_.design(picks_).report.fieldCost, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Shells, FieldOnASphere, kEitherShell, nameOfShell);

// ---- A plate with a sinusoidal valley in the field: the stronger, the nearer ----

double heightOfValley(double x) {
    return std::sin(x);
}

double distanceToValley(const Vec3& p) {
    constexpr int kPieces = 400;
    double least = std::numeric_limits<double>::infinity();
    const auto on = [](int i) {
        const double x = 2.0 * std::numbers::pi * i / kPieces;
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

    [[nodiscard]] Curve curveAt(double weight, int degree, const std::vector<double>& field) const {
        return goodCurve(
            designer_, picks_, {.degree = degree, .fieldWeight = weight}, {.field = field}
        );
    }

    // Farther from the picks than the way into the valley is long.
    [[nodiscard]] double meanDistance(const Curve& curve) const {
        return meanWhere(curve.polyline, distanceToValley, [this](const Vec3& p) {
            return std::ranges::all_of(picks_, [&](const Vec3& pick) {
                return (p - pick).norm() > 0.5;
            });
        });
    }

    TriangleMesh mesh_ = transformed(
        plate(63, 40, 2.0 * std::numbers::pi, 4.0),
        Eigen::Isometry3d(Eigen::Translation3d(0, -2, 0))
    );
    CurveDesigner designer_ = designerOn(mesh_);
    std::vector<double> field_ =
        sampled(mesh_, [](const Vec3& v) { return std::pow(v.y() - heightOfValley(v.x()), 2.0); });
    std::vector<Vec3> picks_ = {{0.15, 0, 0}, {std::numbers::pi, 0, 0}, {6.1, 0, 0}};
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

// A well of c beside the last pick, at the end of a strip.
Curve curveBesideAWell(const SolverOptions& options) {
    const TriangleMesh strip = plate(80, 8, 4.0, 0.4);
    const auto well = [](const Vec3& v) {
        return 4.0 * std::exp(-(v.x() - 2.4) * (v.x() - 2.4) / 0.36);
    };
    return CurveDesigner(strip).design(
        {{0.2, 0.1, 0.0}, {1.0, 0.3, 0.0}, {1.8, 0.15, 0.0}},
        options,
        {},
        {.field = sampled(strip, well)}
    );
}

double farthestAlongX(const Curve& curve) {
    double farthest = 0.0;
    for (const Vec3& point : curve.polyline.points) {
        farthest = std::max(farthest, point.x());
    }
    return farthest;
}

TEST(FieldAtEnds, IsWeakenedWhereItDrawsACurvePastItsPicks) {
    const SolverOptions usual{.fieldCost = FieldCost::ExpMinus};
    const Curve drawn = curveBesideAWell(usual);
    EXPECT_TRUE(drawn.report.usable);
    EXPECT_LT(drawn.report.fieldShare, 1.0);
    EXPECT_LT(farthestAlongX(drawn), 1.82);
    SolverOptions weak = usual;
    weak.fieldWeight = drawn.report.fieldShare * usual.fieldWeight;
    const Curve asWeak = curveBesideAWell(weak);
    EXPECT_EQ(asWeak.report.fieldShare, 1.0);
    expectSameBits(asWeak, drawn);
}

TEST(FieldAtEnds, IsNotWeakenedOfClosedCurves) {
    EXPECT_EQ(
        curveBesideAWell({.closed = true, .fieldCost = FieldCost::ExpMinus}).report.fieldShare, 1.0
    );
}

}  // namespace
}  // namespace bspline_curve
