// SPDX-License-Identifier: GPL-3.0-or-later
// What terms of the energy give at a point: see solver/energy_terms.h.
#pragma once

#include "bspline_curve/report.h"
#include "solver/energy_derivatives.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bspline_curve {

/// Whether x is on the pole of g or behind it.
template <class Function>
[[nodiscard]] bool isOnPole(const Function& g, double x) {
    if constexpr (Function::kHasPole) {
        return std::abs(x) >= g.pole();
    } else {
        return false;
    }
}

/// Adds weighted values. Takes no pole.
struct TakeValue {
    EnergyTerms& terms;

    template <class Function, class Argument>
    bool operator()(
        double EnergyTerms::* share,
        double weight,
        double /*ofTerm*/,
        const Function& g,
        const Argument& x
    ) const {
        if (isOnPole(g, x.value)) {
            return false;
        }
        terms.*share += g.value(weight, x.value);
        return true;
    }
};

/// Adds weighted values, and derivatives with the term's weight.
struct TakeDerivatives {
    EnergyTerms& terms;
    PointDerivatives& derivatives;

    template <class Function, class Argument>
    bool operator()(
        double EnergyTerms::* share,
        double weight,
        double ofTerm,
        const Function& g,
        const Argument& x
    ) const {
        if (isOnPole(g, x.value)) {
            return false;
        }
        const auto [value, slope, curvature] = g.jet(weight, weight * ofTerm, x.value);
        terms.*share += value;
        x.addDerivatives(slope, curvature, derivatives);
        return true;
    }
};

/// Adds the gradient alone. Leaves out what is on a pole.
struct TakeForce {
    struct Force {
        Vec3 force = Vec3::Zero();

        void addRankOne(const Vec3& /*v*/, double /*scale*/) const {}

        void addNegative(const Vec3& /*v*/, double /*scale*/) const {}

        void addProduct(const Vec3& /*a*/, const Vec3& /*b*/, double /*scale*/) const {}
    };

    Force& sum;

    template <class Function, class Argument>
    bool operator()(
        double EnergyTerms::* /*share*/,
        double weight,
        double ofTerm,
        const Function& g,
        const Argument& x
    ) const {
        if constexpr (Function::kHasPole) {
            if (!Function::kMayTouch && isOnPole(g, x.value)) {
                return true;
            }
        }
        const auto [value, slope, curvature] = g.jet(weight, weight * ofTerm, x.value);
        x.addDerivatives(slope, curvature, sum);
        return true;
    }
};

/// How far the nearest pole is, relative to its distance from 0: 1 at 0, 0 on the pole.
struct TakeRoom {
    double& room;

    template <class Function, class Argument>
    bool operator()(
        double EnergyTerms::* /*share*/,
        double /*weight*/,
        double /*ofTerm*/,
        const Function& g,
        const Argument& x
    ) const {
        if constexpr (Function::kHasPole) {
            room = std::min(room, 1.0 - std::abs(x.value) / g.pole());
        }
        return true;
    }
};

}  // namespace bspline_curve
