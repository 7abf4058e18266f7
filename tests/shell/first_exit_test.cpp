// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/polynomial_trace.h"
#include "support/seeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using test_support::forEachSeed;
using test_support::Random;

double evaluate(const std::vector<double>& c, double s) {
    double value = 0.0;
    for (std::size_t j = c.size(); j-- > 0;) {
        value = value * s + c[j];
    }
    return value;
}

double exitOf(const std::vector<double>& c, double end) {
    return firstExit(c.data(), static_cast<int>(c.size()) - 1, end);
}

// (s - roots[0]) (s - roots[1]) ... times a factor.
std::vector<double> fromRoots(double factor, const std::vector<double>& roots) {
    std::vector<double> c = {factor};
    for (const double root : roots) {
        c.push_back(0.0);
        for (std::size_t j = c.size() - 1; j-- > 0;) {
            c[j + 1] += c[j];
            c[j] *= -root;
        }
    }
    return c;
}

// What firstExit promises, on a dense scan: not negative before, negative just after.
void expectFirstExit(const std::vector<double>& c, double end) {
    const double exit = exitOf(c, end);
    double scale = 0.0;
    double power = 1.0;
    for (const double coefficient : c) {
        scale += std::abs(coefficient) * power;
        power *= end;
    }
    const auto value = [&](double s) { return evaluate(c, s) + kCellTolerance; };
    ASSERT_GE(exit, 0.0);
    ASSERT_LE(exit, end);
    constexpr int kSamples = 4000;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kSamples; ++i) {
        least = std::min(least, value(exit * i / kSamples));
    }
    if (exit > 0.0) {
        EXPECT_GE(least, -1e-14 * scale) << "exit " << exit << " of " << end;
    }
    if (exit < end) {
        EXPECT_NEAR(
            exit > 0.0 ? value(exit) : std::min(value(0.0), 0.0),
            std::min(value(0.0), 0.0),
            1e-13 * scale
        );
        const double after = exit + 1e-4 * (end - exit);
        EXPECT_LT(value(after), 1e-13 * scale) << "exit " << exit << " of " << end;
    }
}

TEST(FirstExit, IsThatOfADenseScan) {
    forEachSeed(4000, [&](Random& random) {
        const int degree = random.integer(1, 4);
        std::vector<double> c;
        for (int j = 0; j <= degree; ++j) {
            c.push_back(std::pow(10.0, random.uniform(-3.0, 1.0)) * random.uniform(-1.0, 1.0));
        }
        c[0] = std::abs(c[0]);
        expectFirstExit(c, random.uniform(0.01, 3.0));
    });
}

TEST(FirstExit, FindsKnownRoots) {
    forEachSeed(4000, [&](Random& random) {
        std::vector<double> roots;
        double first = std::numeric_limits<double>::infinity();
        for (int j = random.integer(1, 4); j > 0; --j) {
            roots.push_back(random.uniform(-1.0, 2.0));
            if (roots.back() > 0.0) {
                first = std::min(first, roots.back());
            }
        }
        std::vector<double> c = fromRoots(random.uniform(0.1, 10.0), roots);
        if (c[0] < 0.0) {
            for (double& coefficient : c) {
                coefficient = -coefficient;
            }
        }
        double gap = 1.0;
        for (const double root : roots) {
            gap = root == first ? gap : std::min(gap, std::abs(root - first));
        }
        if (gap > 1e-2 && first > 1e-2) {
            c[0] -= kCellTolerance;
            EXPECT_NEAR(exitOf(c, 1.0), std::min(first, 1.0), 1e-9);
        }
    });
}

// Curves that touch a wall from inside stay inside, up to rounding, and leave where they cross.
TEST(FirstExit, PassesDoubleRootsThatOnlyTouch) {
    forEachSeed(1000, [&](Random& random) {
        const double touch = random.uniform(0.1, 0.4);
        const double exit = random.uniform(0.6, 0.9);
        for (std::vector<double> c :
             {fromRoots(-1.0, {touch, touch, exit}), fromRoots(-1.0, {touch, touch, exit, -1.0})}) {
            EXPECT_NEAR(exitOf(c, 1.0), exit, 1e-8);  // with the tolerance as margin
            c[0] -= kCellTolerance;                   // and without it
            const double bare = exitOf(c, 1.0);
            EXPECT_TRUE(std::abs(bare - exit) < 1e-8 || std::abs(bare - touch) < 1e-6) << bare;
        }
        EXPECT_EQ(exitOf(fromRoots(1.0, {touch, touch}), 1.0), 1.0);
        EXPECT_EQ(exitOf(fromRoots(1.0, {touch, touch, exit, exit}), 1.0), 1.0);
        // Just deep enough to count.
        std::vector<double> c = fromRoots(1.0, {touch, touch});
        c[0] -= 1e-6;
        EXPECT_NEAR(exitOf(c, 1.0), touch - std::sqrt(1e-6 - kCellTolerance), 1e-9);
    });
}

TEST(FirstExit, IsWhereATripleRootCrosses) {
    const std::vector<double> c = fromRoots(-1.0, {0.5, 0.5, 0.5});
    EXPECT_NEAR(exitOf(c, 1.0), 0.5 + std::cbrt(kCellTolerance), 1e-6);
}

TEST(FirstExit, IsZeroOutside) {
    EXPECT_EQ(exitOf({-1.0, 3.0}, 1.0), 0.0);
    EXPECT_EQ(exitOf({-1.0, 0.0, 3.0}, 1.0), 0.0);
    EXPECT_EQ(exitOf({-2.0 * kCellTolerance, -1.0}, 1.0), 0.0);
}

TEST(FirstExit, IsTheEndForCurvesThatStay) {
    EXPECT_EQ(exitOf({1.0, 0.0}, 2.0), 2.0);
    EXPECT_EQ(exitOf({0.0, 0.0, 0.0, 0.0}, 2.0), 2.0);
    EXPECT_EQ(exitOf({1.0, -1.0}, 0.5), 0.5);
    EXPECT_EQ(exitOf({0.1, -1.0, 3.0}, 1.0), 1.0);
    EXPECT_EQ(exitOf({0.0, 1.0, 0.0, 0.0, 0.0}, 1.0), 1.0);
}

// Exactly on the edge of the tolerance.
TEST(FirstExit, LeavesAtOnceWhereTheMarginIsUsedUp) {
    for (const int degree : {1, 2, 3, 4}) {
        std::vector<double> c(degree + 1, 0.0);
        c[0] = -kCellTolerance;
        c[1] = -1.0;
        EXPECT_EQ(exitOf(c, 1.0), 0.0) << "degree " << degree;
        c[1] = 1.0;
        EXPECT_EQ(exitOf(c, 1.0), 1.0) << "degree " << degree;
    }
}

}  // namespace
}  // namespace bspline_curve
