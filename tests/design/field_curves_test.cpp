// SPDX-License-Identifier: GPL-3.0-or-later
// What of a field counts, and what does not.
#include "bspline_curve/field.h"
#include "curve_checks.h"
#include "design/designer_surface.h"
#include "either_shell.h"
#include "field_checks.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

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
    std::vector<Vec3> picks_ = {mesh_.vertices[5], mesh_.vertices[100], mesh_.vertices[400]};
    double epsilon_ = 0.1 * surfaceOf(designer_).averageEdgeLength();
};

std::string figures(const Curve& curve, const Curve& reference) {
    return std::to_string(curve.report.knotsLast) + " instead of " +
           std::to_string(reference.report.knotsLast) + " knots, " + name(curve.report.status);
}

void expectSameBits(const Curve& curve, const Curve& reference) {
    EXPECT_EQ(curve.spline.knots, reference.spline.knots);
    EXPECT_TRUE(curve.spline.controlPoints == reference.spline.controlPoints)
        << "gap " << largestGap(curve.spline, reference.spline);
    EXPECT_TRUE(curve.polyline.points == reference.polyline.points);
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
            SolverOptions options;
            options.fieldCost = kind;
            const Curve curve = curveWith([&](const Vec3&) { return constant; }, options);
            expectSameBits(curve, reference);
            EXPECT_EQ(curve.report.fieldCost, cost(constant));
            EXPECT_TRUE(curve.report.fieldAtRest);
        }
    }
}

TEST_P(FieldOnASphere, FieldsWithoutWeightChangeNothing) {
    SolverOptions options;
    options.fieldWeight = 0.0;
    const Curve with = curveWith([](const Vec3& v) { return v.z(); }, options);
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
        SolverOptions options;
        options.fieldWeight = scale;
        const Curve light = curveWith([](const Vec3& v) { return v.z(); }, options);
        EXPECT_LT(largestGap(light.spline, reference.spline), 1e-9) << figures(light, reference);
    }
}

// Only differences of a field matter where c(x) = x; also below zero.
TEST_P(FieldOnASphere, ConstantsAddedToTheFieldChangeNothing) {
    const auto height = [](const Vec3& v) { return v.z(); };
    const Curve reference = curveWith(height);
    for (const double constant : {1.0, 1000.0, -1000.0}) {
        const Curve curve = curveWith([&](const Vec3& v) { return height(v) + constant; });
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
        SolverOptions options;
        options.fieldCost = kind;
        options.fieldWeight = 10.0;
        const Curve curve = designer_.design(picks_, options, {.samples = 4000}, {.field = field});
        const double expected = meanCostOver(surfaceOf(designer_), curve.polyline, field, cost);
        // The shell of the curve's last round, and the thinner one of its polyline, project
        // differently: by 1e-4 in a simplified shell.
        EXPECT_NEAR(curve.report.fieldCost, expected, 1e-3 * std::abs(expected));
    }
    EXPECT_EQ(designer_.design(picks_).report.fieldCost, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Shells, FieldOnASphere, kEitherShell, nameOfShell);

}  // namespace
}  // namespace bspline_curve
