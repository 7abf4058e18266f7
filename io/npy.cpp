// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/npy.h"

#include "text/text_parsing.h"

#include <algorithm>
#include <utility>

namespace bspline_curve {

namespace {

using std::filesystem::path;

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

}  // namespace

NpyArray parseNpy(
    const path& file,
    std::string_view bytes,
    std::span<const std::string_view> types,
    const std::string& wanted
) {
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

    const std::string_view quotedType = npyEntry(file, header, "descr");
    const std::string_view type = quotedType.substr(std::min<std::size_t>(1, quotedType.size()));
    const std::string_view shape = npyEntry(file, header, "shape");
    if (std::ranges::find(types, type) == types.end()) {
        refuseFile(file, "the values must be " + wanted + ", little-endian");
    }
    if (!shape.starts_with('(')) {
        refuseFile(file, "the shape in the .npy header is no tuple");
    }
    const std::vector<std::string_view> sizes = splitAt(shape.substr(1), ',');
    const auto count = parseInteger(sizes[0]);
    if (!count || *count < 0 || sizes.size() > 2 || (sizes.size() == 2 && !sizes[1].empty())) {
        refuseFile(
            file, "the array must have one dimension, its shape is " + std::string(shape) + ")"
        );
    }
    const auto size = static_cast<std::size_t>(type.back() - '0');
    const std::size_t available = (bytes.size() - start) / size;
    if (std::cmp_less(available, *count)) {
        refuseFile(
            file,
            "is truncated: " + std::to_string(available) + " of " + std::to_string(*count) +
                " values"
        );
    }
    return {type, bytes.substr(start, static_cast<std::size_t>(*count) * size)};
}

}  // namespace bspline_curve
