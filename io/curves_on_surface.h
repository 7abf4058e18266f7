// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/files.h"
#include "surface/mesh_checksum.h"
#include "surface/surface.h"
#include "surface/triangle_tree.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <utility>

namespace bspline_curve {

/// Reads curves of files onto a surface, for all that use curves. Those of .json are read exactly
/// where they were drawn, see readCurves(). So are polylines of .ply, .csv and .vtu whose faces and
/// barycentric coordinates are on this mesh; all others are projected, see readPolylines() and
/// projectedLines().
class CurvesOnSurface {
public:
    /// The surface must outlive this.
    CurvesOnSurface(const Surface& surface, const MeshChecksum& mesh, CurveReading reading)
        : surface_(surface), mesh_(mesh), reading_(std::move(reading)) {}

    /// Throws InputError (UnreadableFile, NoPath, PickTooFar, BadOption) naming the file.
    [[nodiscard]] CurvesOfFile read(const std::filesystem::path& file);

    /// The same of a file with one curve; refuses another number.
    [[nodiscard]] SurfacePolyline readOne(const std::filesystem::path& file);

private:
    [[nodiscard]] ProjectedLines projected(
        const std::filesystem::path& file, const PolylineFile& polylines, std::size_t index
    );

    const Surface& surface_;
    MeshChecksum mesh_;
    CurveReading reading_;
    std::optional<TriangleTree> tree_;  // made with the first polyline that needs it
};

}  // namespace bspline_curve
