// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spline/span_moments.h"

#include <vector>

namespace bspline_curve {

/// First and second derivatives of the energy by the control points: the gradient, and the Hessian
/// as span blocks. The part of the Hessian that kinks of the integrand at cell walls subtract is
/// kept apart, so that it can be damped.
struct EnergyDerivatives {
    Eigen::VectorXd gradient;
    std::vector<SpanBlocks> hessian;
    std::vector<SpanBlocks> negativeKinks;

    void reset(const SplineSpace& space);
};

/// First and second derivative of an integrand by the position, times a weight.
struct PointDerivatives {
    Vec3 force = Vec3::Zero();
    SymmetricMatrix second{};
    /// What the integrand's own curvature subtracts, kept apart as that of kinks is.
    SymmetricMatrix negative{};
    bool hasNegative = false;

    /// scale v v^T to the second derivative.
    void addRankOne(const Vec3& v, double scale) { second += rankOne(v, scale); }

    /// The same for a scale below 0.
    void addNegative(const Vec3& v, double scale) {
        negative += rankOne(v, scale);
        hasNegative = true;
    }

    /// scale (a b^T + b a^T).
    void addProduct(const Vec3& a, const Vec3& b, double scale) {
        const Vec3 u = scale * a;
        second[0] += 2.0 * u[0] * b[0];
        second[1] += u[0] * b[1] + u[1] * b[0];
        second[2] += u[0] * b[2] + u[2] * b[0];
        second[3] += 2.0 * u[1] * b[1];
        second[4] += u[1] * b[2] + u[2] * b[1];
        second[5] += 2.0 * u[2] * b[2];
    }
};

/// Collects derivatives at points of a curve, span by span in order, as those by the control
/// points.
class DerivativeCollector {
public:
    DerivativeCollector(const SplineSpace& space, EnergyDerivatives& derivatives)
        : space_(space),
          derivatives_(derivatives),
          points_(space.degree()),
          negativeKinks_(space.degree()) {}

    void add(int span, double tau, const PointDerivatives& point) {
        startSpan(span);
        points_.addForce(tau, point.force);
        points_.addMatrix(tau, point.second);
        if (point.hasNegative) {
            negativeKinks_.addMatrix(tau, point.negative);
        }
    }

    /// A second derivative scale normal normal^T, kept apart where it is negative.
    void addKink(int span, double tau, const Vec3& normal, double scale) {
        startSpan(span);
        (scale > 0.0 ? points_ : negativeKinks_).addMatrix(tau, rankOne(normal, scale));
    }

    /// To be called after the last span.
    void finish();

private:
    void startSpan(int span) {
        if (span != span_) {
            finish();
            span_ = span;
        }
    }

    const SplineSpace& space_;
    EnergyDerivatives& derivatives_;
    SpanMoments points_, negativeKinks_;
    int span_ = -1;
};

}  // namespace bspline_curve
