// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/ply_header.h"
#include "text/text_parsing.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string_view>

namespace bspline_curve {

/// Runs over the numbers of the data part of a PLY file. Where one is missing or is not a number,
/// `failed` stays true.
class PlyCursor {
public:
    PlyCursor(std::string_view data, PlyFormat format) : all_(data), data_(data), format_(format) {}

    [[nodiscard]] bool failed() const { return failed_; }

    /// Throws InputError (UnreadableFile) that says at which element it failed: the word of a text
    /// that is no number, with its line, or where the data end.
    [[noreturn]] void refuse(
        const std::filesystem::path& file,
        const PlyHeader& header,
        const PlyElement& element,
        std::size_t index
    ) const;

    /// Many scalars at once, without looking at them; binary only.
    void skipBytes(std::size_t count) { static_cast<void>(take(count)); }

    [[nodiscard]] std::size_t bytesLeft() const { return data_.size(); }

    double number(PlyScalar type) {
        if (format_ == PlyFormat::Ascii) {
            return asciiNumber(type);
        }
        switch (type) {
            case PlyScalar::None:
                return 0.0;
            case PlyScalar::Int8:
                return binaryNumber<std::int8_t>();
            case PlyScalar::UInt8:
                return binaryNumber<std::uint8_t>();
            case PlyScalar::Int16:
                return binaryNumber<std::int16_t>();
            case PlyScalar::UInt16:
                return binaryNumber<std::uint16_t>();
            case PlyScalar::Int32:
                return binaryNumber<std::int32_t>();
            case PlyScalar::UInt32:
                return binaryNumber<std::uint32_t>();
            case PlyScalar::Float:
                return static_cast<double>(binaryNumber<float>());
            case PlyScalar::Double:
                return binaryNumber<double>();
        }
        return 0.0;
    }

private:
    double asciiNumber(PlyScalar type) {
        constexpr std::string_view kBlanks = " \t\r\n";
        const std::size_t first = std::min(data_.find_first_not_of(kBlanks), data_.size());
        const std::size_t end = std::min(data_.find_first_of(kBlanks, first), data_.size());
        const std::string_view token = data_.substr(first, end - first);
        data_.remove_prefix(end);
        if (!failed_) {
            word_ = token;
        }
        if (type == PlyScalar::Float) {
            const auto value = parseFloat(token);
            failed_ = failed_ || !value;
            return static_cast<double>(value.value_or(0.0F));
        }
        if (type == PlyScalar::Double) {
            const auto value = parseNumber(token);
            failed_ = failed_ || !value;
            return value.value_or(0.0);
        }
        const auto value = parseInteger(token);
        failed_ = failed_ || !value;
        return static_cast<double>(value.value_or(0));
    }

    std::string_view take(std::size_t count) {
        if (data_.size() < count) {
            failed_ = true;
            return {};
        }
        const std::string_view taken = data_.substr(0, count);
        data_.remove_prefix(count);
        return taken;
    }

    template <class Number>
    Number binaryNumber() {
        const std::string_view bytes = take(sizeof(Number));
        Number value{};
        if (bytes.size() != sizeof(Number)) {
            return value;
        }
        std::array<char, sizeof(Number)> copy{};
        std::ranges::copy(bytes, copy.begin());
        if (format_ == PlyFormat::BigEndian) {
            std::ranges::reverse(copy);
        }
        std::memcpy(&value, copy.data(), sizeof value);
        return value;
    }

    std::string_view all_, data_;
    std::string_view word_;  // of a text, the last one up to the one that failed
    PlyFormat format_;
    bool failed_ = false;
};

}  // namespace bspline_curve
