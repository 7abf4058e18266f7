// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/knot_insertion.h"

#include "problem_fixture.h"
#include "solver/paper/feature_knots.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bspline_curve {
namespace {

SplineSpace spaceOf(std::vector<double> breaks) {
    return {3, false, std::move(breaks)};
}

double shortestSpan(const std::vector<double>& breaks) {
    double shortest = 1.0;
    for (std::size_t i = 1; i < breaks.size(); ++i) {
        shortest = std::min(shortest, breaks[i] - breaks[i - 1]);
    }
    return shortest;
}

TEST(HalveLargest, HalvesTheSpansThatPromiseMostOfTheGain) {
    const SplineSpace space = spaceOf({0.0, 0.25, 0.5, 0.75, 1.0});
    EXPECT_EQ(
        halveLargest(space, {10.0, {0.3, 6.0, 0.2, 3.5}}, 1e-4),
        (std::vector<double>{0.0, 0.25, 0.375, 0.5, 0.75, 0.875, 1.0})
    );
    EXPECT_EQ(
        halveLargest(space, {10.0, {0.0, 10.0, 0.0, 0.0}}, 1e-4),
        (std::vector<double>{0.0, 0.25, 0.375, 0.5, 0.75, 1.0})
    );
}

TEST(HalveLargest, ChangesNothingWithoutGain) {
    const SplineSpace space = spaceOf({0.0, 0.25, 1.0});
    EXPECT_EQ(halveLargest(space, {0.0, {0.0, 0.0}}, 1e-4), space.breaks());
}

TEST(HalveLargest, MakesNoSpanShorterThanAllowed) {
    const SplineSpace space = spaceOf({0.0, 0.15, 1.0});
    EXPECT_EQ(
        halveLargest(space, {2.0, {1.0, 1.0}}, 0.1), (std::vector<double>{0.0, 0.15, 0.575, 1.0})
    );
    std::vector<double> breaks = {0.0, 1.0};
    for (int i = 0; i < 20; ++i) {
        const std::vector<double> gains(breaks.size() - 1, 1.0);
        breaks = halveLargest(spaceOf(breaks), {static_cast<double>(gains.size()), gains}, 0.01);
    }
    EXPECT_GE(shortestSpan(breaks), 0.01);
    EXPECT_GE(breaks.size(), 40U);
}

// (21), (22): as many knots as the span's feature has averages, rounded down.
TEST(InsertByFeature, InsertsAsManyKnotsAsTheFeatureHasAverages) {
    const SplineSpace space = spaceOf({0.0, 0.25, 0.5, 0.75, 1.0});
    EXPECT_EQ(
        insertByFeature(space, {{0.5, 5.0, 2.0, 0.5}, 8.0}, 1.0, 1e-4),
        (std::vector<double>{0.0, 0.25, 0.25 + 0.25 / 3.0, 0.25 + 0.5 / 3.0, 0.5, 0.625, 0.75, 1.0})
    );
}

TEST(InsertByFeature, InsertsMoreWithALargerRatio) {
    const SplineSpace space = spaceOf({0.0, 0.25, 0.5, 0.75, 1.0});
    const FeatureFunction feature{{0.5, 5.0, 2.0, 0.5}, 8.0};
    EXPECT_EQ(insertByFeature(space, feature, 2.0, 1e-4).size(), 5U + 5U + 2U);
    EXPECT_EQ(insertByFeature(space, feature, 0.3, 1e-4), space.breaks());
}

TEST(InsertByFeature, ChangesNothingWithoutFeature) {
    const SplineSpace space = spaceOf({0.0, 0.25, 1.0});
    EXPECT_EQ(insertByFeature(space, {{0.0, 0.0}, 0.0}, 1.0, 1e-4), space.breaks());
}

TEST(InsertByFeature, MakesNoSpanShorterThanAllowed) {
    std::vector<double> breaks = {0.0, 0.1, 0.2, 1.0};
    for (int i = 0; i < 20; ++i) {
        FeatureFunction feature{std::vector<double>(breaks.size() - 1, 0.1), 0.0};
        feature.perSpan[1] = 100.0;
        feature.total = 100.0 + 0.1 * static_cast<double>(breaks.size() - 2);
        const std::vector<double> finer = insertByFeature(spaceOf(breaks), feature, 1.0, 0.01);
        EXPECT_TRUE(std::includes(finer.begin(), finer.end(), breaks.begin(), breaks.end()));
        breaks = finer;
    }
    EXPECT_GE(shortestSpan(breaks), 0.01 * (1.0 - 1e-9));
}

TEST(FeatureFunction, IsZeroOnAPlane) {
    for (const double tension : {0.0, 0.4, 1.0}) {
        SolverOptions options;
        options.tension = tension;
        const test_support::ProblemFixture fixture(
            test_support::jitteredPlate(10, 10, 0.2, 3),
            {{0.1, 0.2, 0}, {0.5, 0.7, 0}, {0.9, 0.3, 0}},
            options
        );
        const SplineCurve curve = fitInitialPath(fixture.problem(), fixture.initialPath()).value();
        const FeatureFunction feature =
            featureFunction(fixture.problem(), curve.space, curve.controls, {10.0, 0.0, 1.0});
        EXPECT_LT(feature.total, 1e-18);
        EXPECT_EQ(static_cast<int>(feature.perSpan.size()), curve.space.spanCount());
    }
}

TEST(FeatureFunction, IsPositiveOnASphereAndTheSumOfItsSpans) {
    const test_support::ProblemFixture fixture(
        test_support::icosphere(3), {{1, 0.1, 0}, {0, 1, 0.2}, {-0.45, 0.2, 0.87}}, {}
    );
    const SplineCurve curve = fitInitialPath(fixture.problem(), fixture.initialPath()).value();
    const FeatureFunction feature =
        featureFunction(fixture.problem(), curve.space, curve.controls, {10.0, 0.0, 1.0});
    double sum = 0.0;
    for (const double value : feature.perSpan) {
        EXPECT_GT(value, 0.0);
        sum += value;
    }
    EXPECT_NEAR(feature.total, sum, 1e-12 * sum);
}

}  // namespace
}  // namespace bspline_curve
