// SPDX-License-Identifier: GPL-3.0-or-later
#include "spline/spline_sections.h"

#include "bspline_curve/spline.h"
#include "spline/spline_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

namespace bspline_curve::design_tests {

namespace {

/// A chain of random sections over [from, from + 1], each with its space and controls.
struct RandomChain {
    std::vector<SplineSection> sections;
    std::vector<SplineSpace> spaces;
    std::vector<ControlPoints> controls;

    [[nodiscard]] Vec3 at(double t) const {
        std::size_t i = 0;
        while (i + 1 < sections.size() && t >= sections[i].to) {
            ++i;
        }
        const auto& [from, to, spline] = sections[i];
        return spaces[i].evaluate(controls[i], (t - from) / (to - from));
    }
};

RandomChain randomChain(int degree, bool closed, double from, int count, std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(0.2, 1.0);
    std::vector<double> bounds{0.0};
    for (int s = 0; s < count; ++s) {
        bounds.push_back(bounds.back() + uniform(random));
    }
    RandomChain chain;
    const auto randomPoint = [&] {
        return Vec3(uniform(random), uniform(random), uniform(random));
    };
    const Vec3 start = randomPoint();
    Vec3 corner = start;
    for (int s = 0; s < count; ++s) {
        std::vector<double> breaks{0.0};
        for (int i = 0; i < 1 + s; ++i) {  // the first has one span
            breaks.push_back(breaks.back() + uniform(random));
        }
        for (double& t : breaks) {
            t /= breaks.back();
        }
        SplineSpace space(degree, false, breaks);
        ControlPoints controls(space.controlCount(), 3);
        for (int i = 0; i < space.controlCount(); ++i) {
            controls.row(i) = randomPoint().transpose();
        }
        controls.row(0) = corner.transpose();
        const bool isBack = closed && s + 1 == count;
        corner = isBack ? start : Vec3(controls.row(space.controlCount() - 1).transpose());
        controls.row(space.controlCount() - 1) = corner.transpose();
        SplineSection section;
        section.from = s == 0 ? from : chain.sections.back().to;
        section.to = s + 1 == count ? from + 1.0 : from + bounds[s + 1] / bounds.back();
        section.spline.degree = degree;
        for (const double t : space.knotVector()) {
            section.spline.knots.push_back(
                t == 1.0 ? section.to : section.from + (section.to - section.from) * t
            );
        }
        for (int i = 0; i < space.controlCount(); ++i) {
            section.spline.controlPoints.emplace_back(controls.row(i).transpose());
        }
        chain.sections.push_back(section);
        chain.spaces.push_back(std::move(space));
        chain.controls.push_back(std::move(controls));
    }
    return chain;
}

/// By the recursive definition of the basis functions, term by term.
double basisOf(const std::vector<double>& knots, std::size_t i, int degree, double t) {
    if (degree == 0) {
        return knots[i] <= t && t < knots[i + 1] ? 1.0 : 0.0;
    }
    const auto p = static_cast<std::size_t>(degree);
    const auto term = [&](std::size_t from, double numerator, double denominator) {
        return denominator > 0.0 ? numerator / denominator * basisOf(knots, from, degree - 1, t)
                                 : 0.0;
    };
    return term(i, t - knots[i], knots[i + p] - knots[i]) +
           term(i + 1, knots[i + p + 1] - t, knots[i + p + 1] - knots[i + 1]);
}

Vec3 valueOf(const SplineData& spline, double t) {
    Vec3 point = Vec3::Zero();
    for (std::size_t i = 0; i < spline.controlPoints.size(); ++i) {
        point += basisOf(spline.knots, i, spline.degree, t) * spline.controlPoints[i];
    }
    return point;
}

struct Shape {
    bool closed;
    double from;
    int count;
};

constexpr Shape kShapes[] = {
    {.closed = false, .from = 0.0, .count = 1},
    {.closed = false, .from = 0.0, .count = 3},
    {.closed = true, .from = 0.0, .count = 1},
    {.closed = true, .from = 0.0, .count = 4},
    {.closed = true, .from = -0.07, .count = 1},
    {.closed = true, .from = -0.02, .count = 3},
};

class JoinedSplines : public testing::TestWithParam<int> {
protected:
    template <class Check>
    static void forEachShape(const Check& check) {
        std::mt19937 random(3);
        for (const auto& [closed, from, count] : kShapes) {
            SCOPED_TRACE(
                testing::Message() << "closed " << closed << ", from " << from << ", " << count
            );
            const RandomChain chain = randomChain(GetParam(), closed, from, count, random);
            check(chain, joinedSpline(chain.sections, closed));
        }
    }
};

TEST_P(JoinedSplines, AreTheSameCurve) {
    forEachShape([](const RandomChain& chain, const SplineData& joined) {
        const auto degree = static_cast<std::size_t>(joined.degree);
        ASSERT_EQ(joined.knots.size(), joined.controlPoints.size() + degree + 1);
        EXPECT_TRUE(std::ranges::is_sorted(joined.knots));
        EXPECT_EQ(joined.knots[degree], 0.0);
        EXPECT_EQ(joined.knots[joined.controlPoints.size()], 1.0);
        const double end = chain.sections.back().to;
        for (int i = 0; i < 200; ++i) {
            const double t = (i + 0.5) / 200.0;
            EXPECT_LT((valueOf(joined, t) - chain.at(t > end ? t - 1.0 : t)).norm(), 1e-13) << t;
        }
    });
}

TEST_P(JoinedSplines, HaveKnotsAtCornersWhoseMultiplicityIsTheDegree) {
    forEachShape([](const RandomChain& chain, const SplineData& joined) {
        for (std::size_t s = 0; s < chain.sections.size(); ++s) {
            double corner = chain.sections[s].from;
            if (!joined.closed && s == 0) {
                continue;
            }
            corner += corner < 0.0 ? 1.0 : 0.0;
            EXPECT_EQ(std::ranges::count(joined.knots, corner), joined.degree) << corner;
            EXPECT_LT((valueOf(joined, corner) - chain.at(chain.sections[s].from)).norm(), 1e-13);
        }
    });
}

TEST_P(JoinedSplines, ThatAreClosedRepeatTheirFirstControlPoints) {
    forEachShape([](const RandomChain&, const SplineData& joined) {
        const auto count = std::ssize(joined.controlPoints) - joined.degree;
        for (int i = 0; joined.closed && i < joined.degree; ++i) {
            EXPECT_EQ(joined.controlPoints[i], joined.controlPoints[count + i]);
        }
    });
}

TEST_P(JoinedSplines, ArePartedIntoTheirSectionsAgain) {
    forEachShape([](const RandomChain& chain, const SplineData& joined) {
        const std::vector<SplineSection> sections = sectionsOf(joined);
        ASSERT_EQ(sections.size(), chain.sections.size());
        for (std::size_t s = 0; s < sections.size(); ++s) {
            const auto& [from, to, spline] = sections[s];
            EXPECT_NEAR(from, chain.sections[s].from, 1e-15);
            EXPECT_NEAR(to, chain.sections[s].to, 1e-15);
            EXPECT_EQ(spline.knots.size(), spline.controlPoints.size() + spline.degree + 1);
            for (int i = 0; i < 50; ++i) {
                const double t = from + (to - from) * (i + 0.5) / 50.0;
                EXPECT_LT((valueOf(spline, t) - chain.at(t)).norm(), 1e-13) << t;
            }
        }
        EXPECT_EQ(joinedSpline(sections, joined.closed).knots.size(), joined.knots.size());
    });
}

TEST_P(JoinedSplines, AreTheSameCurveClamped) {
    forEachShape([](const RandomChain&, const SplineData& joined) {
        const SplineData result = clamped(joined);
        ASSERT_EQ(result.knots.size(), result.controlPoints.size() + result.degree + 1);
        EXPECT_EQ(std::ranges::count(result.knots, 0.0), result.degree + 1);
        EXPECT_EQ(std::ranges::count(result.knots, 1.0), result.degree + 1);
        for (int i = 0; i < 200; ++i) {
            const double t = i / 200.0;
            EXPECT_LT((valueOf(result, t) - valueOf(joined, t)).norm(), 1e-13) << t;
        }
    });
}

TEST_P(JoinedSplines, TellTheirCorners) {
    forEachShape([](const RandomChain& chain, SplineData joined) {
        std::vector<int> expected;
        joined.pickParameters = {0.0, 0.123};
        for (std::size_t s = 1; s < chain.sections.size(); ++s) {
            joined.pickParameters.push_back(chain.sections[s].from);
            expected.push_back(static_cast<int>(joined.pickParameters.size()) - 1);
        }
        if (joined.closed && chain.sections.front().from == 0.0) {
            expected.insert(expected.begin(), 0);
        }
        EXPECT_EQ(cornersOf(joined), expected);
    });
}

INSTANTIATE_TEST_SUITE_P(Degrees, JoinedSplines, testing::Values(2, 3, 4));

TEST(SplineSections, OfAClosedSplineWithoutCornersAreNone) {
    const SplineSpace space(3, true, {0.0, 0.2, 0.5, 0.6, 0.8, 1.0});
    SplineData spline;
    spline.closed = true;
    spline.knots = space.knotVector();
    spline.controlPoints.resize(8, Vec3::Zero());
    EXPECT_TRUE(sectionsOf(spline).empty());
}

}  // namespace

}  // namespace bspline_curve::design_tests
