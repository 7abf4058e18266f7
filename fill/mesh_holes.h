// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/parts.h"
#include "bspline_curve/progress.h"

namespace bspline_curve {

/// The whole mesh with holes filled; `openRims` counts the others. The outer boundary of an open
/// surface is a hole like the others. Throws InputError (NoPath) where no hole is chosen, and as
/// fillHoles() does. New faces cross others only where `crossing` has them. O(n) beside
/// fillHoles().
[[nodiscard]] FilledParts withHolesFilled(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    const HoleChoice& choice,
    FillShape shape,
    const Progress& progress = {}
);

}  // namespace bspline_curve
