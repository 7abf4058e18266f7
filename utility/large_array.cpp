// SPDX-License-Identifier: GPL-3.0-or-later
#include "utility/large_array.h"

#ifdef __linux__
#include <sys/mman.h>

#include <memory>
#endif

namespace bspline_curve {

void preferLargePages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
    // What most processors have next to small pages. Only whole ones: neighbours in memory keep
    // what they have.
    constexpr std::size_t kLargePage = std::size_t{2} << 20U;
    void* page = begin;
    std::size_t room = bytes;
    if (std::align(kLargePage, kLargePage, page, room) != nullptr) {
        // Refused where the system has no large pages; small ones do as well.
        static_cast<void>(madvise(page, room / kLargePage * kLargePage, MADV_HUGEPAGE));
    }
#endif
}

}  // namespace bspline_curve
