// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/sampled_scene.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

// ---- Values ----

// E_int (4) by many samples, with a share of the bending along z.
double internalEnergy(const Scene& scene, double shareAlongZ) {
    const double tension = scene.problem().options.tension;
    double sum = 0.0;
    constexpr int kSteps = 1000;
    for (int span = 0; span < scene.space().spanCount(); ++span) {
        const PolynomialCurve curve = scene.space().polynomial(scene.controls(), span);
        const double length = scene.space().spanLength(span);
        for (int i = 0; i < kSteps; ++i) {
            const double tau = (i + 0.5) / kSteps;
            const Vec3 bend = curve.secondDerivativeAt(tau) / (length * length);
            const double bending = bend.squaredNorm() - (1.0 - shareAlongZ) * bend.z() * bend.z();
            const double stretching = curve.derivativeAt(tau).squaredNorm() / (length * length);
            sum += length / kSteps * ((1.0 - tension) * bending + tension * stretching);
        }
    }
    return sum / (scene.problem().chordLength * scene.problem().chordLength);
}

Way waveOverThePlate() {
    return [](double t) {
        return Vec3(0.1 + 0.8 * t, 0.5 + 0.3 * std::sin(5.0 * t), 0.02 * std::sin(9.0 * t) - 0.01);
    };
}

TEST(SampledTerms, AreIntegralsOverAPlate) {
    for (const int degree : {2, 3, 4}) {
        for (const Bending bending : {Bending::Geodesic, Bending::Ambient}) {
            SCOPED_TRACE("degree " + std::to_string(degree));
            SolverOptions options;
            options.degree = degree;
            options.bending = bending;
            options.tension = 0.3;
            options.fieldWeight = 2.0;
            Scene scene(jitteredPlate(12, 12, 0.2, 3), options, waveOverThePlate(), 20);
            scene.setField([](const Vec3& p) { return p.x() - 2.0 * p.y(); });
            const SampledIntegrals energy = scene.energy();
            const FootedSpline spline = scene.footed(energy, scene.controls());
            const EnergyTerms terms = energy.terms(spline, spline.frames, kSceneWeights);
            const double share = bending == Bending::Geodesic ? options.normalBendingWeight : 1.0;
            const double internal = internalEnergy(scene, share);
            // Two Gauss points on three parts are not exact for quartics.
            EXPECT_NEAR(terms.internal, internal, (degree == 4 ? 1e-3 : 1e-5) * internal);
            double distance = 0.0;
            double external = 0.0;
            double highest = 0.0;
            constexpr int kSteps = 20000;
            for (int i = 0; i < kSteps; ++i) {
                const Vec3 p = scene.space().evaluate(scene.controls(), (i + 0.5) / kSteps);
                const Vec3 user = scene.extended().frame.toUser(p);
                distance += std::pow(p.z() / scene.edge(), 2.0) / kSteps;
                external += (user.x() - 2.0 * user.y()) / kSteps;
                highest = std::max(highest, std::abs(p.z()));
            }
            EXPECT_NEAR(terms.distance, distance, 1e-3 * distance);
            EXPECT_NEAR(terms.external, external, 1e-5);
            EXPECT_NEAR(energy.largestHeight(spline), highest, 0.02 * highest);
            EXPECT_DOUBLE_EQ(
                energy.total(terms, kSceneWeights),
                terms.internal + kAlpha * terms.distance + 2.0 * terms.external
            );
        }
    }
}

// The curve from its last pick to its first, with the same knots.
TEST(SampledTerms, DoNotDependOnTheDirectionOfTheCurve) {
    for (const bool closed : {false, true}) {
        SolverOptions options;
        options.closed = closed;
        options.tension = 0.2;
        options.fieldWeight = 50.0;
        Scene scene(noisySphere(), options, roundTheSphere(1.03, closed), 14);
        scene.setField([](const Vec3& p) { return std::sin(3.0 * p.x()) + p.y() * p.z(); });
        const SampledIntegrals energy = scene.energy();
        const FootedSpline spline = scene.footed(energy, scene.controls());

        std::vector<double> breaks;
        for (const double t : scene.space().breaks()) {
            breaks.insert(breaks.begin(), 1.0 - t);
        }
        const SplineSpace backSpace(options.degree, closed, breaks);
        const int count = backSpace.controlCount();
        ControlPoints backControls(count, 3);
        for (int j = 0; j < count; ++j) {
            const int same = count - 1 - j + (closed ? options.degree : 0);
            backControls.row(j) = scene.controls().row(same % count);
        }
        const SampledIntegrals backEnergy(scene.problem(), backSpace, scene.edge());
        const FootedSpline back = scene.footed(backEnergy, backControls);

        const EnergyTerms there = energy.terms(spline, spline.frames, kSceneWeights);
        const EnergyTerms here = backEnergy.terms(back, back.frames, kSceneWeights);
        EXPECT_NEAR(here.internal, there.internal, 1e-10 * there.internal);
        EXPECT_NEAR(here.distance, there.distance, 1e-10 * there.distance);
        EXPECT_NEAR(here.external, there.external, 1e-10);
        const int spans = backSpace.spanCount();
        for (int span = 0; span < spans; ++span) {
            const double gain = energy.refinementGain(spline, kSceneWeights, span);
            EXPECT_NEAR(
                backEnergy.refinementGain(back, kSceneWeights, spans - 1 - span),
                gain,
                1e-9 * there.internal
            ) << "span "
              << span;
        }
    }
}

// ---- What the model does not foresee ----

TEST(SampledModelErrors, AreTheEnergyBeyondNewtonsModel) {
    for (const bool closed : {false, true}) {
        SolverOptions options;
        options.closed = closed;
        const Scene scene(noisySphere(), options, roundTheSphere(1.03, closed), 14);
        const SampledIntegrals energy = scene.energy();
        const FootedSpline before = scene.footed(energy, scene.controls());
        const Derivatives model = derivativesOf(energy, before, 0.0);
        const double start = energy.total(model.terms, kSceneWeights);
        // From within a face to some faces away.
        for (const double size : {1e-4, 1e-2, 0.1}) {
            const ControlPoints change = size * randomChange(scene.space(), 3);
            const FootedSpline there = scene.moved(energy, before, change);
            const double foreseen =
                start + model.gradient.dot(flat(change)) +
                0.5 * flat(change).dot(product(model.hessian, scene.space(), flat(change)));
            const double total =
                energy.total(energy.terms(there, before.frames, kSceneWeights), kSceneWeights);
            double modelError = 0.0;
            for (const SampledIntegrals::ModelError& span :
                 energy.modelErrors(before, there, kSceneWeights)) {
                modelError += span.energy;
            }
            EXPECT_NEAR(modelError, total - foreseen, 1e-9 * (total + foreseen)) << "size " << size;
        }
    }
}

TEST(SampledDamping, HoldsTheSquaredWaysOfSpans) {
    const Scene scene(noisySphere(), {}, roundTheSphere(1.03, false), 14);
    const SampledIntegrals energy = scene.energy();
    const FootedSpline before = scene.footed(energy, scene.controls());
    const ControlPoints change = 0.01 * randomChange(scene.space(), 5);
    const std::vector<SampledIntegrals::ModelError> modelErrors =
        energy.modelErrors(before, scene.moved(energy, before, change), kSceneWeights);
    std::vector<double> damping(modelErrors.size(), 0.0);
    double damped = 0.0;
    for (std::size_t span = 0; span < damping.size(); span += 3) {
        damping[span] = 1.0 + 0.5 * static_cast<double>(span);
        damped += damping[span] * modelErrors[span].squaredWay;
    }
    const Derivatives plain = derivativesOf(energy, before, 1.0);
    std::vector<SpanBlocks> hessian = plain.hessian;
    energy.addDamping(damping, hessian);
    const Eigen::VectorXd added = product(hessian, scene.space(), flat(change)) -
                                  product(plain.hessian, scene.space(), flat(change));
    EXPECT_NEAR(0.5 * flat(change).dot(added), damped, 1e-9 * damped);
    // By many samples; two Gauss points on both halves of a span are not exact for powers of six.
    double way = 0.0;
    constexpr int kSteps = 1000;
    const PolynomialCurve moved = scene.space().polynomial(change, 4);
    for (int i = 0; i < kSteps; ++i) {
        way += scene.space().spanLength(4) / kSteps * moved.at((i + 0.5) / kSteps).squaredNorm();
    }
    EXPECT_NEAR(modelErrors[4].squaredWay, way, 0.01 * way);
}

}  // namespace
}  // namespace bspline_curve
