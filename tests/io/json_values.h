// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace bspline_curve::io_tests {

/// Expects these values at these JSON pointers.
inline void expectValues(
    const nlohmann::json& document,
    const std::vector<std::pair<std::string, nlohmann::json>>& expected
) {
    for (const auto& [place, value] : expected) {
        const nlohmann::json::json_pointer pointer(place);
        EXPECT_TRUE(document.contains(pointer) && document[pointer] == value)
            << place << " is not " << value << " in " << document;
    }
}

}  // namespace bspline_curve::io_tests
