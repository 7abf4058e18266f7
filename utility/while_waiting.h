// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "utility/go_on.h"
#include "utility/threads.h"

#include <utility>

#ifndef BSPLINE_CURVE_SINGLE_THREAD
#include <chrono>
#endif

namespace bspline_curve {

/// Runs a task that cannot report by itself, and calls `goOn` several times a second meanwhile. The
/// task is on a thread of its own, where one is to be had, and ends before this does, also where
/// `goOn` throws. Passes on what either throws.
template <class Task>
void whileWaiting(const GoOn& goOn, Task task) {
#ifdef BSPLINE_CURVE_SINGLE_THREAD
    task();
    goOn();
#else
    constexpr std::chrono::milliseconds kBetweenCalls(50);
    std::future<void> done =
        std::async(std::launch::async | std::launch::deferred, std::move(task));
    while (done.wait_for(kBetweenCalls) == std::future_status::timeout) {
        goOn();
    }
    done.get();
#endif
}

}  // namespace bspline_curve
