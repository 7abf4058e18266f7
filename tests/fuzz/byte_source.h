// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace bspline_curve::fuzz {

/// Draws numbers from bytes; after the last byte they are the smallest of their range.
class ByteSource {
public:
    explicit ByteSource(std::string_view bytes) : rest_(bytes) {}

    [[nodiscard]] unsigned byte() {
        if (rest_.empty()) {
            return 0;
        }
        const auto value = static_cast<unsigned char>(rest_.front());
        rest_.remove_prefix(1);
        return value;
    }

    /// In [least, largest], whose difference is at most 65,535.
    [[nodiscard]] int integer(int least, int largest) {
        const auto count = static_cast<unsigned>(largest - least) + 1;
        unsigned value = byte();
        if (count > 256) {
            value = value * 256 + byte();
        }
        return least + static_cast<int>(value % count);
    }

    /// In [0, 1], in steps of 1/255.
    [[nodiscard]] double unit() { return static_cast<double>(byte()) / 255.0; }

    /// One chance in `count`.
    [[nodiscard]] bool oneIn(int count) { return integer(1, count) == count; }

private:
    std::string_view rest_;
};

}  // namespace bspline_curve::fuzz
