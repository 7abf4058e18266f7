// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/polynomial_trace.h"

namespace bspline_curve {
namespace {

double evaluate(const double* c, int degree, double s) {
    double value = c[degree];
    for (int j = degree; j-- > 0;) {
        value = value * s + c[j];
    }
    return value;
}

using Coefficients = std::array<double, kMaxPolynomialDegree + 1>;

Coefficients derivativeOf(const double* c, int degree) {
    Coefficients d{};
    for (int j = 1; j <= degree; ++j) {
        d[j - 1] = j * c[j];
    }
    return d;
}

// Bound of |c_2 s^2 + ... | and of its derivative on [0, s].
struct HigherTerms {
    double value = 0.0, derivative = 0.0;
};

HigherTerms boundHigherTerms(const double* c, int degree, double s) {
    HigherTerms bound;
    double power = s;
    for (int j = 2; j <= degree; ++j) {
        bound.derivative += j * std::abs(c[j]) * power;
        power *= s;
        bound.value += std::abs(c[j]) * power;
    }
    return bound;
}

// Root of a polynomial that is monotone in [a, b]; times `sign` it falls from >= 0 at a to < 0 at
// b. Newton kept inside the bracket.
double bracketedRoot(const double* c, int degree, double a, double b, double sign) {
    constexpr int kMaxIterations = 60;       // more than bisection takes
    constexpr double kRootRounding = 1e-15;  // of a root, relative to b
    const Coefficients d = derivativeOf(c, degree);
    double s = 0.5 * (a + b);
    for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
        const double value = sign * evaluate(c, degree, s);
        if (value >= 0.0) {
            a = s;
        } else {
            b = s;
        }
        const double slope = sign * evaluate(d.data(), degree - 1, s);
        double next = slope < 0.0 ? s - value / slope : a - 1.0;
        if (next <= a || next >= b) {
            next = 0.5 * (a + b);
        }
        if (std::abs(next - s) <= kRootRounding * b || b - a <= kRootRounding * b) {
            return next;
        }
        s = next;
    }
    return s;
}

// All parameters in (0, end) where the polynomial changes sign, ascending, by the roots of its
// derivative.
int signChanges(const double* c, int degree, double end, double* roots) {
    if (degree == 1) {
        if (c[1] == 0.0) {
            return 0;
        }
        roots[0] = -c[0] / c[1];
        return roots[0] > 0.0 && roots[0] < end ? 1 : 0;
    }
    const Coefficients d = derivativeOf(c, degree);
    std::array<double, kMaxPolynomialDegree + 2> breaks{};
    int count = signChanges(d.data(), degree - 1, end, breaks.data() + 1);
    breaks[0] = 0.0;
    breaks[++count] = end;
    int found = 0;
    for (int i = 0; i < count; ++i) {
        const double a = breaks[i];
        const double b = breaks[i + 1];
        const bool isPositive = evaluate(c, degree, a) >= 0.0;
        if (isPositive != (evaluate(c, degree, b) >= 0.0)) {
            roots[found++] = bracketedRoot(c, degree, a, b, isPositive ? 1.0 : -1.0);
        }
    }
    return found;
}

// Root of a polynomial that falls all the way from c[0] >= 0 to a negative value at `limit`:
// Newton, a handful of steps from the root of the tangent.
double rootOfFalling(const double* c, int degree, double limit) {
    constexpr int kMaxSteps = 8;
    constexpr double kLastStep = 1e-9;
    double s = std::min(limit, c[0] / -c[1]);
    for (int step = 0; step < kMaxSteps; ++step) {
        double value = c[degree];
        double slope = 0.0;
        for (int j = degree; j-- > 0;) {
            slope = slope * s + value;
            value = value * s + c[j];
        }
        const double next = std::clamp(s - value / slope, 0.0, limit);
        // The step after one this small would be its square.
        if (std::abs(next - s) <= kLastStep * limit) {
            return next;
        }
        s = next;
    }
    return bracketedRoot(c, degree, 0.0, limit, 1.0);  // nearly a double root
}

// The general case: the first sign change after which the polynomial is negative.
double firstExitByIsolation(const double* c, int degree, double end) {
    Coefficients roots{};
    const int count = signChanges(c, degree, end, roots.data());
    for (int i = 0; i < count; ++i) {
        const double a = roots[i];
        const double b = i + 1 < count ? roots[i + 1] : end;
        if (evaluate(c, degree, 0.5 * (a + b)) < 0.0) {
            return a;
        }
    }
    return end;
}

// Whether a polynomial cannot fall below -tolerance before `end`, by the sum of its terms.
template <int Degree>
bool staysInside(const double* c, double end, double tolerance) {
    double higher = 0.0;
    double power = end;
    for (int j = 2; j <= Degree; ++j) {
        power *= end;
        higher += std::abs(c[j]) * power;
    }
    return c[0] + tolerance + std::min(0.0, c[1] * end) - higher >= 0.0;
}

template <int Degree>
CellExit firstExitOfDegree(
    const ShellCell& cell,
    const PolynomialCurve& curve,
    double end,
    unsigned ignoredWalls,
    double tolerance
) {
    // The curve by axes and the walls along it, coefficients side by side in an even number, so
    // that two are computed at once.
    constexpr int kCount = (Degree + 2) / 2 * 2;
    using WallCoefficients = Eigen::Matrix<double, kCount, 1>;
    Eigen::Matrix<double, kCount, 3> axes = Eigen::Matrix<double, kCount, 3>::Zero();
    for (int j = 0; j <= Degree; ++j) {
        axes.row(j) = curve.coefficients[j].transpose();
    }
    std::array<WallCoefficients, ShellCell::kMaxWalls> walls;
    int nearest = 0;
    double nearestExit = std::numeric_limits<double>::infinity();
    for (int k = 0; k < cell.wallCount; ++k) {
        const AffineForm& form = cell.walls[k];
        WallCoefficients& wall = walls[k];
        wall.noalias() = form.gradient.x() * axes.col(0) + form.gradient.y() * axes.col(1) +
                         form.gradient.z() * axes.col(2);
        wall[0] += form.offset;
        // Where the tangent leaves.
        if (wall[1] < 0.0 && -wall[0] > nearestExit * wall[1]) {
            nearestExit = -wall[0] / wall[1];
            nearest = k;
        }
    }
    // The wall that the tangent leaves by first bounds the search for the others.
    CellExit exit{end, -1};
    for (int i = 0; i < cell.wallCount; ++i) {
        const int k = nearest + i < cell.wallCount ? nearest + i : nearest + i - cell.wallCount;
        const WallCoefficients& wall = walls[k];
        if ((ignoredWalls >> static_cast<unsigned>(k) & 1U) != 0 ||
            staysInside<Degree>(wall.data(), exit.s, tolerance)) {
            continue;
        }
        const double candidate = firstExit(wall.data(), Degree, exit.s, tolerance);
        if (candidate < exit.s) {
            exit = {candidate, k};
        }
    }
    return exit;
}

// The same for a straight line, where a division per wall that is met is enough.
CellExit firstExitOfLine(
    const ShellCell& cell,
    const PolynomialCurve& curve,
    double end,
    unsigned ignoredWalls,
    double tolerance
) {
    CellExit exit{end, -1};
    for (int k = 0; k < cell.wallCount; ++k) {
        const AffineForm& form = cell.walls[k];
        const double value = form.at(curve.coefficients[0]) + tolerance;
        const double slope = form.gradient.dot(curve.coefficients[1]);
        if (value + std::min(0.0, slope * exit.s) < 0.0 &&
            (ignoredWalls >> static_cast<unsigned>(k) & 1U) == 0) {
            exit = {value < 0.0 ? 0.0 : value / -slope, k};
        }
    }
    return exit;
}

}  // namespace

double TraceState::tolerance() const {
    constexpr int kCrossingsPerGrowth = 16;  // without progress, until the tolerance grows tenfold
    constexpr double kMaxGrowth = 1e4;
    return stalled < kCrossingsPerGrowth
               ? kCellTolerance
               : kCellTolerance *
                     std::min(std::pow(10.0, stalled / kCrossingsPerGrowth), kMaxGrowth);
}

double firstExit(const double* coefficients, int degree, double end, double tolerance) {
    Coefficients c{};
    std::copy(coefficients, coefficients + degree + 1, c.begin());
    c[0] += tolerance;
    const HigherTerms whole = boundHigherTerms(c.data(), degree, end);
    if (c[0] + std::min(0.0, c[1] * end) - whole.value >= 0.0) {
        return end;
    }
    // Rising, and the higher terms never eat up the rise: |c_2| s^2 + ... <= c_1 s for all s up to
    // end.
    if (c[0] >= 0.0 && c[1] * end >= whole.value) {
        return end;
    }
    if (c[0] < 0.0 || (c[0] == 0.0 && c[1] < 0.0)) {
        return 0.0;  // outside already: walk on
    }
    // The common case, an almost straight piece: monotone up to its root.
    if (c[1] < 0.0) {
        const double limit = std::min(end, 2.0 * c[0] / -c[1]);
        const bool falls = c[1] + boundHigherTerms(c.data(), degree, limit).derivative < 0.0;
        if (falls && evaluate(c.data(), degree, limit) < 0.0) {
            return rootOfFalling(c.data(), degree, limit);
        }
        if (falls && limit == end) {
            return end;
        }
    }
    return firstExitByIsolation(c.data(), degree, end);
}

CellExit firstExitOf(
    const ShellCell& cell,
    const PolynomialCurve& curve,
    double end,
    unsigned ignoredWalls,
    double tolerance
) {
    switch (curve.degree) {
        case 1:
            return firstExitOfLine(cell, curve, end, ignoredWalls, tolerance);
        case 2:
            return firstExitOfDegree<2>(cell, curve, end, ignoredWalls, tolerance);
        case 3:
            return firstExitOfDegree<3>(cell, curve, end, ignoredWalls, tolerance);
        default:
            return firstExitOfDegree<4>(cell, curve, end, ignoredWalls, tolerance);
    }
}

bool walkStraight(const Shell& shell, const Vec3& from, const Vec3& to, TraceState& state) {
    const PolynomialCurve line{.degree = 1, .coefficients = {from, to - from}};
    const auto ignore = [](const auto&...) {};
    return tracePolynomial(shell, line, 1.0, state, ignore, ignore);
}

}  // namespace bspline_curve
