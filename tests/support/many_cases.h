// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace bspline_curve::test_support {

/// Whether the build is about ten times slower than a release: with sanitizers, or not optimised.
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__)
inline constexpr bool kIsSlowBuild = false;
#else
inline constexpr bool kIsSlowBuild = true;
#endif

/// How many cases a test tries.
constexpr int caseCount(int fast, int slow) {
    return kIsSlowBuild ? slow : fast;
}

}  // namespace bspline_curve::test_support
