// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace bspline_curve {

/// Bytes as text (RFC 4648, with padding, without line ends).
[[nodiscard]] std::string base64(std::string_view bytes);

/// The bytes of such a text; none where it is not one.
[[nodiscard]] std::optional<std::string> bytesOfBase64(std::string_view text);

}  // namespace bspline_curve
