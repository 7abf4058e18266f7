// SPDX-License-Identifier: GPL-3.0-or-later
// Values that are given, and what every kind of field can have done to its values.
#include "field/make_field.h"
#include "field/value_range.h"
#include "support/meshes.h"
#include "support/random.h"
#include "support/refusal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace bspline_curve {
namespace {

using namespace test_support;

std::vector<double> ramp(std::size_t count) {
    std::vector<double> values(count);
    std::iota(values.begin(), values.end(), 0.0);
    return values;
}

TEST(ValueRange, NormalisesBetweenQuantiles) {
    std::vector<double> values = ramp(101);  // quantiles 1 and 99
    values[50] = 1e9;                        // then 100 is at 99 %
    normalise(values);
    EXPECT_DOUBLE_EQ(values[1], 0.0);
    EXPECT_DOUBLE_EQ(values[0], 0.0);
    EXPECT_DOUBLE_EQ(values[100], 1.0);
    EXPECT_DOUBLE_EQ(values[50], 1.0);
    EXPECT_DOUBLE_EQ(values[34], 33.0 / 99.0);
}

TEST(ValueRange, NormalisesWhatHasHardlyAnyOtherValue) {
    std::vector<double> values(1000, 3.0);
    normalise(values);
    EXPECT_EQ(values, std::vector<double>(1000, 0.0));
    values[7] = -2.0;
    normalise(values);
    EXPECT_EQ(values[7], 0.0);
    EXPECT_EQ(values[8], 1.0);
    std::vector<double> one = {5.0};
    normalise(one);
    EXPECT_EQ(one[0], 0.0);
    std::vector<double> none;
    normalise(none);
    invert(none);
    EXPECT_TRUE(none.empty());
}

TEST(ValueRange, InvertsWithinTheRange) {
    std::vector<double> values = {-1.0, 0.5, 4.0};
    invert(values);
    EXPECT_EQ(values, (std::vector<double>{4.0, 2.5, -1.0}));
}

class QualityField : public ::testing::Test {
protected:
    [[nodiscard]] std::vector<double> made(const std::vector<double>& quality) const {
        return makeField(surface_, options_, {.quality = quality}).values();
    }

    void expectNone(const std::vector<double>& quality, const std::string& said) const {
        expectRefused([&] { return made(quality); }, InputErrorCode::BadField, said);
    }

    Surface surface_{plate(20, 20)};
    FieldOptions options_{.kind = FieldKind::Quality};
};

TEST_F(QualityField, IsWhatWasGiven) {
    const auto quality = ramp(441);
    EXPECT_EQ(made(quality), quality);
    EXPECT_EQ(naturalCost(FieldKind::Quality), FieldCost::Identity);
}

TEST_F(QualityField, IsSmoothedThenNormalisedThenInverted) {
    const auto quality = ramp(441);  // grows along y, and a little along x
    options_.inverted = true;
    EXPECT_EQ(made(quality)[0], 440.0);
    options_.normalised = true;
    auto values = made(quality);
    EXPECT_EQ(values.front(), 1.0);
    EXPECT_EQ(values.back(), 0.0);
    EXPECT_NEAR(values[220], 0.5, 1e-12);
    options_.smoothing = 0.02;
    values = made(quality);
    EXPECT_EQ(values.front(), 1.0);
    EXPECT_EQ(values.back(), 0.0);
    EXPECT_NEAR(values[220], 0.5, 1e-3);
}

// Noise of variance 1/3 at every vertex, averaged over the 9 or so within a radius of 1.8 cells.
TEST_F(QualityField, SmoothingTakesNoiseAway) {
    Random random(1);
    std::vector<double> noise(441);
    std::ranges::generate(noise, [&] { return random.uniform(-1.0, 1.0); });
    const auto energy = [](const std::vector<double>& values) {
        return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
    };
    options_.smoothing = 0.09 / std::sqrt(2.0);
    const auto smooth = made(noise);
    EXPECT_LT(energy(smooth), 0.25 * energy(noise));
    EXPECT_GT(energy(smooth), 0.0);
    options_.smoothing = 0.0;
    EXPECT_EQ(made(noise), noise);
}

// No rounding below what there was, on which a cost like x^2 would be wrong.
TEST_F(QualityField, SmoothingStaysWithinTheRange) {
    std::vector<double> spike(441, 0.0);
    spike[220] = 1.0;
    options_.smoothing = 0.05;
    const auto smooth = made(spike);
    EXPECT_GE(*std::ranges::min_element(smooth), 0.0);
    EXPECT_LT(*std::ranges::max_element(smooth), 0.7);
}

TEST_F(QualityField, RefusesWhatIsNoValuePerVertex) {
    expectNone({}, "the quality has 0 values, the mesh 441 vertices");
    expectNone(ramp(440), "the quality has 440 values");
    auto bad = ramp(441);
    bad[3] = std::numeric_limits<double>::quiet_NaN();
    bad[17] = std::numeric_limits<double>::infinity();
    expectNone(bad, "2 values of the quality are not finite (vertices 3, 17)");
}

TEST(FieldKinds, HaveNamesOfTheirOwn) {
    std::vector<std::string> names;
    for (const FieldKind kind : kFieldKinds) {
        names.emplace_back(name(kind));
    }
    std::ranges::sort(names);
    EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
    EXPECT_EQ(naturalCost(FieldKind::MaximalCurvature), FieldCost::ExpMinus);  // (25)
    EXPECT_EQ(naturalCost(FieldKind::NormalVariation), FieldCost::Square);     // after (24)
}

}  // namespace
}  // namespace bspline_curve
