// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bspline_curve {

/// A one-dimensional array of a .npy file.
struct NpyArray {
    std::string_view type;  ///< "<f8": little-endian, kind, bytes of a value
    std::string_view data;
};

/// The array in the bytes of a .npy file, which must outlive it. `types` are those accepted,
/// `wanted` says so in words. Throws InputError (UnreadableFile).
[[nodiscard]] NpyArray parseNpy(
    const std::filesystem::path& file,
    std::string_view bytes,
    std::span<const std::string_view> types,
    const std::string& wanted
);

/// The values of an array of `Stored`, converted.
template <class Stored, class Value>
[[nodiscard]] std::vector<Value> npyValues(const NpyArray& array) {
    static_assert(std::endian::native == std::endian::little);
    std::vector<Value> values(array.data.size() / sizeof(Stored));
    for (std::size_t i = 0; i < values.size(); ++i) {
        Stored value{};
        std::memcpy(&value, array.data.data() + i * sizeof value, sizeof value);
        values[i] = static_cast<Value>(value);
    }
    return values;
}

}  // namespace bspline_curve
