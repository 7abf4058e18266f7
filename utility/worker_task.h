// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "utility/threads.h"

#include <cstddef>
#include <type_traits>
#include <utility>

namespace bspline_curve {

/// Fewer faces than this are not worth a second thread: starting one takes as long as validating
/// some hundred faces. Curves on 28,000 faces take an eighth to a fifth less with it.
inline constexpr std::size_t kFacesForTwoThreads = 24576;

[[nodiscard]] inline bool areWorthTwoThreads(std::size_t faceCount) {
    return kHasThreads && faceCount >= kFacesForTwoThreads;
}

/// Starts a task on a second thread. Throws std::system_error where none is to be had.
template <class Task>
[[nodiscard]] TaskResult<std::invoke_result_t<Task>> startBeside(Task task) {
#ifdef BSPLINE_CURVE_SINGLE_THREAD
    return TaskResult<std::invoke_result_t<Task>>(std::move(task));
#else
    return std::async(std::launch::async, std::move(task));
#endif
}

/// Starts a task over the faces of a mesh on a second thread where they are many (and a thread is
/// to be had); else it runs when its result is asked for. A result that is never asked for is
/// waited for, where its task has started.
template <class Task>
[[nodiscard]] TaskResult<std::invoke_result_t<Task>> startBeside(std::size_t faceCount, Task task) {
#ifdef BSPLINE_CURVE_SINGLE_THREAD
    static_cast<void>(faceCount);
    return startBeside(std::move(task));
#else
    const std::launch both = std::launch::async | std::launch::deferred;
    return std::async(
        areWorthTwoThreads(faceCount) ? both : std::launch::deferred, std::move(task)
    );
#endif
}

}  // namespace bspline_curve
