// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/error.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace bspline_curve {

/// "empty-mesh": a code as hosts name it.
[[nodiscard]] const char* name(InputErrorCode code);

/// "3, 17, 20, 21, 25 and 12 more": the first ids of a list, for messages.
[[nodiscard]] std::string describeElements(const std::vector<std::int64_t>& elements);

/// "pick 1", "picks 1, 4, 5": picks for messages, where they are counted from 1. `picks`: their
/// indices, from 0, at least one.
[[nodiscard]] std::string describePicks(std::vector<std::int64_t> picks);

/// "1 face", "17 faces": a count and its noun (or the start of its sentence), for messages.
[[nodiscard]] std::string describeCount(
    std::size_t count, const std::string& one, const std::string& many
);

/// Throws an InputError with the message "<what> (<noun> <first elements>): <remedy>".
[[noreturn]] void refuseElements(
    InputErrorCode code,
    const std::string& what,
    const std::string& noun,
    std::vector<std::int64_t> elements,
    const std::string& remedy
);

/// How a host says what helps; what it cannot do is empty. In `weld`, % stands for the distance.
struct RemedyWords {
    std::string_view mend, weld;
};

/// A message, and what helps in words of the host.
[[nodiscard]] std::string withRemedy(
    const std::string& message, const Remedy& remedy, const RemedyWords& words
);

/// "12.4", "12350", "1.2e-07": a number with four significant digits, for messages; the same in
/// every locale.
[[nodiscard]] std::string describeNumber(double value);

/// "12.4 mesh units": a length in the unit of the mesh, for messages.
[[nodiscard]] std::string describeLength(double length);

}  // namespace bspline_curve
