// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "fill/fill_holes.h"
#include "imprint/imprint.h"
#include "imprint/mesh_parts.h"
#include "imprint/part_choice.h"
#include "offset/offset_curves.h"
#include "workpiece/made_mesh.h"
#include "workpiece/workpiece.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

// What is made of curves on a workpiece, for all hosts. Lines are on its mesh. All throw
// InputError, Cancelled.
namespace bspline_curve {

/// Curves as edges of the workpiece's mesh, and the parts between them.
struct Imprint {
    /// The workpiece's, or one that was joined anew for curves that pass from sheet to sheet.
    std::shared_ptr<const Surface> surface;
    /// On that surface, whose seams are joined: parts are found and cut out here.
    std::shared_ptr<const ImprintedMesh> joined;
    /// With the vertices of the workpiece's mesh, see unjoined(); the same one where these are the
    /// surface's.
    std::shared_ptr<const ImprintedMesh> mesh;
    MeshParts parts;
    double seconds = 0.0;  ///< of imprinting, without finding parts
};

[[nodiscard]] Imprint imprintOn(
    const Workpiece& workpiece,
    std::span<const SurfacePolyline> lines,
    const ImprintOptions& options = {},
    const Progress& progress = {}
);

/// The whole imprint as a mesh.
[[nodiscard]] MadeMesh wholeMesh(const Imprint& imprint);

/// What a cut leaves.
struct CutChoice {
    std::optional<PartChoice> keep;  ///< none: all parts
    bool split = false;              ///< where all are kept: a mesh for each part
    std::optional<FillShape> fill;   ///< of holes that the other parts leave; none: open
    double relief = 0.0;  ///< height that the parts to keep are moved by; 0: they are cut out
};

struct CutMeshes {
    struct Piece {
        std::vector<int> parts;  ///< that it has, ascending
        MadeMesh mesh;
    };

    std::vector<Piece> pieces;  ///< the one with the largest part first
    std::vector<int> dropped;   ///< parts that no piece has, ascending
    int doubledVertices = 0, filledHoles = 0;
    std::vector<std::string> notes;
};

/// The mesh opened along the curves. Throws InputError (NoPath) where they open nothing.
[[nodiscard]] CutMeshes cutOn(
    const Imprint& imprint, const CutChoice& choice, const Progress& progress = {}
);

/// Each part by itself, and those together that no curve parts from another. Throws InputError
/// (NoPath) where curves part nothing.
[[nodiscard]] CutMeshes segmentsOf(const Imprint& imprint, bool split);

struct OffsetLines {
    struct Piece {
        FittedLine line;
        int curve = 0;  ///< which of the lines it is beside
    };

    std::vector<Piece> pieces;  ///< of each curve the longest first
    std::vector<char> band;     ///< per face, within the distance; only where it is asked for

    /// Whether a piece is beside a line.
    [[nodiscard]] bool hasBeside(std::size_t line) const;
};

/// What to say where none is.
inline constexpr const char* kNothingBeside =
    "no point of the surface on that side is at this distance from the curve; give a smaller "
    "offset";

/// Lines beside each of some lines; none where no point of the surface has that distance.
[[nodiscard]] OffsetLines linesBeside(
    const Workpiece& workpiece,
    std::span<const SurfacePolyline> lines,
    const OffsetOptions& options,
    bool withBand,
    const Progress& progress = {}
);

}  // namespace bspline_curve
