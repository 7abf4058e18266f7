// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fill/part_filling.h"

#include <optional>

namespace bspline_curve {

/// The whole mesh cut along closed curves that part nothing, as those round a handle, with a cap on
/// either rim: the same triangles, flat, of which one is turned over. They lie on each other;
/// nothing else crosses unless `crossing` has it. Curves that are slits stay closed. None where no
/// curve is such a one. Throws InputError as fillHoles() does. O(n) beside fillHoles().
[[nodiscard]] std::optional<FilledParts> cappedHandles(
    const ImprintedMesh& imprinted, const MeshParts& parts, const Progress& progress = {}
);

}  // namespace bspline_curve
