// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/error.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bspline_curve::test_support {

/// The error that a call refuses its input with; none where it does not.
template <class Call>
[[nodiscard]] std::optional<InputError> refusal(const Call& call) {
    try {
        static_cast<void>(call());
    } catch (const InputError& error) {
        return error;
    }
    return std::nullopt;
}

/// Expects that a call refuses its input with a code, in a message that says `said`, and names
/// `elements` where given.
template <class Call>
void expectRefused(
    const Call& call,
    InputErrorCode code,
    const std::string& said = "",
    const std::optional<std::vector<std::int64_t>>& elements = std::nullopt
) {
    const std::optional<InputError> error = refusal(call);
    ASSERT_TRUE(error.has_value()) << "not refused: " << said;
    EXPECT_EQ(error->code(), code) << error->what();
    EXPECT_NE(std::string(error->what()).find(said), std::string::npos) << error->what();
    if (elements) {
        EXPECT_EQ(error->elements(), *elements) << error->what();
    }
}

}  // namespace bspline_curve::test_support
