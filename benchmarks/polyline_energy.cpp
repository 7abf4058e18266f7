// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/polyline_energy.h"

#include "solver/energy_terms.h"
#include "solver/sampled_solver.h"
#include "utility/worker_thread.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace bspline_curve::benchmarks {
namespace {

// So many vertices at once are followed by one of two threads.
constexpr std::size_t kVerticesAtOnce = 32;

// scale (I - share n n^T).
SymmetricMatrix projection(const Vec3& n, double share, double scale) {
    SymmetricMatrix result = rankOne(n, -share * scale);
    result += SymmetricMatrix{scale, 0.0, 0.0, scale, 0.0, scale};
    return result;
}

}  // namespace

PolylineEnergy::PolylineEnergy(const CurveProblem& problem, int count)
    : problem_(problem),
      heightUnit_(heightUnitOf(problem)),
      normalShare_(
          problem.options.bending == Bending::Geodesic ? 1.0 - problem.options.normalBendingWeight
                                                       : 0.0
      ) {
    const double scale = 1.0 / (problem.chordLength * problem.chordLength);
    bending_ = scale * (1.0 - problem.options.tension);
    stretching_ = scale * problem.options.tension;
    placeVertices(count);
}

void PolylineEnergy::placeVertices(int count) {
    const int picks = static_cast<int>(problem_.picks.size());
    for (int pick = 0; pick < (isClosed() ? picks : picks - 1); ++pick) {
        const double begin = problem_.picks[pick].parameter;
        const double end = pick + 1 < picks ? problem_.picks[pick + 1].parameter : 1.0;
        const int steps = std::max(2, static_cast<int>(std::lround((end - begin) * count)));
        const double step = (end - begin) / steps;
        for (int i = 0; i < steps; ++i) {
            vertices_.push_back({begin + i * step, step, 0.0, i == 0 ? pick : -1});
        }
    }
    if (!isClosed()) {
        vertices_.push_back({1.0, 0.0, 0.0, picks - 1});
    }
    for (int segment = 0; segment < segmentCount(); ++segment) {
        const double half = 0.5 * vertices_[segment].step;
        vertices_[segment].weight += half;
        vertices_[after(segment, 1)].weight += half;
    }
}

FootedPolyline PolylineEnergy::along(
    const InitialPath& initialPath, const FibreProjector& finder
) const {
    FootedPolyline line;
    for (const Vertex& vertex : vertices_) {
        const SurfacePoint& near = initialPath.points[initialPath.indexAt(vertex.parameter)].point;
        line.feet.push_back({near.face, near.barycentric[1], near.barycentric[2], 0.0});
        line.points.push_back(
            vertex.pick >= 0 ? problem_.picks[vertex.pick].position
                             : initialPath.positionAt(vertex.parameter)
        );
    }
    line.frames.resize(line.feet.size());
    follow(finder, line);
    return line;
}

void PolylineEnergy::follow(const FibreProjector& finder, FootedPolyline& line) const {
    const std::size_t vertices = line.points.size();
    const auto groups = static_cast<int>((vertices + kVerticesAtOnce - 1) / kVerticesAtOnce);
    forEach(problem_.side, groups, 1, [&](int group) {
        const std::size_t first = group * kVerticesAtOnce;
        std::array<FibreProjector::Move, kVerticesAtOnce> moves;
        std::size_t end = 0;
        for (std::size_t i = first; i < std::min(vertices, first + kVerticesAtOnce); ++i) {
            moves[end++] = {line.points[i], &line.feet[i], &line.frames[i]};
        }
        static_cast<void>(finder.moveAll({moves.data(), end}));
    });
}

PolylineEnergy::Stencil PolylineEnergy::stencil(int first) const {
    const double before = vertices_[first].step;
    const double behind = vertices_[after(first, 1)].step;
    const double twice = 2.0 / (before + behind);
    return {
        {twice / before, -twice / before - twice / behind, twice / behind},
        bending_ * vertices_[after(first, 1)].weight
    };
}

Vec3 PolylineEnergy::secondDerivative(const FootedPolyline& line, int first) const {
    const Stencil difference = stencil(first);
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        sum += difference.factors[k] * line.points[after(first, k)];
    }
    return sum;
}

PolylineEnergy::Terms PolylineEnergy::terms(
    const FootedPolyline& line, const std::vector<FootFrame>& frozen
) const {
    Terms terms;
    for (int first = 0; first < stencilCount(); ++first) {
        const Vec3 second = secondDerivative(line, first);
        const double along = frozen[after(first, 1)].direction.dot(second);
        terms.internal +=
            stencil(first).weight * (second.squaredNorm() - normalShare_ * along * along);
    }
    for (int segment = 0; stretching_ > 0.0 && segment < segmentCount(); ++segment) {
        const Vec3 edge = line.points[after(segment, 1)] - line.points[segment];
        terms.internal += stretching_ / vertices_[segment].step * edge.squaredNorm();
    }
    for (int i = 0; i < count(); ++i) {
        const double height = line.feet[i].height / heightUnit_;
        terms.distance += vertices_[i].weight * height * height;
    }
    return terms;
}

void PolylineEnergy::addBending(
    const FootedPolyline& line, Eigen::VectorXd& gradient, std::vector<Blocks>& hessian
) const {
    for (int first = 0; first < stencilCount(); ++first) {
        const Stencil difference = stencil(first);
        const Vec3& direction = line.frames[after(first, 1)].direction;
        const double twice = 2.0 * difference.weight;
        const Vec3 second = secondDerivative(line, first);
        const Vec3 force = twice * (second - normalShare_ * direction.dot(second) * direction);
        const SymmetricMatrix matrix = projection(direction, normalShare_, twice);
        for (int j = 0; j < 3; ++j) {
            const double factor = difference.factors[j];
            gradient.segment<3>(3 * Eigen::Index{after(first, j)}) += factor * force;
            for (int k = j; k < 3; ++k) {
                hessian[after(first, j)][k - j] += (factor * difference.factors[k]) * matrix;
            }
        }
    }
}

void PolylineEnergy::addTension(
    const FootedPolyline& line, Eigen::VectorXd& gradient, std::vector<Blocks>& hessian
) const {
    for (int segment = 0; segment < segmentCount(); ++segment) {
        const int end = after(segment, 1);
        const double twice = 2.0 * stretching_ / vertices_[segment].step;
        const Vec3 force = twice * (line.points[end] - line.points[segment]);
        gradient.segment<3>(3 * Eigen::Index{end}) += force;
        gradient.segment<3>(3 * Eigen::Index{segment}) -= force;
        const SymmetricMatrix matrix{twice, 0.0, 0.0, twice, 0.0, twice};
        hessian[segment][0] += matrix;
        hessian[end][0] += matrix;
        hessian[segment][1] += -1.0 * matrix;
    }
}

void PolylineEnergy::differentiate(
    const FootedPolyline& line,
    double alpha,
    double turning,
    Eigen::VectorXd& gradient,
    std::vector<Blocks>& hessian
) const {
    gradient = Eigen::VectorXd::Zero(3 * Eigen::Index{count()});
    hessian.assign(count(), Blocks{});
    addBending(line, gradient, hessian);
    if (stretching_ > 0.0) {
        addTension(line, gradient, hessian);
    }
    for (int i = 0; i < count(); ++i) {
        const double stiffness = 2.0 * alpha * vertices_[i].weight / (heightUnit_ * heightUnit_);
        PointDerivatives point;
        const FootSample sample{line.feet[i], line.frames[i], turning};
        FootHeight(sample).addDerivatives(stiffness * line.feet[i].height, stiffness, point);
        gradient.segment<3>(3 * Eigen::Index{i}) += point.force;
        hessian[i][0] += point.second;
    }
}

double PolylineEnergy::largestHeight(const FootedPolyline& line) const {
    double largest = 0.0;
    for (const FootPoint& foot : line.feet) {
        largest = std::max(largest, std::abs(foot.height));
    }
    return largest;
}

}  // namespace bspline_curve::benchmarks
