// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/mesh_checksum.h"
#include "surface/surface.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace bspline_curve {

/// The polylines of a curve file that writeCurve() or curvesBytes() wrote as .json, by its faces
/// and barycentric coordinates, so exactly where it was drawn. `mesh`: the surface's input, which
/// the curves are on. Throws InputError (UnreadableFile: another format, missing keys, values that
/// are no surface points; NoPath: not on this mesh, since the file names the checksum of another, a
/// face does not exist, a position differs by more than 1e-6 diagonals or a segment leaves its
/// face, which may lie on a sheet that mending parts from that before), naming file, vertex and
/// what to do. Files without a checksum are read as well. O(n), for a mended mesh O(n log n).
[[nodiscard]] std::vector<SurfacePolyline> readCurves(
    const std::filesystem::path& file, const Surface& surface, const MeshChecksum& mesh
);

/// The splines of such a file, for each curve; none where it has none. Throws InputError
/// (UnreadableFile).
[[nodiscard]] std::vector<std::optional<SplineData>> readSplines(const std::filesystem::path& file);

/// The curve of a file with one; refuses another number.
[[nodiscard]] SurfacePolyline readCurve(
    const std::filesystem::path& file, const Surface& surface, const MeshChecksum& mesh
);

}  // namespace bspline_curve
