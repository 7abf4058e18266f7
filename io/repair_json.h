// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/repair.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace bspline_curve {

/// The "repair" of a report; null where nothing was mended.
[[nodiscard]] nlohmann::ordered_json repairJson(const std::optional<RepairReport>& repair);

}  // namespace bspline_curve
