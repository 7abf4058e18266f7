// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/files.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace bspline_curve {

struct LengthUnitNames {
    LengthUnit unit;
    std::string_view id;          ///< see name()
    std::string_view stepPrefix;  ///< of the metre; empty: it has none
    double millimetres;           ///< of units that are no part of a metre; 0: they are
    std::string_view name;        ///< of such a unit, in STEP
    int igesFlag;
    std::string_view igesName;
};

inline constexpr std::array<LengthUnitNames, 6> kLengthUnitNames{{
    {LengthUnit::Millimetre, "mm", ".MILLI.", 0.0, "", 2, "MM"},
    {LengthUnit::Centimetre, "cm", ".CENTI.", 0.0, "", 10, "CM"},
    {LengthUnit::Metre, "m", "$", 0.0, "", 6, "M"},
    {LengthUnit::Micrometre, "um", ".MICRO.", 0.0, "", 9, "UM"},
    {LengthUnit::Inch, "in", "", 25.4, "INCH", 1, "IN"},
    {LengthUnit::Foot, "ft", "", 304.8, "FOOT", 4, "FT"},
}};

[[nodiscard]] constexpr const LengthUnitNames& namesOf(LengthUnit unit) {
    return kLengthUnitNames[static_cast<std::size_t>(unit)];
}

}  // namespace bspline_curve
