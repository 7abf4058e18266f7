// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

namespace bspline_curve::cli {

/// One line on stderr that shows how far the work is. Shows nothing where stderr is not a terminal,
/// and nothing within the first moments, so that quick work does not flicker.
class ProgressBar {
public:
    ProgressBar();
    ~ProgressBar();  ///< clears the line
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// `fraction` in [0, 1].
    void show(double fraction, const std::string& stage);
    /// Removes the line, before other output to stderr.
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    bool isTerminal_;
    bool isShown_ = false;
    Clock::time_point next_;
};

}  // namespace bspline_curve::cli
