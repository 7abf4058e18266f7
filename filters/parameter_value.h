// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>

namespace bspline_curve {

/// A layer of the host's document.
struct LayerId {
    int id = -1;  ///< the host's number; -1: none is named

    friend bool operator==(const LayerId&, const LayerId&) = default;
};

/// The value of a parameter. Double and Percentage (then in world units): double. Enum (the id of
/// the option), Text, OpenFile and SaveFile (UTF-8): std::string.
using ParameterValue = std::variant<bool, int, double, std::string, LayerId>;

}  // namespace bspline_curve
