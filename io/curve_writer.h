// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/curve.h"
#include "surface/types.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace bspline_curve {

/// A per-vertex field along a polyline: one value per polyline vertex, interpolated linearly in its
/// face.
[[nodiscard]] std::vector<double> fieldAlong(
    const SurfacePolyline& polyline,
    const std::vector<Triangle>& faces,
    std::span<const double> field
);

/// Throws InputError (UnwritableFile) where writeCurve knows no format for the extension.
void checkCurveExtension(const std::filesystem::path& file);

/// The bytes of a curve file; the format by the extension of `file`:
///   .ply   binary, little-endian; vertex: x y z (double), t (double), face (int), barycentric_0..2
///   (double), and
///          quality (double) where given; edge: vertex1 vertex2 (int), in order along the curve
///   .obj   v with 17 digits, and one l per segment (MeshLab's importer reads two indices per l)
///   .json  {"closed", "polyline": {"points", "faces", "barycentrics", "t"},
///          "spline": {"degree", "knots", "control_points", "pick_parameters"}}; "quality" in
///          "polyline" where given
/// `quality`: one value per polyline vertex, or empty. Throws InputError (UnwritableFile).
[[nodiscard]] std::string curveBytes(
    const std::filesystem::path& file, const Curve& curve, std::span<const double> quality = {}
);

/// Writes curveBytes() to the file: wholly, or not at all. Throws InputError (UnwritableFile).
void writeCurve(
    const std::filesystem::path& file, const Curve& curve, std::span<const double> quality = {}
);

}  // namespace bspline_curve
