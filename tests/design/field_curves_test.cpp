// SPDX-License-Identifier: GPL-3.0-or-later
// What a field does to a curve.
#include "curve_checks.h"
#include "either_shell.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

namespace bspline_curve {
namespace {

using namespace test_support;

std::vector<double> sampled(
    const TriangleMesh& mesh, const std::function<double(const Vec3&)>& field
) {
    std::vector<double> values;
    for (const Vec3& v : mesh.vertices) {
        values.push_back(field(v));
    }
    return values;
}

// Mean over the length of the polyline of a field given at the vertices.
double meanAlong(
    const Surface& surface, const SurfacePolyline& line, const std::vector<double>& field
) {
    const auto valueAt = [&](std::size_t i) {
        const SurfacePoint& point = line.surfacePoints[i];
        const Triangle& face = surface.faces()[static_cast<std::size_t>(point.face)];
        double value = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            value += point.barycentric[static_cast<Eigen::Index>(k)] *
                     field[static_cast<std::size_t>(face[k])];
        }
        return value;
    };
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        sum += 0.5 * (valueAt(i) + valueAt(i + 1)) * (line.points[i + 1] - line.points[i]).norm();
    }
    return sum / length(line);
}

// A plate [0, 2 pi] x [-2, 2] with a valley along y = a sin x.
class Valley : public EitherShell {
protected:
    static TriangleMesh makeMesh() {
        TriangleMesh mesh = plate(60, 40, 2.0 * std::numbers::pi, 4.0);
        for (Vec3& v : mesh.vertices) {
            v.y() -= 2.0;
        }
        return mesh;
    }

    TriangleMesh mesh_ = makeMesh();
    CurveDesigner designer_ = designerOn(mesh_);
    std::vector<double> field_ =
        sampled(mesh_, [](const Vec3& v) { return std::pow(v.y() - std::sin(v.x()), 2.0); });
    std::vector<Vec3> picks_ = {{0.15, 0, 0}, {std::numbers::pi, 0, 0}, {6.1, 0, 0}};
};

TEST_P(Valley, GrowingWeightPullsTheCurveIn) {
    double before = 1e300;
    for (const double mu : {0.0, 0.1, 1.0, 10.0, 100.0, 1000.0}) {
        SolverOptions options;
        options.fieldWeight = mu;
        const Curve curve = designer_.design(picks_, options, {}, {.field = field_});
        EXPECT_TRUE(curve.report.usable) << "mu = " << mu;
        expectStrict(designer_.surface(), curve.polyline);
        const double mean = meanAlong(designer_.surface(), curve.polyline, field_);
        EXPECT_LT(mean, before) << "mu = " << mu;
        before = mean;
    }
    // In the valley: much nearer than the straight line, whose mean is about 1/2.
    EXPECT_LT(before, 0.02);
}

TEST_P(Valley, WithoutWeightTheFieldChangesNothing) {
    SolverOptions options;
    options.fieldWeight = 0.0;
    const Curve with = designer_.design(picks_, options, {}, {.field = field_});
    const Curve without = designer_.design(picks_, options);
    EXPECT_LT(largestGap(with.spline, without.spline), 1e-9);
}

// Only differences of a field matter where c(x) = x; also below zero.
class FieldOnASphere : public EitherShell {
protected:
    [[nodiscard]] Curve curveWith(const std::function<double(const Vec3&)>& field) const {
        return designer_.design(picks_, {}, {}, {.field = sampled(mesh_, field)});
    }

    TriangleMesh mesh_ = withNoise(icosphere(3), 0.01, 23);
    CurveDesigner designer_ = designerOn(mesh_);
    std::vector<Vec3> picks_ = {mesh_.vertices[5], mesh_.vertices[100], mesh_.vertices[400]};
};

TEST_P(FieldOnASphere, ConstantFieldsChangeNothing) {
    const Curve reference = designer_.design(picks_);
    for (const double constant : {0.0, 1.0, 1000.0, -1000.0}) {
        const Curve curve = curveWith([&](const Vec3&) { return constant; });
        EXPECT_LT(largestGap(curve.spline, reference.spline), 1e-9)
            << "constant " << constant << ", " << curve.report.knotsLast << " instead of "
            << reference.report.knotsLast << " knots, " << name(curve.report.status);
    }
}

TEST_P(FieldOnASphere, ConstantsAddedToTheFieldChangeNothing) {
    const auto height = [](const Vec3& v) { return v.z(); };
    const Curve reference = curveWith(height);
    const double epsilon = 0.1 * designer_.surface().averageEdgeLength();
    for (const double constant : {1.0, 1000.0, -1000.0}) {
        const Curve curve = curveWith([&](const Vec3& v) { return height(v) + constant; });
        EXPECT_TRUE(curve.report.usable);
        EXPECT_LT(largestGap(curve.spline, reference.spline), epsilon)
            << "constant " << constant << ", " << curve.report.knotsLast << " instead of "
            << reference.report.knotsLast << " knots, " << name(curve.report.status);
    }
}

INSTANTIATE_TEST_SUITE_P(Shells, Valley, kEitherShell, nameOfShell);
INSTANTIATE_TEST_SUITE_P(Shells, FieldOnASphere, kEitherShell, nameOfShell);

}  // namespace
}  // namespace bspline_curve
