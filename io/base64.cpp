// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/base64.h"

#include <cstddef>
#include <cstdint>

namespace bspline_curve {

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    constexpr std::uint32_t kLowSixBits = 0x3f;
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    // Three bytes at a time, missing ones as zeros, become four digits.
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) -> std::uint32_t {
            return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0;
        };
        const std::uint32_t group = byte(0) << 16 | byte(1) << 8 | byte(2);
        text += kDigits[group >> 18];
        text += kDigits[group >> 12 & kLowSixBits];
        text += i + 1 < bytes.size() ? kDigits[group >> 6 & kLowSixBits] : '=';
        text += i + 2 < bytes.size() ? kDigits[group & kLowSixBits] : '=';
    }
    return text;
}

}  // namespace bspline_curve
