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

// Root of a function that falls from >= 0 at a to < 0 at b and is monotone between: Newton kept
// inside the bracket.
double bracketedRoot(const double* c, int degree, double a, double b) {
    std::array<double, kMaxPolynomialDegree + 1> d{};
    for (int j = 1; j <= degree; ++j) {
        d[static_cast<std::size_t>(j - 1)] = j * c[j];
    }
    double s = 0.5 * (a + b);
    for (int iteration = 0; iteration < 60; ++iteration) {
        const double value = evaluate(c, degree, s);
        if (value >= 0.0) {
            a = s;
        } else {
            b = s;
        }
        const double slope = evaluate(d.data(), degree - 1, s);
        double next = slope < 0.0 ? s - value / slope : a - 1.0;
        if (next <= a || next >= b) {
            next = 0.5 * (a + b);
        }
        if (std::abs(next - s) <= 1e-15 * b || b - a <= 1e-15 * b) {
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
        const double root = -c[0] / c[1];
        if (root > 0.0 && root < end) {
            roots[0] = root;
            return 1;
        }
        return 0;
    }
    std::array<double, kMaxPolynomialDegree + 1> d{};
    for (int j = 1; j <= degree; ++j) {
        d[static_cast<std::size_t>(j - 1)] = j * c[j];
    }
    std::array<double, kMaxPolynomialDegree + 2> breaks{};
    int count = signChanges(d.data(), degree - 1, end, breaks.data() + 1);
    breaks[0] = 0.0;
    breaks[static_cast<std::size_t>(++count)] = end;
    int found = 0;
    for (int i = 0; i < count; ++i) {
        const double a = breaks[static_cast<std::size_t>(i)];
        const double b = breaks[static_cast<std::size_t>(i) + 1];
        const double fa = evaluate(c, degree, a);
        const double fb = evaluate(c, degree, b);
        if (fa >= 0.0 && fb < 0.0) {
            roots[found++] = bracketedRoot(c, degree, a, b);
        } else if (fa < 0.0 && fb >= 0.0) {
            std::array<double, kMaxPolynomialDegree + 1> negative{};
            for (int j = 0; j <= degree; ++j) {
                negative[static_cast<std::size_t>(j)] = -c[j];
            }
            roots[found++] = bracketedRoot(negative.data(), degree, a, b);
        }
    }
    return found;
}

// Root of a polynomial that falls all the way from c[0] >= 0 to a negative value at `reach`:
// Newton, a handful of steps from the root of the tangent.
double rootOfFalling(const double* c, int degree, double reach) {
    constexpr int kMaxSteps = 8;
    double s = std::min(reach, c[0] / -c[1]);
    for (int step = 0; step < kMaxSteps; ++step) {
        double value = c[degree];
        double slope = 0.0;
        for (int j = degree; j-- > 0;) {
            slope = slope * s + value;
            value = value * s + c[j];
        }
        const double next = std::clamp(s - value / slope, 0.0, reach);
        if (std::abs(next - s) <= 1e-14 * reach) {
            return next;
        }
        s = next;
    }
    return bracketedRoot(c, degree, 0.0, reach);  // nearly a double root
}

// Slow but sure: the first sign change after which the polynomial is negative.
double firstExitByIsolation(const double* c, int degree, double end) {
    std::array<double, kMaxPolynomialDegree + 1> roots{};
    const int count = signChanges(c, degree, end, roots.data());
    for (int i = 0; i < count; ++i) {
        const double a = roots[static_cast<std::size_t>(i)];
        const double b = i + 1 < count ? roots[static_cast<std::size_t>(i) + 1] : end;
        if (evaluate(c, degree, 0.5 * (a + b)) < 0.0) {
            return a;
        }
    }
    return end;
}

}  // namespace

PolynomialCurve PolynomialCurve::shifted(double origin) const {
    PolynomialCurve result = *this;
    for (int i = 0; i < degree; ++i) {
        for (int j = degree; j-- > i;) {
            result.coefficients[static_cast<std::size_t>(j)] +=
                origin * result.coefficients[static_cast<std::size_t>(j) + 1];
        }
    }
    return result;
}

double firstExit(const double* coefficients, int degree, double end) {
    std::array<double, kMaxPolynomialDegree + 1> c{};
    std::copy(coefficients, coefficients + degree + 1, c.begin());
    c[0] += kCellTolerance;
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
        const double reach = std::min(end, 2.0 * c[0] / -c[1]);
        const bool falls = c[1] + boundHigherTerms(c.data(), degree, reach).derivative < 0.0;
        if (falls && evaluate(c.data(), degree, reach) < 0.0) {
            return rootOfFalling(c.data(), degree, reach);
        }
        if (falls && reach == end) {
            return end;
        }
    }
    return firstExitByIsolation(c.data(), degree, end);
}

CellExit firstExitOf(
    const ShellCell& cell, const PolynomialCurve& curve, double end, unsigned ignoredWalls
) {
    std::array<WallPolynomial, ShellCell::kMaxWalls> walls;
    int nearest = 0;
    double nearestExit = std::numeric_limits<double>::infinity();
    for (int k = 0; k < cell.wallCount; ++k) {
        WallPolynomial& wall = walls[static_cast<std::size_t>(k)];
        wall.set(cell.walls[static_cast<std::size_t>(k)], curve);
        const double linear = wall.linearExit();
        if (linear < nearestExit) {
            nearestExit = linear;
            nearest = k;
        }
    }
    // The wall that the tangent leaves by first bounds the search for the others.
    CellExit exit{end, -1};
    for (int i = 0; i < cell.wallCount; ++i) {
        const int k = nearest + i < cell.wallCount ? nearest + i : nearest + i - cell.wallCount;
        if ((ignoredWalls >> static_cast<unsigned>(k) & 1U) != 0) {
            continue;
        }
        const double candidate =
            firstExit(walls[static_cast<std::size_t>(k)].coefficients.data(), curve.degree, exit.s);
        if (candidate < exit.s) {
            exit = {candidate, k};
        }
    }
    return exit;
}

bool walkStraight(const Shell& shell, const Vec3& from, const Vec3& to, TraceState& state) {
    const PolynomialCurve line{.degree = 1, .coefficients = {from, to - from}};
    const auto ignore = [](const auto&...) {};
    return tracePolynomial(shell, line, 1.0, state, ignore, ignore);
}

}  // namespace bspline_curve
