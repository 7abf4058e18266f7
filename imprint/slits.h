// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "imprint/mesh_parts.h"

#include <string>

namespace bspline_curve {

/// Curves that part nothing: no edge of theirs has two parts beside it. A cut along one leaves a
/// slit, whose sides lie on each other. Curves that run along the boundary alone are no slits.
struct Slits {
    int curves = 0;  ///< how many there are
    /// How many of them are closed or lead from boundary to boundary: they run round a handle or
    /// join two boundaries, so that another one beside them parts the mesh.
    int completeCurves = 0;
    int allCurves = 0;  ///< of the imprint, with those that part
    int edges = 0;      ///< of the slits
};

/// O(n + k log k) for n faces, k of them at curves.
[[nodiscard]] Slits slitsOf(const ImprintedMesh& imprinted, const MeshParts& parts);

/// That they part nothing, where `isCut` what the cut did there, and what to draw: one line without
/// a stop. Empty where there is none.
[[nodiscard]] std::string describeSlits(const Slits& slits, bool isCut);

}  // namespace bspline_curve
