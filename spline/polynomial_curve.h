// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <array>
#include <utility>

namespace bspline_curve {

inline constexpr int kMaxPolynomialDegree = 4;

/// A polynomial curve p(s) = sum c_j s^j.
struct PolynomialCurve {
    int degree = 3;
    std::array<Vec3, kMaxPolynomialDegree + 1> coefficients;

    [[nodiscard]] Vec3 at(double s) const {
        Vec3 value = coefficients[degree];
        for (int j = degree; j-- > 0;) {
            value = value * s + coefficients[j];
        }
        return value;
    }

    /// The first derivative at s.
    [[nodiscard]] Vec3 derivativeAt(double s) const {
        Vec3 value = degree * coefficients[degree];
        for (int j = degree - 1; j > 0; --j) {
            value = value * s + j * coefficients[j];
        }
        return value;
    }

    /// Value and first derivative at s, for less than both apart.
    [[nodiscard]] std::pair<Vec3, Vec3> withDerivativeAt(double s) const {
        Vec3 value = coefficients[degree];
        Vec3 derivative = Vec3::Zero();
        for (int j = degree; j-- > 0;) {
            derivative = derivative * s + value;
            value = value * s + coefficients[j];
        }
        return {value, derivative};
    }

    /// The second derivative at s.
    [[nodiscard]] Vec3 secondDerivativeAt(double s) const {
        Vec3 value = degree * (degree - 1) * coefficients[degree];
        for (int j = degree - 1; j > 1; --j) {
            value = value * s + j * (j - 1) * coefficients[j];
        }
        return value;
    }

    /// The same curve with s measured from `start`.
    [[nodiscard]] PolynomialCurve shifted(double start) const;
};

}  // namespace bspline_curve
