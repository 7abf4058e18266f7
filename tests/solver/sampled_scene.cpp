// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/sampled_scene.h"

#include "support/meshes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace bspline_curve::test_support {
namespace {

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

}  // namespace

Scene::Scene(const TriangleMesh& mesh, const SolverOptions& options, const Way& way, int spans)
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

void Scene::setField(const std::function<double(const Vec3&)>& value) {
    field_.clear();
    for (const Vec3& v : extended_.vertices) {
        field_.push_back(value(extended_.frame.toUser(v)));
    }
    problem_.field = field_;
    problem_.fieldCosts = summaryOf(vertexCostsOf(problem_.field, problem_.options.fieldCost));
}

void Scene::avoid(const std::function<bool(const Vec3&)>& isIn, double margin) {
    Region region;
    for (int f = 0; f < surface_.faceCount(); ++f) {
        if (isIn(surface_.position({f, Vec3::Constant(1.0 / 3.0)}))) {
            region.push_back(f);
        }
    }
    obstacles_ = std::make_unique<Obstacles>(surface_, extended_, region, margin);
    problem_.obstacles = obstacles_.get();
}

void Scene::setFairedShape(const Way& way) {
    constexpr int kPoints = 40;
    const auto at = [&](double t) { return extended_.frame.toUnit(way(t)); };
    problem_.faired.stiffness = 1e3;
    problem_.faired.strength = 0.7;
    for (int i = 0; i <= kPoints; ++i) {
        const double t = static_cast<double>(i) / kPoints;
        const Vec3 second = (at(t + 1e-3) - 2.0 * at(t) + at(t - 1e-3)) / 1e-6;
        problem_.faired.points.push_back({t, i % 10 == 0 ? 0.0 : 1.0 / kPoints, at(t), second});
    }
}

FootedSpline Scene::footed(const SampledIntegrals& energy, ControlPoints controls) const {
    FootedSpline spline = withNearestFeet(energy, space_, tree_, std::move(controls));
    energy.follow(finder_, spline);
    return spline;
}

FootedSpline Scene::moved(
    const SampledIntegrals& energy, const FootedSpline& from, const ControlPoints& change
) const {
    FootedSpline spline = from;
    spline.controls += change;
    energy.follow(finder_, spline);
    return spline;
}

std::vector<double> breaksWithMiddles(const SplineSpace& space, const std::vector<int>& spans) {
    std::vector<double> breaks = space.breaks();
    for (const int span : spans) {
        breaks.push_back(space.breaks()[span] + 0.5 * space.spanLength(span));
    }
    std::ranges::sort(breaks);
    return breaks;
}

FootedSpline withNearestFeet(
    const SampledIntegrals& energy,
    const SplineSpace& space,
    const TriangleTree& tree,
    ControlPoints controls
) {
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
    return spline;
}

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

Derivatives derivativesOf(
    const SampledIntegrals& energy, const FootedSpline& spline, double turning
) {
    Derivatives derivatives;
    derivatives.terms = energy.differentiate(
        spline, kSceneWeights, turning, derivatives.gradient, derivatives.hessian
    );
    return derivatives;
}

}  // namespace bspline_curve::test_support
