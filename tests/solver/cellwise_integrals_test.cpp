// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/cellwise_integrals.h"

#include "problem_fixture.h"
#include "support/meshes.h"
#include "surface/surface_point.h"

#include <Eigen/Cholesky>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace bspline_curve {
namespace {

// The gradient is that of the integrand at the quadrature points; pieces that grow and shrink with
// the curve change the sum by the error of the quadrature as well.
constexpr double kQuadratureError = 1e-5;
// The barrier of what is avoided is steep all along a way that is one face wide.
constexpr double kSteepQuadratureError = 3e-4;
// Kinks at walls that the curve grazes are bounded in the Hessian, and pieces end at other places.
constexpr double kGrazingError = 0.02;

enum class Avoided { Nothing, Disc, AllButTheWay };

struct CellCase {
    std::string name;
    int degree;
    bool closed;
    FieldCost cost;
    bool simplified = false;
    Avoided avoided = Avoided::Nothing;
};

const std::vector<Vec3> kPicks = {{1, 0.1, 0}, {0, 1, 0.2}, {-0.45, 0.2, 0.87}};

test_support::ProblemFixture makeFixture(const CellCase& c, const SolverOptions& options) {
    const TriangleMesh fine = test_support::withNoise(test_support::icosphere(3), 0.01, 7);
    if (c.simplified) {
        const test_support::CoarseShellCase coarse{
            "NoisySphere", fine, test_support::icosphere(1), 0.3
        };
        return {coarse, kPicks, options};
    }
    return {fine, kPicks, options};
}

// A disc in the way, or all faces but those of the way itself, which then leads over edges that
// have both ends on what is avoided.
void avoid(test_support::ProblemFixture& fixture, Avoided avoided) {
    if (avoided == Avoided::Nothing) {
        return;
    }
    const Surface& surface = fixture.surface();
    std::vector<char> isIn(surface.faces().size(), avoided == Avoided::Disc ? 0 : 1);
    if (avoided == Avoided::Disc) {
        const Vec3 centre = Vec3(1, 1.1, 0.2).normalized();
        for (std::size_t f = 0; f < isIn.size(); ++f) {
            const Vec3 middle = surface.position({static_cast<int>(f), Vec3::Constant(1.0 / 3.0)});
            isIn[f] = (middle - centre).norm() < 0.2 ? 1 : 0;
        }
    } else {
        for (const InitialPath::Point& point : fixture.initialPath().points) {
            for (const int f : facesHolding(surface, point.point)) {
                isIn[f] = 0;
            }
        }
    }
    Region region;
    for (std::size_t f = 0; f < isIn.size(); ++f) {
        if (isIn[f] != 0) {
            region.push_back(static_cast<int>(f));
        }
    }
    fixture.avoid(region, 0.2);
}

// Changes a direction so that it leaves the curve at the picks in place. There the curve lies
// exactly in the middle surface, at the end of a span, and the quadrature has a kink.
void keepPicks(
    ControlPoints& direction, const SplineSpace& space, const std::vector<InterpolationRow>& rows
) {
    Eigen::MatrixXd constraints =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), space.controlCount());
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (int j = 0; j < space.basisCount(); ++j) {
            constraints(static_cast<Eigen::Index>(r), space.control(rows[r].span, j)) +=
                rows[r].values[j];
        }
    }
    const Eigen::MatrixXd violation = constraints * direction;
    direction -=
        constraints.transpose() * (constraints * constraints.transpose()).ldlt().solve(violation);
}

Eigen::VectorXd hessianTimes(
    const EnergyDerivatives& derivatives, const SplineSpace& space, const Eigen::VectorXd& x
) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(x.size());
    const int n = space.basisCount();
    for (int span = 0; span < space.spanCount(); ++span) {
        const SpanVector product =
            (dense(derivatives.hessian[span], n) + dense(derivatives.negativeKinks[span], n)) *
            unknownsOf(space, span, x);
        for (int j = 0; j < n; ++j) {
            result.segment<3>(3 * space.control(span, j)) += product.segment<3>(3 * j);
        }
    }
    return result;
}

class CellwiseDerivatives : public testing::TestWithParam<CellCase> {};

// Central differences of the energy along random directions of the control points against the
// gradient, and of the gradient against the Hessian. On a noisy sphere the curve crosses hundreds
// of walls.
TEST_P(CellwiseDerivatives, AgreeWithDifferences) {
    const CellCase& c = GetParam();
    SolverOptions options;
    options.degree = c.degree;
    options.closed = c.closed;
    options.tension = 0.3;
    options.fieldWeight = 2.0;
    options.fieldCost = c.cost;
    test_support::ProblemFixture fixture = makeFixture(c, options);
    std::vector<double> field;
    for (const Vec3& v : fixture.surface().vertices()) {
        field.push_back(std::sin(3.0 * v.x()) + v.y() * v.z());
    }
    fixture.setField(field);
    avoid(fixture, c.avoided);
    const SplineCurve curve = fitInitialPath(fixture.problem(), fixture.initialPath()).value();
    const std::vector<InterpolationRow> rows =
        interpolationRows(curve.space, fixture.problem().picks);
    CellwiseIntegrals energy(fixture.problem(), curve.space, rows, {});
    const std::optional<BendingDirections> directions =
        bendingDirectionsAlong(fixture.problem(), curve.space, curve.controls, {});
    ASSERT_TRUE(directions.has_value());
    energy.setDirections(*directions);
    EnergyWeights weights{20.0, 5.0, 1.0};
    weights.avoidance = 3.0;

    const double quadratureError =
        c.avoided == Avoided::AllButTheWay ? kSteepQuadratureError : kQuadratureError;
    EnergyDerivatives derivatives;
    ASSERT_TRUE(energy.evaluate(curve.controls, weights, derivatives).inside);
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 5; ++trial) {
        ControlPoints direction(curve.controls.rows(), 3);
        for (Eigen::Index i = 0; i < direction.size(); ++i) {
            direction.data()[i] = normal(random);
        }
        keepPicks(direction, curve.space, rows);
        const Eigen::Map<const Eigen::VectorXd> flat(direction.data(), direction.size());
        const double h = 1e-7;
        const ControlPoints up = curve.controls + h * direction;
        const ControlPoints down = curve.controls - h * direction;
        const double predicted = derivatives.gradient.dot(flat);
        const double difference =
            (energy.evaluate(up, weights).total - energy.evaluate(down, weights).total) / (2.0 * h);
        EXPECT_NEAR(predicted, difference, quadratureError * derivatives.gradient.norm())
            << "trial " << trial;

        EnergyDerivatives above;
        EnergyDerivatives below;
        ASSERT_TRUE(energy.evaluate(up, weights, above).inside);
        ASSERT_TRUE(energy.evaluate(down, weights, below).inside);
        const Eigen::VectorXd change = (above.gradient - below.gradient) / (2.0 * h);
        const Eigen::VectorXd product = hessianTimes(derivatives, curve.space, flat);
        EXPECT_LT((change - product).norm(), kGrazingError * product.norm()) << "trial " << trial;
    }
}

INSTANTIATE_TEST_SUITE_P(
    AllKinds,
    CellwiseDerivatives,
    testing::Values(
        CellCase{"OpenQuadratic", 2, false, FieldCost::Identity},
        CellCase{"OpenCubic", 3, false, FieldCost::Square},
        CellCase{"OpenQuartic", 4, false, FieldCost::ExpMinus},
        CellCase{"ClosedCubic", 3, true, FieldCost::Identity},
        CellCase{"ClosedQuadratic", 2, true, FieldCost::Square},
        CellCase{"ClosedQuartic", 4, true, FieldCost::Identity},
        CellCase{"SimplifiedQuadratic", 2, false, FieldCost::Identity, true},
        CellCase{"SimplifiedCubic", 3, false, FieldCost::Square, true},
        CellCase{"SimplifiedClosedCubic", 3, true, FieldCost::Identity, true},
        CellCase{"SimplifiedClosedQuartic", 4, true, FieldCost::ExpMinus, true},
        CellCase{"RoundADisc", 3, false, FieldCost::Identity, false, Avoided::Disc},
        CellCase{"RoundADiscClosed", 4, true, FieldCost::Identity, false, Avoided::Disc},
        CellCase{"SimplifiedRoundADisc", 2, false, FieldCost::Identity, true, Avoided::Disc},
        CellCase{"OneFaceWide", 3, false, FieldCost::Identity, false, Avoided::AllButTheWay},
        CellCase{"OneFaceWideClosed", 2, true, FieldCost::Identity, false, Avoided::AllButTheWay},
        CellCase{
            "SimplifiedOneFaceWide", 4, false, FieldCost::Identity, true, Avoided::AllButTheWay
        }
    )
);

}  // namespace
}  // namespace bspline_curve
