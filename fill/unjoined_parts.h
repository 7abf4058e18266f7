// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fill/part_filling.h"

namespace bspline_curve {

/// Parts of an imprint with the seams of its input, which mending has joined: each face has the
/// vertices of its own side again. `unjoined`: what unjoined() makes of the imprint `joined` that
/// the parts are of; `source` is of that then. Walls go on from the faces that they rise beside; a
/// filled hole has one side's vertices. First come vertices of the imprint in its order, then those
/// that are new or copies. O(n log n).
[[nodiscard]] FilledParts unjoined(
    const FilledParts& parts, const ImprintedMesh& joined, const ImprintedMesh& unjoined
);

}  // namespace bspline_curve
