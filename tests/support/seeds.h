// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/random.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace bspline_curve::test_support {

/// Calls test(random) with the numbers of each seed from 1 to `count`. A failure names the seed.
template <class Test>
void forEachSeed(std::uint64_t count, const Test& test) {
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        test(random);
    }
}

/// The name of a case of a parametrised test.
inline constexpr auto nameOfParam = [](const auto& instance) { return instance.param.name; };

}  // namespace bspline_curve::test_support
