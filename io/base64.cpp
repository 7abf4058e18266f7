// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/base64.h"

#include <cstddef>
#include <cstdint>

namespace bspline_curve {

namespace {

constexpr std::string_view kBase64Digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::string base64(std::string_view bytes) {
    constexpr std::uint32_t kLowSixBits = 0x3f;
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    // Three bytes at a time, missing ones as zeros, become four digits.
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) -> std::uint32_t {
            return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0;
        };
        const std::uint32_t group = byte(0) << 16 | byte(1) << 8 | byte(2);
        text += kBase64Digits[group >> 18];
        text += kBase64Digits[group >> 12 & kLowSixBits];
        text += i + 1 < bytes.size() ? kBase64Digits[group >> 6 & kLowSixBits] : '=';
        text += i + 2 < bytes.size() ? kBase64Digits[group & kLowSixBits] : '=';
    }
    return text;
}

std::optional<std::string> bytesOfBase64(std::string_view text) {
    constexpr std::uint32_t kLowByte = 0xff;
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3);
    std::uint32_t group = 0;
    std::size_t digits = 0;
    std::size_t padding = 0;
    for (const char c : text) {
        if (c == ' ' || (c >= '\t' && c <= '\r')) {
            continue;
        }
        const std::size_t digit = c == '=' ? 0 : kBase64Digits.find(c);
        padding += c == '=' ? 1 : 0;
        if (digit == std::string_view::npos || (padding > 0 && c != '=')) {
            return std::nullopt;
        }
        group = group << 6 | static_cast<std::uint32_t>(digit);
        if (++digits % 4 == 0) {
            bytes += static_cast<char>(group >> 16 & kLowByte);
            bytes += static_cast<char>(group >> 8 & kLowByte);
            bytes += static_cast<char>(group & kLowByte);
        }
    }
    if (digits % 4 != 0 || padding > 2) {
        return std::nullopt;
    }
    bytes.resize(bytes.size() - padding);
    return bytes;
}

}  // namespace bspline_curve
