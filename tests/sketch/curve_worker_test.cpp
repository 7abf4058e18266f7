// SPDX-License-Identifier: GPL-3.0-or-later
#include "sketch/curve_worker.h"

#include "support/meshes.h"
#include "support/places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

namespace bspline_curve {
namespace {

using namespace test_support;

class AWorker : public testing::Test {
protected:
    [[nodiscard]] SolveRequest request(std::uint64_t id) const {
        return {id, onSurface(designer_->mesh(), kSpherePicks), {}, {}, {}, nullptr};
    }

    // The answers until all is done.
    std::vector<SolveAnswer> answers() {
        std::vector<SolveAnswer> all;
        while (true) {
            worker_.wait();
            std::vector<SolveAnswer> some = worker_.takeAnswers();
            if (some.empty()) {
                return all;
            }
            std::ranges::move(some, std::back_inserter(all));
        }
    }

    std::shared_ptr<const CurveDesigner> designer_ =
        std::make_shared<const CurveDesigner>(withNoise(icosphere(4), 0.003, 7));
    std::atomic<int> woken_ = 0;
    CurveWorker worker_{designer_, [this] { ++woken_; }};
};

TEST_F(AWorker, AnswersTheNewestLiveRequestAndAllOthersInTheirOrder) {
    worker_.askOthers({request(1), request(2), request(3)});
    for (std::uint64_t id = 10; id < 30; ++id) {
        worker_.askLive(request(id));
    }
    std::vector<std::uint64_t> live;
    std::vector<std::uint64_t> others;
    for (const SolveAnswer& answer : answers()) {
        (answer.id >= 10 ? live : others).push_back(answer.id);
        ASSERT_TRUE(answer.curve);
        EXPECT_EQ(answer.curve->polyline.points, designer_->design(answer.picks).polyline.points);
    }
    EXPECT_EQ(others, (std::vector<std::uint64_t>{1, 2, 3}));
    ASSERT_FALSE(live.empty());
    EXPECT_EQ(live.back(), 29U);
    EXPECT_TRUE(std::ranges::is_sorted(live));
    EXPECT_LE(live.size(), 20U);
    EXPECT_GE(woken_.load(), 1);
}

TEST_F(AWorker, ForgetsWhatIsNoLongerAskedFor) {
    constexpr std::uint64_t kMany = 200;
    std::vector<SolveRequest> many;
    for (std::uint64_t id = 100; id < 100 + kMany; ++id) {
        many.push_back(request(id));
    }
    worker_.askOthers(many);
    worker_.askOthers({request(3), request(4)});
    std::vector<std::uint64_t> ids;
    for (const SolveAnswer& answer : answers()) {
        ids.push_back(answer.id);
    }
    ASSERT_GE(ids.size(), 2U);
    EXPECT_LT(ids.size(), kMany);
    EXPECT_EQ(ids[ids.size() - 2], 3U);
    EXPECT_EQ(ids.back(), 4U);
    for (int i = 0; i < 20; ++i) {
        worker_.askLive(request(10));
        worker_.dropLive();
    }
    EXPECT_LT(answers().size(), 20U);
}

TEST_F(AWorker, SaysWhyThereIsNoCurveAndWhichPicksAreConcerned) {
    SolveRequest far = request(1);
    far.picks[2] *= 3.0;
    worker_.askLive(far);
    const std::vector<SolveAnswer> all = answers();
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].curve, nullptr);
    EXPECT_EQ(all[0].problem.picks, std::vector<int>{2});
    EXPECT_NE(all[0].problem.message.find("pick 3"), std::string::npos);
}

}  // namespace
}  // namespace bspline_curve
