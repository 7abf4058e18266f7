// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/sampled_integrals.h"

#include "problem_fixture.h"
#include "spline/spline_system.h"
#include "support/meshes.h"
#include "surface/triangle_tree.h"

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr double kAlpha = 20.0;

using Way = std::function<Vec3(double)>;

// A space with uneven spans.
SplineSpace unevenSpace(int degree, bool closed, int spans) {
    std::vector<double> breaks;
    for (int i = 0; i <= spans; ++i) {
        const double t = static_cast<double>(i) / spans;
        breaks.push_back(t + 0.03 * std::sin(2.0 * std::numbers::pi * t));
    }
    breaks.back() = 1.0;
    return {degree, closed, std::move(breaks)};
}

// A problem with an energy and a spline near a way, in the user's unit. No shell is needed.
class Scene {
public:
    Scene(const TriangleMesh& mesh, const SolverOptions& options, const Way& way, int spans)
        : surface_(mesh),
          extended_(extendSurface(surface_, 3)),
          tree_(extended_.vertices, extended_.faces),
          finder_(extended_),
          edge_(surface_.averageEdgeLength() / extended_.frame.scale),
          space_(unevenSpace(options.degree, options.closed, spans)) {
        problem_.extended = &extended_;
        problem_.options = options;
        problem_.averageEdgeLength = edge_;
        problem_.chordLength = 0.7;
        controls_.resize(space_.controlCount(), 3);
        const std::vector<double> knots = space_.knotVector();
        for (int j = 0; j < space_.controlCount(); ++j) {
            double t = 0.0;
            for (int k = 1; k <= options.degree; ++k) {
                t += knots[j + k] / options.degree;
            }
            controls_.row(j) = extended_.frame.toUnit(way(t)).transpose();
        }
    }

    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    void setField(const std::function<double(const Vec3&)>& value) {
        field_.clear();
        for (const Vec3& v : extended_.vertices) {
            field_.push_back(value(extended_.frame.toUser(v)));
        }
        problem_.field = field_;
        problem_.fieldCosts = summaryOf(vertexCostsOf(problem_.field, problem_.options.fieldCost));
    }

    [[nodiscard]] SampledIntegrals energy() const { return {problem_, space_, edge_}; }

    [[nodiscard]] const SplineSpace& space() const { return space_; }

    [[nodiscard]] const CurveProblem& problem() const { return problem_; }

    [[nodiscard]] const ExtendedSurface& extended() const { return extended_; }

    [[nodiscard]] const ControlPoints& controls() const { return controls_; }

    [[nodiscard]] double edge() const { return edge_; }

    // A spline with feet that are sought from the nearest points of the surface.
    [[nodiscard]] FootedSpline footed(
        const SampledIntegrals& energy, ControlPoints controls
    ) const {
        FootedSpline spline{
            std::move(controls),
            std::vector<FootPoint>(energy.sampleCount()),
            std::vector<FootFrame>(energy.sampleCount()),
            {},
            {}
        };
        for (int i = 0; i < energy.sampleCount(); ++i) {
            const SurfacePoint nearest =
                tree_.closestPoint(space_.evaluate(spline.controls, energy.parameter(i))).point;
            spline.feet[i] = {nearest.face, nearest.barycentric[1], nearest.barycentric[2], 0.0};
        }
        energy.follow(finder_, spline);
        return spline;
    }

    // The spline moved, with its feet sought from where they are.
    [[nodiscard]] FootedSpline moved(
        const SampledIntegrals& energy, const FootedSpline& from, const ControlPoints& change
    ) const {
        FootedSpline spline = from;
        spline.controls += change;
        energy.follow(finder_, spline);
        return spline;
    }

private:
    Surface surface_;
    ExtendedSurface extended_;
    TriangleTree tree_;
    FibreProjector finder_;
    double edge_;
    SplineSpace space_;
    std::vector<double> field_;
    CurveProblem problem_;
    ControlPoints controls_;
};

// An open or closed way round the unit sphere, at some radius.
Way roundTheSphere(double radius, bool closed) {
    return [radius, closed](double t) {
        const double angle = (closed ? 2.0 : 1.2) * std::numbers::pi * t;
        return Vec3(
            radius *
            Vec3(std::cos(angle), std::sin(angle), 0.4 * std::sin(2.0 * angle)).normalized()
        );
    };
}

TriangleMesh noisySphere() {
    return withNoise(icosphere(3), 0.01, 7);
}

ControlPoints randomChange(const SplineSpace& space, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    ControlPoints change(space.controlCount(), 3);
    for (Eigen::Index i = 0; i < change.size(); ++i) {
        change.data()[i] = normal(random);
    }
    return change;
}

Eigen::Map<const Eigen::VectorXd> flat(const ControlPoints& controls) {
    return {controls.data(), controls.size()};
}

SpanMatrix denseOf(const SpanBlocks& blocks, int basisCount) {
    SpanMatrix matrix(3 * basisCount, 3 * basisCount);
    std::size_t block = 0;
    for (int j = 0; j < basisCount; ++j) {
        for (int k = 0; k <= j; ++k, ++block) {
            const auto [xx, xy, xz, yy, yz, zz] = blocks[block];
            Eigen::Matrix3d m;
            m << xx, xy, xz, xy, yy, yz, xz, yz, zz;
            matrix.block<3, 3>(3 * j, 3 * k) = m;
            matrix.block<3, 3>(3 * k, 3 * j) = m;
        }
    }
    return matrix;
}

Eigen::VectorXd product(
    const std::vector<SpanBlocks>& hessian, const SplineSpace& space, const Eigen::VectorXd& x
) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(x.size());
    const int size = 3 * space.basisCount();
    for (int span = 0; span < space.spanCount(); ++span) {
        const auto unknown = [&](int i) { return 3 * space.control(span, i / 3) + i % 3; };
        const SpanMatrix matrix = denseOf(hessian[span], space.basisCount());
        for (int i = 0; i < size; ++i) {
            for (int j = 0; j < size; ++j) {
                result[unknown(i)] += matrix(i, j) * x[unknown(j)];
            }
        }
    }
    return result;
}

struct Derivatives {
    EnergyTerms terms;
    Eigen::VectorXd gradient;
    std::vector<SpanBlocks> hessian;
};

Derivatives derivativesOf(
    const SampledIntegrals& energy, const FootedSpline& spline, double turning
) {
    Derivatives derivatives;
    derivatives.terms =
        energy.differentiate(spline, kAlpha, turning, derivatives.gradient, derivatives.hessian);
    return derivatives;
}

// The gradient with the bending directions of another spline.
Eigen::VectorXd frozenGradient(
    const SampledIntegrals& energy, FootedSpline spline, const FootedSpline& frozen
) {
    for (std::size_t i = 0; i < spline.frames.size(); ++i) {
        spline.frames[i].direction = frozen.frames[i].direction;
    }
    return derivativesOf(energy, spline, 1.0).gradient;
}

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

TEST(FootEnergyTerms, AreIntegralsOverAPlate) {
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
            const EnergyTerms terms = energy.terms(spline, spline.frames);
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
                energy.total(terms, kAlpha),
                terms.internal + kAlpha * terms.distance + 2.0 * terms.external
            );
        }
    }
}

// The curve from its last pick to its first, with the same knots.
TEST(FootEnergyTerms, DoNotDependOnTheDirectionOfTheCurve) {
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

        const EnergyTerms there = energy.terms(spline, spline.frames);
        const EnergyTerms here = backEnergy.terms(back, back.frames);
        EXPECT_NEAR(here.internal, there.internal, 1e-10 * there.internal);
        EXPECT_NEAR(here.distance, there.distance, 1e-10 * there.distance);
        EXPECT_NEAR(here.external, there.external, 1e-10);
        const int spans = backSpace.spanCount();
        for (int span = 0; span < spans; ++span) {
            const double gain = energy.refinementGain(spline, kAlpha, span);
            EXPECT_NEAR(
                backEnergy.refinementGain(back, kAlpha, spans - 1 - span),
                gain,
                1e-9 * there.internal
            ) << "span "
              << span;
        }
    }
}

// ---- What the model does not foresee ----

TEST(FootEnergySurprises, AreTheEnergyBeyondNewtonsModel) {
    for (const bool closed : {false, true}) {
        SolverOptions options;
        options.closed = closed;
        const Scene scene(noisySphere(), options, roundTheSphere(1.03, closed), 14);
        const SampledIntegrals energy = scene.energy();
        const FootedSpline before = scene.footed(energy, scene.controls());
        const Derivatives model = derivativesOf(energy, before, 0.0);
        const double start = energy.total(model.terms, kAlpha);
        // From within a face to some faces away.
        for (const double size : {1e-4, 1e-2, 0.1}) {
            const ControlPoints change = size * randomChange(scene.space(), 3);
            const FootedSpline there = scene.moved(energy, before, change);
            const double foreseen =
                start + model.gradient.dot(flat(change)) +
                0.5 * flat(change).dot(product(model.hessian, scene.space(), flat(change)));
            const double total = energy.total(energy.terms(there, before.frames), kAlpha);
            double modelError = 0.0;
            for (const SampledIntegrals::ModelError& span :
                 energy.modelErrors(before, there, kAlpha)) {
                modelError += span.energy;
            }
            EXPECT_NEAR(modelError, total - foreseen, 1e-9 * (total + foreseen)) << "size " << size;
        }
    }
}

TEST(FootEnergyDamping, HoldsTheSquaredWaysOfSpans) {
    const Scene scene(noisySphere(), {}, roundTheSphere(1.03, false), 14);
    const SampledIntegrals energy = scene.energy();
    const FootedSpline before = scene.footed(energy, scene.controls());
    const ControlPoints change = 0.01 * randomChange(scene.space(), 5);
    const std::vector<SampledIntegrals::ModelError> modelErrors =
        energy.modelErrors(before, scene.moved(energy, before, change), kAlpha);
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

// ---- Derivatives ----

struct Case {
    std::string name;
    int degree;
    bool closed;
    double tension;
    FieldCost cost;
    bool overBoundary = false;
};

class SampledDerivatives : public testing::TestWithParam<Case> {
protected:
    static std::unique_ptr<Scene> makeScene(const Case& c) {
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
        return scene;
    }
};

TEST_P(SampledDerivatives, AgreeWithDifferencesForFrozenDirections) {
    const Case& c = GetParam();
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
    const EnergyTerms terms = energy.terms(spline, spline.frames);
    EXPECT_EQ(derivatives.terms.internal, terms.internal);
    EXPECT_EQ(derivatives.terms.distance, terms.distance);
    EXPECT_EQ(derivatives.terms.external, terms.external);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ControlPoints change = randomChange(scene.space(), seed);
        constexpr double kStep = 1e-7;
        const FootedSpline up = scene.moved(energy, spline, kStep * change);
        const FootedSpline down = scene.moved(energy, spline, -kStep * change);
        const double difference = (energy.total(energy.terms(up, spline.frames), kAlpha) -
                                   energy.total(energy.terms(down, spline.frames), kAlpha)) /
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
        Case{"OpenQuadratic", 2, false, 0.0, FieldCost::Identity},
        Case{"OpenCubic", 3, false, 0.0, FieldCost::Square},
        Case{"OpenQuartic", 4, false, 0.3, FieldCost::ExpMinus},
        Case{"ClosedQuadratic", 2, true, 0.3, FieldCost::Square},
        Case{"ClosedCubic", 3, true, 0.3, FieldCost::ExpMinus},
        Case{"ClosedQuartic", 4, true, 0.0, FieldCost::Identity},
        Case{"OverABoundary", 3, false, 0.0, FieldCost::Identity, true},
        Case{"QuadraticOverABoundary", 2, false, 0.3, FieldCost::ExpMinus, true}
    ),
    [](const auto& testInfo) { return testInfo.param.name; }
);

// On a fine sphere, over steps of several edges: what samples do not see at once, the kinks that
// they pass, the turning of the directions foretells.
class FootEnergyOverASphere : public testing::TestWithParam<double> {
protected:
    Scene scene_{icosphere(6), SolverOptions(), roundTheSphere(GetParam(), false), 10};
    SampledIntegrals energy_ = scene_.energy();
    FootedSpline spline_ = scene_.footed(energy_, scene_.controls());
};

TEST_P(FootEnergyOverASphere, HasTheHessianOfItsGradientOverManyEdges) {
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
TEST_P(FootEnergyOverASphere, TurnsAsTheSphereDoes) {
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
INSTANTIATE_TEST_SUITE_P(Radii, FootEnergyOverASphere, testing::Values(1.15, 0.9));

// ---- Bulges ----

TEST(GainOfBulge, IsNothingOnAPlane) {
    for (const int degree : {2, 3}) {
        SolverOptions options;
        options.degree = degree;
        const Scene scene(
            jitteredPlate(12, 12, 0.2, 3),
            options,
            [](double t) { return Vec3(0.1 + 0.8 * t, 0.5 + 0.3 * std::sin(5.0 * t), 0.0); },
            9
        );
        const SampledIntegrals energy = scene.energy();
        const FootedSpline spline = scene.footed(energy, scene.controls());
        const double total = energy.total(energy.terms(spline, spline.frames), kAlpha);
        for (int span = 0; span < scene.space().spanCount(); ++span) {
            EXPECT_LT(energy.refinementGain(spline, kAlpha, span), 1e-12 * total);
        }
    }
}

// The least energy with a knot vector, and what bulges of all spans promise there.
struct Relaxed {
    double total = 0.0, gain = 0.0;
    ControlPoints controls;
};

Relaxed relaxed(
    const ProblemFixture& fixture, const SplineSpace& space, ControlPoints controls, double alpha
) {
    const CurveProblem& problem = fixture.problem();
    const FibreProjector finder(*problem.extended);
    const SampledIntegrals energy(problem, space, problem.averageEdgeLength);
    const TriangleTree tree(problem.extended->vertices, problem.extended->faces);
    SplineSystem system(space, interpolationRows(space, problem.picks));
    FootedSpline spline{
        std::move(controls),
        std::vector<FootPoint>(energy.sampleCount()),
        std::vector<FootFrame>(energy.sampleCount()),
        {},
        {}
    };
    for (int i = 0; i < energy.sampleCount(); ++i) {
        const SurfacePoint nearest =
            tree.closestPoint(space.evaluate(spline.controls, energy.parameter(i))).point;
        spline.feet[i] = {nearest.face, nearest.barycentric[1], nearest.barycentric[2], 0.0};
    }
    Eigen::VectorXd gradient;
    std::vector<SpanBlocks> hessian;
    double decrement = 1.0;
    constexpr double kPickWeight = 1e6;
    for (int step = 0; step < 30 && decrement > 1e-7; ++step) {
        energy.follow(finder, spline);
        energy.differentiate(spline, alpha, 1.0, gradient, hessian);
        EXPECT_TRUE(system.factorise(hessian, kPickWeight));
        const Eigen::VectorXd move = system.constrainedStep(
            gradient, system.constraints().residual(spline.controls), kPickWeight
        );
        decrement = -0.5 * gradient.dot(move);
        Eigen::Map<Eigen::VectorXd>(spline.controls.data(), spline.controls.size()) += move;
    }
    energy.follow(finder, spline);
    Relaxed result;
    result.total = energy.total(energy.terms(spline, spline.frames), alpha);
    for (int span = 0; span < space.spanCount(); ++span) {
        result.gain += energy.refinementGain(spline, alpha, span);
    }
    result.controls = std::move(spline.controls);
    return result;
}

// ---- Refined splines ----

TEST(FeetOfARefinedSpline, AreThoseOfItsPositions) {
    for (const bool closed : {false, true}) {
        SCOPED_TRACE(closed ? "closed" : "open");
        SolverOptions options;
        options.closed = closed;
        const Scene scene(noisySphere(), options, roundTheSphere(1.02, closed), 14);
        const SampledIntegrals before = scene.energy();
        const FootedSpline coarse = scene.footed(before, scene.controls());
        std::vector<double> breaks = scene.space().breaks();
        for (const int span : {0, 3, scene.space().spanCount() - 1}) {
            breaks.push_back(scene.space().breaks()[span] + 0.5 * scene.space().spanLength(span));
        }
        std::ranges::sort(breaks);
        const SplineSpace finer(3, closed, breaks);
        const SampledIntegrals energy(scene.problem(), finer, scene.edge());
        FootedSpline spline{
            refine(scene.space(), scene.controls(), finer),
            std::vector<FootPoint>(energy.sampleCount()),
            std::vector<FootFrame>(energy.sampleCount()),
            {},
            {}
        };
        const FibreProjector finder(scene.extended());
        energy.followRefined(finder, before, coarse, spline);
        FootedSpline again = spline;
        energy.follow(finder, again);
        for (int i = 0; i < energy.sampleCount(); ++i) {
            const FootPoint& foot = spline.feet[i];
            EXPECT_EQ(foot.face, again.feet[i].face);
            EXPECT_LT((spline.positions[i] - again.positions[i]).norm(), 1e-14);
            EXPECT_LT(
                (spline.seconds[i] - again.seconds[i]).norm(), 1e-9 * again.seconds[i].norm()
            );
            EXPECT_NEAR(foot.height, again.feet[i].height, 1e-8);
            EXPECT_LT((spline.frames[i].height - again.frames[i].height).norm(), 1e-6);
        }
    }
}

// How much the least energy falls where all spans are halved.
struct Halving {
    double promised = 0.0, fall = 0.0;
};

Halving halveAllSpans(const std::vector<Vec3>& picks, int degree, double alpha) {
    SolverOptions options;
    options.degree = degree;
    const ProblemFixture fixture(icosphere(4), picks, options);
    const SplineCurve first = fitInitialPath(fixture.problem(), fixture.initialPath()).value();
    const Relaxed coarse = relaxed(fixture, first.space, first.controls, alpha);
    std::vector<double> breaks = first.space.breaks();
    for (int span = 0; span < first.space.spanCount(); ++span) {
        breaks.push_back(first.space.breaks()[span] + 0.5 * first.space.spanLength(span));
    }
    std::ranges::sort(breaks);
    const SplineSpace finer(degree, false, breaks);
    const Relaxed fine =
        relaxed(fixture, finer, refine(first.space, coarse.controls, finer), alpha);
    return {coarse.gain, coarse.total - fine.total};
}

const std::vector<std::vector<Vec3>> kWays = {
    {{1, 0.1, 0}, {0, 1, 0.2}, {-0.45, 0.2, 0.87}},
    {{1, 0, 0}, {0.6, 0.8, 0}, {0, 0.6, 0.8}, {-0.8, 0, 0.6}},
};

// A fifth to a third of it: bulges stay within their spans.
TEST(GainOfBulge, ForetellsWhatHalvingAllSpansOfCubicsGainsOnASphere) {
    for (const std::vector<Vec3>& picks : kWays) {
        for (const double alpha : {100.0, 3000.0}) {
            SCOPED_TRACE(std::to_string(picks.size()) + " picks, alpha " + std::to_string(alpha));
            const Halving halving = halveAllSpans(picks, 3, alpha);
            EXPECT_GT(halving.fall, 0.0);
            EXPECT_LT(halving.promised, halving.fall);
            EXPECT_GT(halving.promised, halving.fall / 6.0);
        }
    }
}

// b'' is orthogonal to the second derivatives of cubics, but not of quartics: bending counts too.
TEST(GainOfBulge, PromisesNoMoreThanHalvingAllSpansOfQuarticsGains) {
    for (const std::vector<Vec3>& picks : kWays) {
        for (const double alpha : {100.0, 3000.0}) {
            SCOPED_TRACE(std::to_string(picks.size()) + " picks, alpha " + std::to_string(alpha));
            const Halving halving = halveAllSpans(picks, 4, alpha);
            EXPECT_LT(halving.promised, 3.0 * halving.fall);
        }
    }
}

}  // namespace
}  // namespace bspline_curve
