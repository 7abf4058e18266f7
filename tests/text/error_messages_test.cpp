// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/error_messages.h"

#include "bspline_curve/error.h"

#include <gtest/gtest.h>

namespace bspline_curve {
namespace {

TEST(InputError, NamesAtMostFiveElementsAndCountsTheRest) {
    EXPECT_EQ(describeElements({}), "");
    EXPECT_EQ(describeElements({7}), "7");
    EXPECT_EQ(describeElements({3, 17, 20, 21, 25}), "3, 17, 20, 21, 25");
    EXPECT_EQ(describeElements({3, 17, 20, 21, 25, 26, 27}), "3, 17, 20, 21, 25 and 2 more");
}

TEST(ErrorMessages, CountPicksFromOne) {
    EXPECT_EQ(describePicks({0}), "pick 1");
    EXPECT_EQ(describePicks({0, 3, 4}), "picks 1, 4, 5");
    EXPECT_EQ(describePicks({0, 1, 2, 3, 4, 5}), "picks 1, 2, 3, 4, 5 and 1 more");
}

TEST(InputError, CountsInSingularAndPlural) {
    EXPECT_EQ(describeCount(1, "face", "faces"), "1 face");
    EXPECT_EQ(describeCount(17, "face", "faces"), "17 faces");
}

TEST(InputError, WritesNumbersWithFourSignificantDigits) {
    EXPECT_EQ(describeNumber(12.4), "12.4");
    EXPECT_EQ(describeNumber(1.0 / 3.0), "0.3333");
    EXPECT_EQ(describeNumber(-1.23456789e-7), "-1.235e-07");
    EXPECT_EQ(describeNumber(9999.96), "1e+04");
    EXPECT_EQ(describeNumber(12345.6), "12350");
    EXPECT_EQ(describeNumber(-123456789.0), "-123500000");
    EXPECT_EQ(describeNumber(1.5e12), "1.5e+12");
    EXPECT_EQ(describeLength(0.25), "0.25 mesh units");
}

TEST(InputError, CarriesCodeMessageAndAllElements) {
    const InputError error(InputErrorCode::PickTooFar, "too far", {1, 2, 3, 4, 5, 6});
    EXPECT_EQ(error.code(), InputErrorCode::PickTooFar);
    EXPECT_STREQ(error.what(), "too far");
    EXPECT_EQ(error.elements(), (std::vector<std::int64_t>{1, 2, 3, 4, 5, 6}));
}

}  // namespace
}  // namespace bspline_curve
