// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace bspline_curve {

/// Asks for memory that will be read soon, so that reads of places far apart wait at the same time.
/// A hint, which changes nothing but time; the address need not be valid.
inline void prefetch([[maybe_unused]] const void* address) {
#ifdef __GNUC__
    __builtin_prefetch(address);
#endif
}

}  // namespace bspline_curve
