// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace bspline_curve {

/// Numbers as bytes, little endian on every machine.
class ByteWriter {
public:
    template <std::integral Integer>
    void add(Integer value) {
        auto bits = static_cast<std::make_unsigned_t<Integer>>(value);
        for (std::size_t i = 0; i < sizeof(Integer); ++i) {
            bytes_.push_back(static_cast<char>(static_cast<unsigned char>(bits & 0xFFU)));
            // In two steps, since one byte cannot be shifted by eight bits.
            bits = static_cast<std::make_unsigned_t<Integer>>(bits >> 4U);
            bits = static_cast<std::make_unsigned_t<Integer>>(bits >> 4U);
        }
    }

    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }

    void add(const Vec3& p) {
        add(p[0]);
        add(p[1]);
        add(p[2]);
    }

    void add(std::string_view text) { bytes_.append(text); }

    template <class T>
    void addAll(const T& values) {
        for (const auto& value : values) {
            add(value);
        }
    }

    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

/// Reads them back. Whoever reads must know beforehand that enough is left.
class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

    [[nodiscard]] std::size_t left() const { return rest_.size(); }

    template <std::integral Integer>
    [[nodiscard]] Integer take() {
        std::make_unsigned_t<Integer> bits = 0;
        for (std::size_t i = 0; i < sizeof(Integer); ++i) {
            const auto byte = static_cast<unsigned char>(rest_[i]);
            bits = static_cast<std::make_unsigned_t<Integer>>(
                bits | static_cast<std::make_unsigned_t<Integer>>(byte) << (8U * i)
            );
        }
        rest_.remove_prefix(sizeof(Integer));
        return static_cast<Integer>(bits);
    }

    [[nodiscard]] Vec3 takePoint() {
        const double x = takeReal();
        const double y = takeReal();
        const double z = takeReal();
        return {x, y, z};
    }

    [[nodiscard]] double takeReal() { return std::bit_cast<double>(take<std::uint64_t>()); }

    [[nodiscard]] std::string_view takeText(std::size_t length) {
        const std::string_view text = rest_.substr(0, length);
        rest_.remove_prefix(length);
        return text;
    }

    template <std::integral Integer, std::size_t Count>
    void fill(std::array<Integer, Count>& values) {
        for (Integer& value : values) {
            value = take<Integer>();
        }
    }

    [[nodiscard]] std::vector<int> takeInts(std::size_t count) {
        std::vector<int> values(count);
        for (int& value : values) {
            value = take<std::int32_t>();
        }
        return values;
    }

private:
    std::string_view rest_;
};

/// 64-bit FNV-1a: one-to-one in each byte, so a single changed byte always shows.
[[nodiscard]] constexpr std::uint64_t checksumOf(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char byte : bytes) {
        hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
    }
    return hash;
}

}  // namespace bspline_curve
