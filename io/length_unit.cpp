// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/length_unit.h"

#include <algorithm>

namespace bspline_curve {

std::string_view name(LengthUnit unit) {
    return namesOf(unit).id;
}

std::optional<LengthUnit> lengthUnitOf(std::string_view word) {
    const auto* const found =
        std::ranges::find(kLengthUnits, word, [](LengthUnit unit) { return name(unit); });
    return found == kLengthUnits.end() ? std::nullopt : std::optional(*found);
}

}  // namespace bspline_curve
