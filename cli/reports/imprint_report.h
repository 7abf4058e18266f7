// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/imprint.h"
#include "bspline_curve/repair.h"

#include <span>
#include <string>
#include <vector>

namespace bspline_curve::cli {

/// How an imprint came about, for its report.
struct ImprintFigures {
    double readSeconds = 0.0;              ///< files
    double surfaceSeconds = 0.0;           ///< validation and adjacency
    double drawSeconds = 0.0;              ///< polylines projected, curves drawn through picks
    double imprintSeconds = 0.0;           ///< surface and curves in memory to arrays
    double snap = 0.0;                     ///< as asked for
    const RepairReport* repair = nullptr;  ///< null: nothing was repaired
};

/// How a cut came about, for its report.
struct CutFigures {
    int doubledVertices = 0;  ///< copies of vertices on curves
    double cutSeconds = 0.0;  ///< imprint to bytes of the meshes written
    std::vector<int> kept;    ///< parts that are written, ascending
    int filledHoles = 0;
};

/// JSON: where each face and vertex of an imprinted mesh comes from, in the mesh as it was given.
/// Keys: parents (per face), new_vertices (face and barycentrics of each), curves (vertices in
/// order, closed), crossings, regions (per face), quality (input and output; null without).
[[nodiscard]] std::string imprintMapBytes(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    std::span<const double> inputQuality,
    std::span<const double> quality
);

/// JSON: counts, largest move, parts, what was mended, seconds.
[[nodiscard]] std::string imprintReportBytes(
    const ImprintedMesh& imprinted, const MeshParts& parts, const ImprintFigures& figures
);

/// JSON: that of the imprint, and vertices doubled, parts kept.
[[nodiscard]] std::string cutReportBytes(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    const ImprintFigures& figures,
    const CutFigures& cut
);

/// A table of parts, one a line with a head: part, faces, area, perimeter, centroid_x, centroid_y,
/// centroid_z, euler.
[[nodiscard]] std::string partsCsv(const MeshParts& parts);

/// The same as JSON: {"parts": [{"faces", "area", "perimeter", "centroid", "euler"}, …]}.
[[nodiscard]] std::string partsJson(const MeshParts& parts);

}  // namespace bspline_curve::cli
