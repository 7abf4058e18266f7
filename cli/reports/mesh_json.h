// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/workpiece.h"

#include <nlohmann/json.hpp>

#include <string>

namespace bspline_curve::cli {

/// The "repair" of a report; null where there is none.
[[nodiscard]] nlohmann::ordered_json repairJson(const RepairReport* repair);

/// The "mesh" of a report: of a mesh as it is used, from this file.
[[nodiscard]] nlohmann::ordered_json meshJson(const Workpiece& workpiece, const std::string& file);

}  // namespace bspline_curve::cli
