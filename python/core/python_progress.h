// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"

#include <nanobind/nanobind.h>

#include <chrono>
#include <exception>
#include <utility>

namespace bspline_curve::python {

namespace nb = nanobind;

/// Runs work of the core without the lock of the interpreter. Now and then it takes the lock, calls
/// the user's progress function and looks whether the user interrupts; work that is shorter than
/// kLook never does.
class PythonProgress {
public:
    /// `callable`: called with a fraction and a stage; cancels where it returns False. None: none.
    explicit PythonProgress(nb::object callable) : callable_(std::move(callable)) {
        if (!callable_.is_none() && PyCallable_Check(callable_.ptr()) == 0) {
            throw nb::type_error("progress must be a function of a fraction and a stage, or None");
        }
    }

    /// The result of work(progress). Throws what work throws; in place of Cancelled, what the
    /// user's function or the interrupt raised.
    template <class Work>
    auto run(const Work& work) {
        const Progress progress = [this](double fraction, const char* stage) {
            return goesOn(fraction, stage);
        };
        try {
            const nb::gil_scoped_release unlocked;
            return work(progress);
        } catch (const Cancelled&) {
            if (raised_) {
                std::rethrow_exception(raised_);
            }
            throw;
        }
    }

private:
    using Clock = std::chrono::steady_clock;
    /// Between two looks: short for people, long beside taking the lock.
    static constexpr std::chrono::milliseconds kLook{30};

    [[nodiscard]] bool goesOn(double fraction, const char* stage);

    nb::object callable_;
    Clock::time_point next_ = Clock::now() + kLook;
    std::exception_ptr raised_;
};

}  // namespace bspline_curve::python
