// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress_bar.h"

#include "text/text_parsing.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>

namespace bspline_curve::cli {

namespace {

constexpr std::chrono::milliseconds kDelay{200};
constexpr std::chrono::milliseconds kInterval{50};
constexpr std::size_t kWidth = 30;

}  // namespace

ProgressBar::ProgressBar(bool isQuiet)
    : isQuiet_(isQuiet),
      isTerminal_(!isQuiet && ::isatty(STDERR_FILENO) != 0),
      next_(Clock::now() + kDelay) {}

ProgressBar::~ProgressBar() {
    clear();
}

void ProgressBar::show(double fraction, const std::string& stage) {
    const Clock::time_point now = Clock::now();
    if (!isTerminal_ || now < next_) {
        return;
    }
    next_ = now + kInterval;
    const double share = std::clamp(fraction, 0.0, 1.0);
    const auto filled = static_cast<std::size_t>(std::lround(share * static_cast<double>(kWidth)));
    std::cerr << "\r[" << std::string(filled, '#') << std::string(kWidth - filled, '.') << "] "
              << std::lround(share * 100.0) << " % " << stage << "\x1b[K" << std::flush;
    isShown_ = true;
}

void ProgressBar::clear() {
    if (isShown_) {
        std::cerr << "\r\x1b[K" << std::flush;
        isShown_ = false;
    }
}

void ProgressBar::tell(const std::filesystem::path& file, const std::string& content) {
    if (!isQuiet_ && !isStandardStream(file)) {
        clear();
        std::cout << file.string() << ": " << content << '\n';
    }
}

}  // namespace bspline_curve::cli
