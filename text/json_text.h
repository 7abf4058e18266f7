// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace bspline_curve {

/// What reports and curves are written as: in the order in which their values were put in.
using Json = nlohmann::ordered_json;

/// A report as JSON that people read: indented, with a newline at its end. Bytes that are not UTF-8
/// are replaced.
[[nodiscard]] std::string jsonText(const Json& document);

}  // namespace bspline_curve
