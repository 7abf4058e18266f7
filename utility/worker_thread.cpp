// SPDX-License-Identifier: GPL-3.0-or-later
#include "utility/worker_thread.h"

#include <algorithm>
#include <utility>

namespace bspline_curve {
namespace {

// So often the thread gives way before it sleeps: for about 0.2 ms, more than most of the time
// between two loops of one curve. Waking takes 0.05 ms.
constexpr int kMaxYields = 1000;

}  // namespace

// Where no thread is to be had, loops are the caller's alone.
WorkerThread::WorkerThread() : thread_(startThread([this] { serve(); })) {}

WorkerThread::~WorkerThread() {
    state_.store(State::End, std::memory_order_release);
    state_.notify_one();
    if (thread_.joinable()) {
        thread_.join();
    }
}

void WorkerThread::run(const Loop& loop) {
    loop_ = loop;
    next_.store(0, std::memory_order_relaxed);
    state_.store(State::Open, std::memory_order_release);
    state_.notify_one();
    const std::exception_ptr error = work();
    State expected = State::Open;
    if (!state_.compare_exchange_strong(expected, State::Idle, std::memory_order_acq_rel)) {
        while (state_.load(std::memory_order_acquire) != State::Idle) {
            giveWay();
        }
    }
    const std::exception_ptr other = std::exchange(error_, nullptr);
    if (error || other) {
        std::rethrow_exception(error ? error : other);
    }
}

// Returns what a task throws, and leaves the rest of the loop out then.
std::exception_ptr WorkerThread::work() {
    const Loop loop = loop_;
    try {
        while (true) {
            const int begin = next_.fetch_add(loop.atOnce, std::memory_order_relaxed);
            if (begin >= loop.count) {
                return nullptr;
            }
            const int end = std::min(begin + loop.atOnce, loop.count);
            for (int i = begin; i < end; ++i) {
                loop.call(loop.context, i);
            }
        }
    } catch (...) {
        next_.store(loop.count, std::memory_order_relaxed);
        return std::current_exception();
    }
}

void WorkerThread::serve() {
    while (true) {
        int yields = 0;
        while (state_.load(std::memory_order_acquire) == State::Idle) {
            if (++yields < kMaxYields) {
                giveWay();
            } else {
                state_.wait(State::Idle, std::memory_order_acquire);
            }
        }
        State expected = State::Open;
        if (state_.compare_exchange_strong(expected, State::Joined, std::memory_order_acq_rel)) {
            error_ = work();
            state_.store(State::Idle, std::memory_order_release);
        } else if (expected == State::End) {
            return;
        }
    }
}

}  // namespace bspline_curve
