// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace bspline_curve {

/// Whether the quality of a mesh can be a field, so that curves follow it where `field` is "auto":
/// there is a quality, all of it is finite, and it is not the same everywhere. Takes time in
/// proportion to the vertices.
[[nodiscard]] bool canBeFollowed(std::span<const double> quality);

}  // namespace bspline_curve
