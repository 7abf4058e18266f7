// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/mesh_checksum.h"
#include "bspline_curve/workpiece.h"
#include "filters/curve_records.h"
#include "filters/drawn_curve.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

// Files of curves that were drawn, to go on with: .json, .obj and .dxf, see docs/FILES.md.
namespace bspline_curve {

/// What the curves of a file are on.
struct CurveFileSurface {
    const TriangleMesh& mesh;  ///< the input, unrepaired
    MeshChecksum checksum;     ///< of it
    /// Where picks are projected to it: what lies on it; null: a tree is built where it is needed.
    const Workpiece* workpiece = nullptr;
};

/// A curve on the mesh of a CurveFileSurface, for its file.
struct CurveToSave {
    DrawnCurve drawn;
    std::shared_ptr<const Curve> curve;  ///< of these picks; null: they have none yet
};

/// The bytes of a file of curves with their picks, options, names and colours; the format by the
/// extension. .json holds all; .obj and .dxf are what writeCurve() makes of the polylines, with
/// the rest in comments. Nothing is rounded. Throws InputError (UnwritableFile: also where there
/// are no curves).
[[nodiscard]] std::string drawnCurvesBytes(
    const std::filesystem::path& file,
    std::span<const CurveToSave> curves,
    const CurveFileSurface& surface
);

/// Writes these to the file, wholly or not at all. Throws likewise.
void saveDrawnCurves(
    const std::filesystem::path& file,
    std::span<const CurveToSave> curves,
    const CurveFileSurface& surface
);

struct OpenedCurves {
    std::vector<DrawnCurve> curves;  ///< at least one; picks are on the mesh of the surface
    std::vector<std::string> notes;  ///< sentences on what is not as it was saved
};

/// The curves of a file that saveDrawnCurves() or writeCurve() wrote: exactly where they were drawn
/// if the file names the same mesh, else with their picks projected to this one. From other files
/// .obj, .dxf and .ply, each chain of edges becomes a curve through as few of its vertices as
/// describe it to 0.2 % of the diagonal, at most 200. A curve with a pick farther than
/// kPickReachRelative from the surface is left out, which a note tells. Throws InputError naming
/// the file (UnreadableFile; PickTooFar: no curve is near the surface).
[[nodiscard]] OpenedCurves openDrawnCurves(
    const std::filesystem::path& file, const CurveFileSurface& surface
);

/// The same for records that were read already. `file` is for messages.
[[nodiscard]] OpenedCurves placedRecords(
    const std::filesystem::path& file, const CurveRecords& records, const CurveFileSurface& surface
);

}  // namespace bspline_curve
