// SPDX-License-Identifier: GPL-3.0-or-later
#include "utility/while_waiting.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace bspline_curve {

namespace {

#ifndef BSPLINE_CURVE_SINGLE_THREAD

TEST(WhileWaiting, ReportsUntilTheTaskEnds) {
    std::promise<void> hasReported;
    int reports = 0;
    whileWaiting(
        [&] {
            if (++reports == 3) {
                hasReported.set_value();
            }
        },
        [&] { hasReported.get_future().wait(); }
    );
    EXPECT_GE(reports, 3);
}

TEST(WhileWaiting, EndsAfterItsTaskWhereAReportThrows) {
    bool hasEnded = false;
    std::promise<void> hasReported;
    const auto goOn = [&] {
        hasReported.set_value();
        throw std::runtime_error("cancelled");
    };
    const auto task = [&] {
        hasReported.get_future().wait();
        hasEnded = true;
    };
    EXPECT_THROW(whileWaiting(goOn, task), std::runtime_error);
    EXPECT_TRUE(hasEnded);
}

#endif

TEST(WhileWaiting, PassesOnWhatTheTaskThrows) {
    EXPECT_THROW(whileWaiting([] {}, [] { throw std::logic_error("task"); }), std::logic_error);
}

}  // namespace

}  // namespace bspline_curve
