// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace bspline_curve {

/// The shortest decimal that reads back as this number, the same in every locale: "0.1", "1e-09".
[[nodiscard]] std::string numberText(double value);

}  // namespace bspline_curve
