// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/process_figures.h"

#include <sys/resource.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <ctime>
#include <fstream>
#include <string>

namespace bspline_curve::cli {

double processCpuSeconds() {
    std::timespec time{};
    static_cast<void>(::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time));
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::int64_t peakMemoryBytes() {
    // Linux keeps the ru_maxrss of the program that started this one, across fork and exec; a
    // large Python would be counted. VmHWM is this program's own.
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        if (word == "VmHWM:") {
            std::int64_t kilobytes = 0;
            status >> kilobytes;
            return kilobytes * kKilobyte;
        }
    }
    rusage usage{};
    static_cast<void>(::getrusage(RUSAGE_SELF, &usage));
    return static_cast<std::int64_t>(usage.ru_maxrss) * kKilobyte;
}

void returnLargeArrays() {
#ifdef __GLIBC__
    constexpr int kLarge = 1 << 20;  // bytes; the default grows with what is freed
    static_cast<void>(::mallopt(M_MMAP_THRESHOLD, kLarge));
#endif
}

}  // namespace bspline_curve::cli
