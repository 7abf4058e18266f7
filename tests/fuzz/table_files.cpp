// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_target.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace bspline_curve::fuzz {

namespace {

constexpr std::size_t kVertices = 5;

/// An array for readers of .npy and of text; the first byte chooses.
FuzzFile arrayFile(std::string_view bytes) {
    const bool isText = bytes.empty() || bytes[0] % 2 != 0;
    return {
        isText ? "array.txt" : "array.npy", bytes.substr(std::min<std::size_t>(1, bytes.size()))
    };
}

}  // namespace

void readFieldBytes(std::string_view bytes) {
    const FuzzFile file = arrayFile(bytes);
    try {
        const auto values = readField(file.path(), kVertices);
        require(values.size() == kVertices, "one value per vertex");
        require(
            std::ranges::all_of(values, [](double value) { return std::isfinite(value); }),
            "values are finite"
        );
    } catch (const InputError&) {
        return;
    }
}

void readFaceIdsBytes(std::string_view bytes) {
    const FuzzFile file = arrayFile(bytes);
    try {
        require(readFaceIds(file.path()).size() <= bytes.size(), "an id takes a byte at least");
    } catch (const InputError&) {
        return;
    }
}

}  // namespace bspline_curve::fuzz
