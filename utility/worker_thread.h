// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "utility/threads.h"

#include <atomic>
#include <exception>

namespace bspline_curve {

/// A second thread for as long as this lives, for loops too short to start a thread for each: from
/// about 20 us. Between loops it looks out for the next one for a fraction of a millisecond, giving
/// way to whoever wants the core, and then sleeps. The caller never waits for it to wake: a loop
/// that it comes too late for is the caller's alone, so where no core is free, or no thread to be
/// had, little is lost.
///
/// (OpenMP keeps its threads for as long as the process runs, and its loops then hang in forked
/// children, as of Python's multiprocessing.)
class WorkerThread {
public:
    WorkerThread();
    ~WorkerThread();
    WorkerThread(const WorkerThread&) = delete;
    WorkerThread& operator=(const WorkerThread&) = delete;

    /// Calls task(i) for all i in [0, count), on both threads at once, so many after each other on
    /// one of them; returns when all are done. From one thread at a time, and not from a task.
    /// Throws what a task throws, one of these where both threads' do; what is left then is left
    /// out.
    template <class Task>
    void forEach(int count, int atOnce, const Task& task) {
        const auto call = [](const void* context, int i) {
            (*static_cast<const Task*>(context))(i);
        };
        run({count, atOnce, call, &task});
    }

private:
    struct Loop {
        int count = 0;
        int atOnce = 1;
        void (*call)(const void* context, int i) = nullptr;
        const void* context = nullptr;
    };

    enum class State : int {
        Idle,    // no loop, or one that the caller has closed
        Open,    // a loop that the thread may join
        Joined,  // a loop that it works at
        End
    };

    void run(const Loop& loop);
    std::exception_ptr work();
    void serve();

    Loop loop_;
    std::atomic<int> next_ = 0;  // of the loop, to be called
    std::atomic<State> state_ = State::Idle;
    std::exception_ptr error_;  // of the thread
    Thread thread_;             // last: it uses the others
};

/// The same on one thread where there is no second.
template <class Task>
void forEach(WorkerThread* side, int count, int atOnce, const Task& task) {
    if (side != nullptr) {
        side->forEach(count, atOnce, task);
        return;
    }
    for (int i = 0; i < count; ++i) {
        task(i);
    }
}

}  // namespace bspline_curve
