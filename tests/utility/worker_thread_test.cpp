// SPDX-License-Identifier: GPL-3.0-or-later
// Loops shared by two threads.
#include "utility/worker_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace bspline_curve {
namespace {

using namespace std::chrono_literals;

std::vector<int> callsOf(WorkerThread* worker, int count, int atOnce) {
    std::vector<int> calls(count);
    forEach(worker, count, atOnce, [&](int i) { ++calls[i]; });
    return calls;
}

// The threads that tasks ran on which leave the other one time to wake.
std::set<std::thread::id> threadsOf(WorkerThread& worker) {
    constexpr int kTasks = 200;
    std::vector<std::thread::id> ids(kTasks);
    worker.forEach(kTasks, 1, [&](int i) {
        ids[i] = std::this_thread::get_id();
        std::this_thread::sleep_for(1ms);
    });
    return {ids.begin(), ids.end()};
}

TEST(WorkerThread, CallsForEachIndexOnce) {
    WorkerThread worker;
    for (const int count : {0, 1, 2, 7, 1000}) {
        for (const int atOnce : {1, 3, 2000}) {
            const std::vector<int> once(count, 1);
            EXPECT_EQ(callsOf(&worker, count, atOnce), once);
            EXPECT_EQ(callsOf(nullptr, count, atOnce), once);
        }
    }
}

// Many short loops one after the other: the thread comes in time for some and too late for others.
TEST(WorkerThread, HasDoneAllWhenALoopEnds) {
    WorkerThread worker;
    constexpr int kCount = 64;
    std::vector<int> values(kCount, 0);
    for (int loop = 1; loop <= 20000; ++loop) {
        worker.forEach(kCount, 4, [&](int i) { values[i] += i; });
        const std::size_t some = static_cast<std::size_t>(loop) % kCount;
        ASSERT_EQ(values[some], loop * static_cast<int>(some));
    }
}

TEST(WorkerThread, SharesALoopWithTheCaller) {
    WorkerThread worker;
    const std::set<std::thread::id> threads = threadsOf(worker);
    EXPECT_EQ(threads.size(), 2U);
    EXPECT_EQ(threads.count(std::this_thread::get_id()), 1U);
}

TEST(WorkerThread, WakesForALoopAfterARest) {
    WorkerThread worker;
    std::this_thread::sleep_for(50ms);
    EXPECT_EQ(threadsOf(worker).size(), 2U);
    std::this_thread::sleep_for(50ms);
    EXPECT_EQ(threadsOf(worker).size(), 2U);
}

TEST(WorkerThread, ThrowsWhatATaskThrowsOnEitherThread) {
    WorkerThread worker;
    const std::thread::id caller = std::this_thread::get_id();
    for (const bool byCaller : {true, false}) {
        const auto task = [&](int) {
            if ((std::this_thread::get_id() == caller) == byCaller) {
                throw std::runtime_error("a task");
            }
            std::this_thread::sleep_for(1ms);
        };
        EXPECT_THROW(worker.forEach(1000, 1, task), std::runtime_error);
        EXPECT_EQ(callsOf(&worker, 100, 1), std::vector<int>(100, 1));
    }
}

TEST(WorkerThread, LeavesOutWhatComesAfterAThrow) {
    WorkerThread worker;
    std::atomic<int> calls = 0;
    const auto task = [&](int) {
        ++calls;
        throw std::runtime_error("a task");
    };
    EXPECT_THROW(worker.forEach(1000, 1, task), std::runtime_error);
    EXPECT_LE(calls, 2);
}

}  // namespace
}  // namespace bspline_curve
