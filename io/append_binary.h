// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstring>
#include <string>

namespace bspline_curve {

/// Appends the bytes of a number, little-endian.
template <class Number>
void appendBinary(std::string& bytes, Number value) {
    static_assert(std::endian::native == std::endian::little);
    std::array<char, sizeof value> copy{};
    std::memcpy(copy.data(), &value, sizeof value);
    bytes.append(copy.data(), copy.size());
}

}  // namespace bspline_curve
