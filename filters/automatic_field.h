// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace bspline_curve {

/// Whether curves follow the quality of a mesh where the user named no field (`field` is "auto"):
/// there is a quality, all of it is finite, and it is not the same everywhere. Takes time in
/// proportion to the vertices.
[[nodiscard]] bool isFollowedUnasked(std::span<const double> quality);

}  // namespace bspline_curve
