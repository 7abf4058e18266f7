// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/field_reader.h"

#include "io/text_parsing.h"
#include "surface/input_error.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace bspline_curve {

namespace {

using std::filesystem::path;

std::vector<double> readText(const path& file, std::string_view bytes) {
    std::vector<double> values;
    LineReader lines(bytes);
    while (lines.next()) {
        for (const std::string_view word :
             splitAtBlanks(lines.line().substr(0, lines.line().find('#')))) {
            const auto value = parseNumber(word);
            if (!value) {
                refuseLine(file, lines.number(), inQuotes(word) + " is not a number");
            }
            values.push_back(*value);
        }
    }
    return values;
}

/// What follows "'key':" in the header, a Python dict, up to the end of the value.
std::string_view npyEntry(const path& file, std::string_view header, std::string_view key) {
    std::string label = "'";
    label.append(key).append("':");
    const std::size_t at = header.find(label);
    if (at == std::string_view::npos) {
        refuseFile(file, "the .npy header has no " + std::string(key));
    }
    const std::string_view value = trimmed(header.substr(at + label.size()));
    char end = ',';
    if (value.starts_with('(')) {
        end = ')';
    } else if (value.starts_with('\'')) {
        end = '\'';
    }
    return value.substr(0, value.find(end, 1));
}

template <class Scalar>
std::vector<double> npyValues(std::string_view data) {
    static_assert(std::endian::native == std::endian::little);
    std::vector<double> values(data.size() / sizeof(Scalar));
    for (std::size_t i = 0; i < values.size(); ++i) {
        Scalar value{};
        std::memcpy(&value, data.data() + i * sizeof value, sizeof value);
        values[i] = static_cast<double>(value);
    }
    return values;
}

std::vector<double> readNpy(const path& file, std::string_view bytes) {
    // Magic, version (2 bytes), length of the header (2 bytes in version 1, else 4), header, data.
    constexpr std::size_t kVersionAt = 6;
    if (bytes.size() < 12 || !bytes.starts_with("\x93NUMPY")) {
        refuseFile(file, "is not a .npy file");
    }
    const auto byte = [&](std::size_t at) {
        return static_cast<std::size_t>(static_cast<unsigned char>(bytes[at]));
    };
    const bool isShort = byte(kVersionAt) == 1;
    std::size_t start = isShort ? 10 : 12;
    const std::size_t length =
        byte(8) + (byte(9) << 8) + (isShort ? 0 : (byte(10) << 16) + (byte(11) << 24));
    if (bytes.size() < start + length) {
        refuseFile(file, "is truncated within its header");
    }
    const std::string_view header = bytes.substr(start, length);
    start += length;

    const std::string_view type = npyEntry(file, header, "descr");
    const std::string_view shape = npyEntry(file, header, "shape");
    const bool isFloat = type == "'<f4";
    if (!isFloat && type != "'<f8") {
        refuseFile(file, "the values must be float32 or float64, little-endian");
    }
    const std::vector<std::string_view> sizes = splitAt(shape.substr(1), ',');
    const auto count = parseInteger(sizes[0]);
    if (!count || *count < 0 || sizes.size() > 2 || (sizes.size() == 2 && !sizes[1].empty())) {
        refuseFile(
            file, "the array must have one dimension, its shape is " + std::string(shape) + ")"
        );
    }
    const std::size_t available = (bytes.size() - start) / (isFloat ? 4 : 8);
    if (std::cmp_less(available, *count)) {
        refuseFile(
            file,
            "is truncated: " + std::to_string(available) + " of " + std::to_string(*count) +
                " values"
        );
    }
    const std::string_view data =
        bytes.substr(start, static_cast<std::size_t>(*count) * (isFloat ? 4 : 8));
    return isFloat ? npyValues<float>(data) : npyValues<double>(data);
}

}  // namespace

std::vector<double> readField(const path& file, std::size_t vertexCount) {
    const std::string bytes = readWholeFile(file);
    std::vector<double> values =
        lowerCaseExtension(file) == ".npy" ? readNpy(file, bytes) : readText(file, bytes);
    if (values.size() != vertexCount) {
        throw InputError(
            InputErrorCode::BadField,
            file.string() + ": has " + std::to_string(values.size()) + " values, the mesh has " +
                std::to_string(vertexCount) + " vertices"
        );
    }
    std::vector<std::int64_t> bad;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i])) {
            bad.push_back(static_cast<std::int64_t>(i));
        }
    }
    if (!bad.empty()) {
        throw InputError(
            InputErrorCode::BadField,
            file.string() + ": " + std::to_string(bad.size()) +
                " values are not finite, at vertices " + describeElements(bad),
            bad
        );
    }
    return values;
}

}  // namespace bspline_curve
