// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/curve_energy.h"

#include "solver/barrier.h"
#include "solver/cell_terms.h"
#include "solver/curve_tracer.h"
#include "solver/field_cost.h"

#include <algorithm>
#include <cmath>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

// Gauss-Legendre on [0, 1]. With two points line searches stall at a decrement of 1e-7 of the
// energy, since the exact gradient of the integrand is not that of the sum when pieces change; with
// three at 1e-9 or not at all, for 15 % more.
constexpr std::array<double, 3> kNodes = {0.11270166537925831, 0.5, 0.88729833462074169};
constexpr std::array<double, 3> kNodeWeights = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};

// A curve that grazes a wall has a kink term without bound; this is the least |n . P'| / |P'| that
// counts.
constexpr double kLeastCrossingCosine = 0.05;

// block += scale v v^T with v = basis (x) direction.
void addRankOne(
    SpanMatrix& block,
    const SplineSpace::BasisValues& basis,
    const Vec3& direction,
    double scale,
    int basisCount
) {
    std::array<double, kMaxSpanUnknowns> v{};
    const int size = 3 * basisCount;
    for (int j = 0; j < basisCount; ++j) {
        for (int axis = 0; axis < 3; ++axis) {
            v[at(3 * j + axis)] = basis[at(j)] * direction[axis];
        }
    }
    double* data = block.data();
    for (int j = 0; j < size; ++j) {
        const double factor = scale * v[at(j)];
        for (int i = 0; i < size; ++i) {
            data[j * size + i] += factor * v[at(i)];
        }
    }
}

void addGradient(
    Eigen::VectorXd& gradient,
    const SplineSpace& space,
    int span,
    const SplineSpace::BasisValues& basis,
    const Vec3& force
) {
    for (int j = 0; j < space.basisCount(); ++j) {
        gradient.segment<3>(3 * space.control(span, j)) += basis[at(j)] * force;
    }
}

// Integral over a span of the product of derivatives (of one order) of two basis functions,
// exactly.
double derivativeProduct(const SplineSpace& space, int span, int j1, int j2, int order) {
    const SplineSpace::BasisMatrix& table = space.basis(span);
    const auto falling = [order](int m) {
        double factor = 1.0;
        for (int i = 0; i < order; ++i) {
            factor *= m - i;
        }
        return factor;
    };
    double sum = 0.0;
    for (int a = order; a <= space.degree(); ++a) {
        for (int b = order; b <= space.degree(); ++b) {
            sum += falling(a) * falling(b) * table(j1, a) * table(j2, b) / (a + b - 2 * order + 1);
        }
    }
    return sum * std::pow(space.spanLength(span), 1 - 2 * order);
}

}  // namespace

void EnergyDerivatives::reset(const SplineSpace& space) {
    const int size = 3 * space.basisCount();
    gradient = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(space.controlCount()));
    hessian.assign(at(space.spanCount()), SpanMatrix::Zero(size, size));
    negativeKinks.assign(at(space.spanCount()), SpanMatrix::Zero(size, size));
}

double SpanDistances::largest() const {
    return distance.empty() ? 0.0 : *std::max_element(distance.begin(), distance.end());
}

CurveEnergy::CurveEnergy(
    const CurveProblem& problem, const SplineSpace& space, const std::vector<InterpolationRow>& rows
)
    : problem_(problem), space_(space), rows_(rows) {
    const int n = space.basisCount();
    const double tension = problem.options.tension;
    const double scale = 2.0 / (problem.chordLength * problem.chordLength);
    ambient_.assign(at(space.spanCount()), SpanMatrix::Zero(3 * n, 3 * n));
    for (int span = 0; span < space.spanCount(); ++span) {
        for (int j1 = 0; j1 < n; ++j1) {
            for (int j2 = 0; j2 < n; ++j2) {
                const double value =
                    scale * (tension * derivativeProduct(space, span, j1, j2, 1) +
                             (1.0 - tension) * derivativeProduct(space, span, j1, j2, 2));
                for (int axis = 0; axis < 3; ++axis) {
                    ambient_[at(span)](3 * j1 + axis, 3 * j2 + axis) = value;
                }
            }
        }
    }
    internal_ = ambient_;
}

Vec3 BendingDirections::at(double parameter) const {
    const auto above = std::upper_bound(
        samples.begin(), samples.end(), parameter, [](double value, const Sample& sample) {
            return value < sample.parameter;
        }
    );
    if (above == samples.begin() || above == samples.end()) {
        return above == samples.end() ? samples.back().direction : samples.front().direction;
    }
    const Sample& before = *(above - 1);
    const double gap = above->parameter - before.parameter;
    const double s = gap > 0.0 ? (parameter - before.parameter) / gap : 0.0;
    return ((1.0 - s) * before.direction + s * above->direction).normalized();
}

std::optional<BendingDirections> CurveEnergy::directionsAlong(const ControlPoints& controls) const {
    BendingDirections result;
    const int spans = traceCurve(
        problem_,
        space_,
        controls,
        [&](
            int span, const PolynomialCurve& curve, const ShellCell& cell, double tau0, double tau1
        ) {
            for (std::size_t i = 0; i < kNodes.size(); ++i) {
                const double tau = tau0 + (tau1 - tau0) * kNodes[i];
                result.samples.push_back(
                    {space_.breaks()[at(span)] + tau * space_.spanLength(span),
                     kNodeWeights[i] * (tau1 - tau0) * space_.spanLength(span),
                     fibreAt(*problem_.shell, cell.prism, cell.shadow(curve.at(tau))).normalized()}
                );
            }
        },
        [](int, const PolynomialCurve&, const ShellCell&, const ShellCell&, double, int) {}
    );
    if (spans != space_.spanCount()) {
        return std::nullopt;
    }
    return result;
}

void CurveEnergy::setDirections(const BendingDirections& directions) {
    internal_ = ambient_;
    const double scale = -2.0 / (problem_.chordLength * problem_.chordLength) *
                         (1.0 - problem_.options.tension) *
                         (1.0 - problem_.options.normalBendingWeight);
    int span = 0;
    for (const BendingDirections::Sample& sample : directions.samples) {
        while (span + 1 < space_.spanCount() && sample.parameter > space_.breaks()[at(span) + 1]) {
            ++span;
        }
        const double tau = (sample.parameter - space_.breaks()[at(span)]) / space_.spanLength(span);
        addRankOne(
            internal_[at(span)],
            space_.basisDerivativeAt(span, tau, 2),
            sample.direction,
            scale * sample.weight,
            space_.basisCount()
        );
    }
}

template <bool kDerivatives>
EnergyValue CurveEnergy::integrate(
    const ControlPoints& controls, const EnergyWeights& weights, EnergyDerivatives* derivatives
) const {
    EnergyValue value;
    const double mu = problem_.field.empty() ? 0.0 : problem_.options.fieldWeight;
    const FieldCost cost = problem_.options.fieldCost;
    bool belowBarrier = true;

    const auto onPiece =
        [&](
            int span, const PolynomialCurve& curve, const ShellCell& cell, double tau0, double tau1
        ) {
            const bool ghost = problem_.shell->isGhost(cell.prism);
            const AffineForm beyond = ghost ? beyondForm(problem_, cell) : AffineForm();
            const AffineForm field = mu > 0.0 ? fieldForm(problem_, cell) : AffineForm();
            for (std::size_t i = 0; i < kNodes.size(); ++i) {
                const double tau = tau0 + (tau1 - tau0) * kNodes[i];
                const double weight = kNodeWeights[i] * (tau1 - tau0) * space_.spanLength(span);
                const Vec3 p = curve.at(tau);
                Vec3 force = Vec3::Zero();
                SplineSpace::BasisValues basis{};
                if constexpr (kDerivatives) {
                    basis = space_.basisAt(span, tau);
                }
                const auto addBarrier = [&](const Vec3& gradient, double x) {
                    if (std::abs(x) >= weights.barrierWidth) {
                        belowBarrier = false;
                        return;
                    }
                    if constexpr (kDerivatives) {
                        const Barrier g = barrier(x, weights.barrierWidth);
                        value.terms.distance += weight * g.value;
                        force += weight * weights.alpha * g.slope * gradient;
                        addRankOne(
                            derivatives->hessian[at(span)],
                            basis,
                            gradient,
                            weight * weights.alpha * g.curvature,
                            space_.basisCount()
                        );
                    } else {
                        value.terms.distance += weight * barrierValue(x, weights.barrierWidth);
                    }
                };
                addBarrier(cell.heightGradient, cell.height(p));
                if (ghost) {
                    addBarrier(beyond.gradient, beyond.at(p));
                }
                if (mu > 0.0) {
                    const FieldCostValue c = fieldCost(cost, field.at(p));
                    value.terms.external += weight * c.value;
                    if constexpr (kDerivatives) {
                        force += weight * mu * c.slope * field.gradient;
                        addRankOne(
                            derivatives->hessian[at(span)],
                            basis,
                            field.gradient,
                            weight * mu * std::max(0.0, c.curvature),
                            space_.basisCount()
                        );
                    }
                }
                if constexpr (kDerivatives) {
                    addGradient(derivatives->gradient, space_, span, basis, force);
                }
            }
        };

    // At a wall the integrand keeps its value and its gradient jumps along the wall's normal;
    // moving the curve moves the crossing, which gives the second derivative q (n . dP)^2 with q =
    // jump / |n . P'|.
    const auto onCrossing = [&](int span,
                                const PolynomialCurve& curve,
                                const ShellCell& from,
                                const ShellCell& to,
                                double tau,
                                int k) {
        if constexpr (kDerivatives) {
            const Vec3 normal = -from.gradients[at(k)].normalized();
            const Vec3 p = curve.at(tau);
            double jump = 0.0;
            const double height = from.height(p);
            if (std::abs(height) < weights.barrierWidth) {
                jump += weights.alpha * barrier(height, weights.barrierWidth).slope *
                        (to.heightGradient - from.heightGradient).dot(normal);
            }
            if (mu > 0.0) {
                const AffineForm before = fieldForm(problem_, from);
                jump += mu * fieldCost(cost, before.at(p)).slope *
                        (fieldForm(problem_, to).gradient - before.gradient).dot(normal);
            }
            const Vec3 velocity = curve.derivativeAt(tau) / space_.spanLength(span);
            const double speed =
                std::max(std::abs(normal.dot(velocity)), kLeastCrossingCosine * velocity.norm());
            if (speed > 0.0 && jump != 0.0) {
                auto& blocks = jump > 0.0 ? derivatives->hessian : derivatives->negativeKinks;
                addRankOne(
                    blocks[at(span)],
                    space_.basisAt(span, tau),
                    normal,
                    jump / speed,
                    space_.basisCount()
                );
            }
        }
    };

    const int spans = traceCurve(problem_, space_, controls, onPiece, onCrossing);
    value.inside = spans == space_.spanCount() && belowBarrier;
    if (!value.inside) {
        return value;
    }
    addInternal(controls, value, derivatives);
    addFit(controls, weights, value, derivatives);
    value.total = value.terms.internal + mu * value.terms.external +
                  weights.alpha * value.terms.distance + weights.beta * value.terms.fit;
    return value;
}

void CurveEnergy::addInternal(
    const ControlPoints& controls, EnergyValue& value, EnergyDerivatives* derivatives
) const {
    const int n = space_.basisCount();
    SpanVector x(3 * n);
    SpanVector hx(3 * n);
    for (int span = 0; span < space_.spanCount(); ++span) {
        for (int j = 0; j < n; ++j) {
            x.segment<3>(3 * j) = controls.row(space_.control(span, j)).transpose();
        }
        hx.noalias() = internal_[at(span)] * x;
        value.terms.internal += 0.5 * x.dot(hx);
        if (derivatives != nullptr) {
            for (int j = 0; j < n; ++j) {
                derivatives->gradient.segment<3>(3 * space_.control(span, j)) +=
                    hx.segment<3>(3 * j);
            }
            derivatives->hessian[at(span)] += internal_[at(span)];
        }
    }
}

void CurveEnergy::addFit(
    const ControlPoints& controls,
    const EnergyWeights& weights,
    EnergyValue& value,
    EnergyDerivatives* derivatives
) const {
    const double scale =
        1.0 / (static_cast<double>(rows_.size()) * problem_.chordLength * problem_.chordLength);
    for (const InterpolationRow& row : rows_) {
        Vec3 gap = -row.target;
        for (int j = 0; j < space_.basisCount(); ++j) {
            gap += row.values[at(j)] * controls.row(space_.control(row.span, j)).transpose();
        }
        value.terms.fit += scale * gap.squaredNorm();
        if (derivatives != nullptr && weights.beta > 0.0) {
            addGradient(
                derivatives->gradient,
                space_,
                row.span,
                row.values,
                2.0 * scale * weights.beta * gap
            );
            for (int axis = 0; axis < 3; ++axis) {
                addRankOne(
                    derivatives->hessian[at(row.span)],
                    row.values,
                    Vec3::Unit(axis),
                    2.0 * scale * weights.beta,
                    space_.basisCount()
                );
            }
        }
    }
}

EnergyValue CurveEnergy::evaluate(
    const ControlPoints& controls, const EnergyWeights& weights
) const {
    return integrate<false>(controls, weights, nullptr);
}

EnergyValue CurveEnergy::evaluate(
    const ControlPoints& controls, const EnergyWeights& weights, EnergyDerivatives& derivatives
) const {
    derivatives.reset(space_);
    return integrate<true>(controls, weights, &derivatives);
}

SpanDistances CurveEnergy::measure(const ControlPoints& controls) const {
    SpanDistances result;
    result.distance.assign(at(space_.spanCount()), 0.0);
    const auto measureAt = [&](int span, const ShellCell& cell, const Vec3& p) {
        const Vec3 shadow = cell.shadow(p);
        const double height = cell.height(p);
        Vec3 onSurface = Vec3::Zero();
        const Triangle& face = problem_.base->faces[at(cell.prism)];
        for (int corner = 0; corner < 3; ++corner) {
            // A ghost vertex stands for the boundary vertex that it grew from.
            onSurface +=
                shadow[corner] *
                problem_.base->vertices[at(problem_.base->surfaceVertex(face[at(corner)]))];
        }
        result.largestHeight = std::max(result.largestHeight, std::abs(height));
        result.distance[at(span)] = std::max(result.distance[at(span)], (p - onSurface).norm());
    };
    traceCurve(
        problem_,
        space_,
        controls,
        [&](
            int span, const PolynomialCurve& curve, const ShellCell& cell, double tau0, double tau1
        ) {
            measureAt(span, cell, curve.at(tau0));
            measureAt(span, cell, curve.at(0.5 * (tau0 + tau1)));
        },
        [](int, const PolynomialCurve&, const ShellCell&, const ShellCell&, double, int) {}
    );
    return result;
}

}  // namespace bspline_curve
