// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

namespace bspline_curve::cli {

/// One line on stderr that shows how far the work is, and the lines of result on stdout. The bar
/// shows nothing where stderr is not a terminal, and nothing within the first moments, so that
/// quick work does not flicker.
class ProgressBar {
public:
    /// A quiet one prints nothing.
    explicit ProgressBar(bool isQuiet = false);
    ~ProgressBar();  ///< clears the line
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// `fraction` in [0, 1].
    void show(double fraction, const std::string& stage);
    /// Removes the line, before other output to stderr.
    void clear();

    /// A line of result: a file that was written, and what is in it. None of standard output, which
    /// has the file itself.
    void tell(const std::filesystem::path& file, const std::string& content);

private:
    using Clock = std::chrono::steady_clock;

    bool isQuiet_;
    bool isTerminal_;
    bool isShown_ = false;
    Clock::time_point next_;
};

}  // namespace bspline_curve::cli
