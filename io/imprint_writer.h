// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "imprint/imprint.h"
#include "imprint/mesh_parts.h"

#include <span>
#include <string>

namespace bspline_curve {

/// How an imprint came about, for its report.
struct ImprintFigures {
    double readSeconds = 0.0;     ///< files
    double surfaceSeconds = 0.0;  ///< validation and adjacency
    double imprintSeconds = 0.0;  ///< surface and curves in memory to arrays
    double snap = 0.0;            ///< as asked for
};

/// JSON: where each face and vertex of an imprinted mesh comes from. Keys: parents (per face),
/// new_vertices (face and barycentrics of each), curves (vertices in order, closed), crossings,
/// regions (per face), quality (input and output; null without).
[[nodiscard]] std::string imprintMapBytes(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    std::span<const double> inputQuality,
    std::span<const double> quality
);

/// JSON: counts, largest move, parts, seconds.
[[nodiscard]] std::string imprintReportBytes(
    const ImprintedMesh& imprinted, const MeshParts& parts, const ImprintFigures& figures
);

}  // namespace bspline_curve
