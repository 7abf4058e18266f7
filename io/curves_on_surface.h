// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/files.h"
#include "surface/mesh_checksum.h"
#include "surface/surface.h"
#include "surface/triangle_tree.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {

/// Reads curves of files onto a surface, for all that use curves. Those of .json are read exactly
/// where they were drawn, see readCurves(). So are polylines of .ply, .csv and .vtu whose faces and
/// barycentric coordinates are on this mesh; all others are projected, see readPolylines() and
/// projectedPolyline().
class CurvesOnSurface {
public:
    /// `distance`: polylines that are farther from the surface are refused. The surface must
    /// outlive this.
    CurvesOnSurface(
        const Surface& surface,
        const MeshChecksum& mesh,
        double distance,
        std::vector<std::string> layers = {}
    )
        : surface_(surface), mesh_(mesh), distance_(distance), layers_(std::move(layers)) {}

    /// Throws InputError (UnreadableFile, NoPath, PickTooFar) naming the file. `remedy`: how its
    /// host loosens the distance, for messages.
    [[nodiscard]] CurvesOfFile read(const std::filesystem::path& file, const char* remedy);

    /// The same of a file with one curve; refuses another number.
    [[nodiscard]] SurfacePolyline readOne(const std::filesystem::path& file, const char* remedy);

private:
    const Surface& surface_;
    MeshChecksum mesh_;
    double distance_;
    std::vector<std::string> layers_;
    std::optional<TriangleTree> tree_;  // made with the first polyline that needs it
};

}  // namespace bspline_curve
