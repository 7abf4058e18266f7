// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/repair.h"

#include <nlohmann/json.hpp>

namespace bspline_curve {

/// The "repair" of a report; null where there is none.
[[nodiscard]] nlohmann::ordered_json repairJson(const RepairReport* repair);

}  // namespace bspline_curve
