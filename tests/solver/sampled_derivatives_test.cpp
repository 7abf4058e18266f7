// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/sampled_scene.h"
#include "support/meshes.h"

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

// The gradient with the bending directions of another spline.
Eigen::VectorXd frozenGradient(
    const SampledIntegrals& energy, FootedSpline spline, const FootedSpline& frozen
) {
    for (std::size_t i = 0; i < spline.frames.size(); ++i) {
        spline.frames[i].direction = frozen.frames[i].direction;
    }
    return derivativesOf(energy, spline, 1.0).gradient;
}

struct DerivativeCase {
    std::string name;
    int degree;
    bool closed;
    double tension;
    FieldCost cost;
    bool overBoundary = false;
    bool isFaired = false;
    bool isAvoiding = false;
};

class SampledDerivatives : public testing::TestWithParam<DerivativeCase> {
protected:
    static std::unique_ptr<Scene> makeScene(const DerivativeCase& c) {
        SolverOptions options;
        options.degree = c.degree;
        options.closed = c.closed;
        options.tension = c.tension;
        options.fieldWeight = 50.0;
        options.fieldCost = c.cost;
        // Out over the boundary of a plate, less far than its ghosts reach.
        const Way overBoundary = [](double t) {
            const double out = 0.98 + 0.05 * t * (1.0 - t) * 4.0;
            return Vec3(0.2 + 0.6 * t, out, 0.01 * std::sin(7.0 * t));
        };
        auto scene = std::make_unique<Scene>(
            c.overBoundary ? jitteredPlate(10, 10, 0.2, 5) : noisySphere(),
            options,
            c.overBoundary ? overBoundary : roundTheSphere(1.03, c.closed),
            10
        );
        scene->setField([](const Vec3& p) {
            return std::sin(3.0 * p.x()) + p.y() * p.z() + 0.3 * p.y();
        });
        if (c.isAvoiding) {
            // All but a band that the curve runs along.
            scene->avoid([](const Vec3& p) { return std::abs(p.z()) > 0.5; }, 0.8);
        }
        if (c.isFaired) {
            scene->setFairedShape(roundTheSphere(1.0, c.closed));
        }
        return scene;
    }
};

TEST_P(SampledDerivatives, AgreeWithDifferencesForFrozenDirections) {
    const DerivativeCase& c = GetParam();
    const std::unique_ptr<Scene> owner = makeScene(c);
    const Scene& scene = *owner;
    const SampledIntegrals energy = scene.energy();
    const FootedSpline spline = scene.footed(energy, scene.controls());
    const auto isBeyond = [&](const FootPoint& foot) {
        return foot.face >= scene.extended().surfaceFaceCount;
    };
    EXPECT_EQ(std::ranges::any_of(spline.feet, isBeyond), c.overBoundary);
    const Derivatives derivatives = derivativesOf(energy, spline, 1.0);
    const Eigen::VectorXd& gradient = derivatives.gradient;
    const EnergyTerms terms = energy.terms(spline, spline.frames, kSceneWeights);
    EXPECT_EQ(derivatives.terms.internal, terms.internal);
    EXPECT_EQ(derivatives.terms.distance, terms.distance);
    EXPECT_EQ(derivatives.terms.external, terms.external);
    EXPECT_EQ(derivatives.terms.avoidance, terms.avoidance);
    EXPECT_EQ(terms.avoidance > 0.0, c.isAvoiding);
    EXPECT_TRUE(std::isfinite(terms.internal));
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ControlPoints change = randomChange(scene.space(), seed);
        constexpr double kStep = 1e-7;
        const FootedSpline up = scene.moved(energy, spline, kStep * change);
        const FootedSpline down = scene.moved(energy, spline, -kStep * change);
        const double difference =
            (energy.total(energy.terms(up, spline.frames, kSceneWeights), kSceneWeights) -
             energy.total(energy.terms(down, spline.frames, kSceneWeights), kSceneWeights)) /
            (2.0 * kStep);
        EXPECT_NEAR(gradient.dot(flat(change)), difference, 1e-5 * gradient.norm());
    }
}

TEST_P(SampledDerivatives, AreOfTheSameFeetWhetherTheseArePredictedOrNot) {
    const std::unique_ptr<Scene> owner = makeScene(GetParam());
    const Scene& scene = *owner;
    const SampledIntegrals energy = scene.energy();
    const FootedSpline spline = scene.footed(energy, scene.controls());
    FootedSpline unknown = spline;
    unknown.positions.clear();
    const ControlPoints change = 1e-3 * randomChange(scene.space(), 3);
    const FootedSpline predicted = scene.moved(energy, spline, change);
    const FootedSpline sought = scene.moved(energy, unknown, change);
    for (std::size_t i = 0; i < sought.feet.size(); ++i) {
        SCOPED_TRACE("sample " + std::to_string(i));
        EXPECT_LT((predicted.positions[i] - sought.positions[i]).norm(), 1e-12);
        EXPECT_NEAR(predicted.feet[i].height, sought.feet[i].height, 1e-4 * scene.edge());
        if (predicted.feet[i].face == sought.feet[i].face) {
            EXPECT_NEAR(predicted.feet[i].height, sought.feet[i].height, 1e-9 * scene.edge());
            EXPECT_NEAR(predicted.feet[i].u, sought.feet[i].u, 1e-9);
            EXPECT_NEAR(predicted.feet[i].v, sought.feet[i].v, 1e-9);
        }
    }
}

TEST_P(SampledDerivatives, HaveAPositiveHessianWithoutTurning) {
    const std::unique_ptr<Scene> owner = makeScene(GetParam());
    const Scene& scene = *owner;
    const SampledIntegrals energy = scene.energy();
    const FootedSpline spline = scene.footed(energy, scene.controls());
    const Derivatives derivatives = derivativesOf(energy, spline, 0.0);
    for (const SpanBlocks& blocks : derivatives.hessian) {
        const Eigen::MatrixXd matrix = denseOf(blocks, scene.space().basisCount());
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver{matrix};
        const Eigen::VectorXd& values = solver.eigenvalues();
        EXPECT_GE(values.minCoeff(), -1e-12 * values.maxCoeff());
    }
    // The gradient does not depend on it.
    EXPECT_EQ(derivatives.gradient, derivativesOf(energy, spline, 1.0).gradient);
}

INSTANTIATE_TEST_SUITE_P(
    AllKinds,
    SampledDerivatives,
    testing::Values(
        DerivativeCase{"OpenQuadratic", 2, false, 0.0, FieldCost::Identity},
        DerivativeCase{"OpenCubic", 3, false, 0.0, FieldCost::Square},
        DerivativeCase{"OpenQuartic", 4, false, 0.3, FieldCost::ExpMinus},
        DerivativeCase{"ClosedQuadratic", 2, true, 0.3, FieldCost::Square},
        DerivativeCase{"ClosedCubic", 3, true, 0.3, FieldCost::ExpMinus},
        DerivativeCase{"ClosedQuartic", 4, true, 0.0, FieldCost::Identity},
        DerivativeCase{"OverABoundary", 3, false, 0.0, FieldCost::Identity, true},
        DerivativeCase{"OpenFaired", 3, false, 0.3, FieldCost::Identity, false, true},
        DerivativeCase{"ClosedFaired", 4, true, 0.0, FieldCost::Square, false, true},
        DerivativeCase{"BetweenObstacles", 3, false, 0.0, FieldCost::Identity, false, false, true},
        DerivativeCase{"QuadraticOverABoundary", 2, false, 0.3, FieldCost::ExpMinus, true}
    ),
    [](const auto& testInfo) { return testInfo.param.name; }
);

// On a fine sphere, over steps of several edges: what samples do not see at once, the kinks that
// they pass, the turning of the directions foretells.
class SampledDerivativesOverASphere : public testing::TestWithParam<double> {
protected:
    Scene scene_{icosphere(6), SolverOptions(), roundTheSphere(GetParam(), false), 10};
    SampledIntegrals energy_ = scene_.energy();
    FootedSpline spline_ = scene_.footed(energy_, scene_.controls());
};

TEST_P(SampledDerivativesOverASphere, HasTheHessianOfItsGradientOverManyEdges) {
    const std::vector<SpanBlocks> hessian = derivativesOf(energy_, spline_, 1.0).hessian;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        ControlPoints change = randomChange(scene_.space(), seed);
        change *= 3.0 * scene_.edge() / change.rowwise().norm().maxCoeff();
        const FootedSpline up = scene_.moved(energy_, spline_, change);
        const FootedSpline down = scene_.moved(energy_, spline_, -change);
        const Eigen::VectorXd difference =
            0.5 * (frozenGradient(energy_, up, spline_) - frozenGradient(energy_, down, spline_));
        const Eigen::VectorXd predicted = product(hessian, scene_.space(), flat(change));
        EXPECT_LT((difference - predicted).norm(), 0.03 * predicted.norm());
    }
}

// The second derivative of |P| is (1 - n n^T) / |P|.
TEST_P(SampledDerivativesOverASphere, TurnsAsTheSphereDoes) {
    const std::vector<SpanBlocks> with = derivativesOf(energy_, spline_, 1.0).hessian;
    const std::vector<SpanBlocks> without = derivativesOf(energy_, spline_, 0.0).hessian;
    const double radius = 1.0 / scene_.extended().frame.scale;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ControlPoints change = randomChange(scene_.space(), seed);
        const double turning = flat(change).dot(product(with, scene_.space(), flat(change))) -
                               flat(change).dot(product(without, scene_.space(), flat(change)));
        double expected = 0.0;
        for (int i = 0; i < energy_.sampleCount(); ++i) {
            const int span = i / energy_.samplesPerSpan();
            const Vec3 p = scene_.space().evaluate(scene_.controls(), energy_.parameter(i));
            const Vec3 moves = scene_.space().evaluate(change, energy_.parameter(i));
            const Vec3 along = moves - p.normalized().dot(moves) * p.normalized();
            expected += scene_.space().spanLength(span) / energy_.samplesPerSpan() * 2.0 * kAlpha /
                        (scene_.edge() * scene_.edge()) * (p.norm() - radius) *
                        along.squaredNorm() / p.norm();
        }
        EXPECT_NEAR(turning, expected, 0.05 * std::abs(expected));
    }
}

// Above, and below.
INSTANTIATE_TEST_SUITE_P(Radii, SampledDerivativesOverASphere, testing::Values(1.15, 0.9));

}  // namespace
}  // namespace bspline_curve
