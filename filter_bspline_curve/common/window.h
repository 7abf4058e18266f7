// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace bspline_curve {

/// Whether the host has MeshLab's window; meshlabserver and pymeshlab have none.
[[nodiscard]] bool hasWindow();

}  // namespace bspline_curve
