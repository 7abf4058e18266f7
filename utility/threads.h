// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one place that knows whether there are threads: all that starts one or locks goes through
// here. BSPLINE_CURVE_SINGLE_THREAD (of the CMake option BSPLINE_CURVE_THREADS) is for platforms
// without, as WebAssembly in one worker: nothing is started then, and locks do nothing.

#ifdef BSPLINE_CURVE_SINGLE_THREAD
#include <functional>
#include <utility>
#else
#include <condition_variable>
#include <future>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#endif

namespace bspline_curve {

#ifdef BSPLINE_CURVE_SINGLE_THREAD

inline constexpr bool kHasThreads = false;

class Mutex {};

class MutexLock {
public:
    explicit MutexLock(Mutex& /*mutex*/) {}

    // NOLINTNEXTLINE(modernize-use-equals-default): one that does something needs no
    // [[maybe_unused]]
    ~MutexLock() {}

    MutexLock(const MutexLock&) = delete;
    MutexLock& operator=(const MutexLock&) = delete;

    void lock() {}

    void unlock() {}
};

/// Nobody else can make true what is waited for: no wait waits.
class Condition {
public:
    void notifyAll() {}

    template <class IsTrue>
    void wait(MutexLock& /*lock*/, const IsTrue& /*isTrue*/) {}

    template <class Time, class IsTrue>
    [[nodiscard]] bool waitUntil(MutexLock& /*lock*/, const Time& /*end*/, const IsTrue& isTrue) {
        return isTrue();
    }
};

class Thread {
public:
    [[nodiscard]] bool joinable() const { return false; }

    void join() {}
};

template <class Serve>
[[nodiscard]] Thread startThread(const Serve& /*serve*/) {
    return {};
}

inline void giveWay() {}

/// What a task gives, which runs when it is asked for.
template <class Result>
class TaskResult {
public:
    TaskResult() = default;

    explicit TaskResult(std::function<Result()> task) : task_(std::move(task)) {}

    [[nodiscard]] Result get() { return std::exchange(task_, nullptr)(); }

private:
    std::function<Result()> task_;
};

template <>
inline void TaskResult<void>::get() {
    std::exchange(task_, nullptr)();
}

#else

inline constexpr bool kHasThreads = true;

using Mutex = std::mutex;
using MutexLock = std::unique_lock<std::mutex>;

class Condition {
public:
    void notifyAll() { condition_.notify_all(); }

    template <class IsTrue>
    void wait(MutexLock& lock, const IsTrue& isTrue) {
        condition_.wait(lock, isTrue);
    }

    /// Whether it is true, at the latest then.
    template <class Time, class IsTrue>
    [[nodiscard]] bool waitUntil(MutexLock& lock, const Time& end, const IsTrue& isTrue) {
        return condition_.wait_until(lock, end, isTrue);
    }

private:
    std::condition_variable condition_;
};

using Thread = std::thread;

/// A thread that calls `serve`; none, which cannot be joined, where no more are to be had.
template <class Serve>
[[nodiscard]] Thread startThread(Serve serve) {
    try {
        return Thread(std::move(serve));
    } catch (const std::system_error&) {
        return {};
    }
}

inline void giveWay() {
    std::this_thread::yield();
}

template <class Result>
using TaskResult = std::future<Result>;

#endif

}  // namespace bspline_curve
