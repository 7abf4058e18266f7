// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "workpiece/curve_points.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace bspline_curve {

/// Points along one curve.
struct PointsOfCurve {
    bool closed = false;
    std::vector<CurvePoint> points;
};

/// The ends of names of files of points, for help and messages.
inline constexpr const char* kPointsExtensions = ".csv, .json, .mrk.json, .fcsv, .pp, .xyz";

/// Throws InputError (UnwritableFile) where points cannot be written under this name.
void checkPointsExtension(const std::filesystem::path& file);

/// The bytes of a file of points, all of which picks are read from:
///   .csv       curve, number (both from 1), x y z, distance, tangent, normal and left, curvature
///              with its normal and geodesic part, face, barycentric coordinates
///   .json      {"picks": [[x, y, z], …], "closed"} of the first curve, and {"curves": [{"closed",
///              "points": [{…}, …]}, …]} with the same as .csv
///   .mrk.json  markups of 3D Slicer in LPS: a Curve or ClosedCurve for each curve
///   .fcsv      a list of 3D Slicer in LPS
///   .pp        picks of MeshLab
///   .xyz       x y z per line
/// Numbers are written without loss. Throws InputError (UnwritableFile).
[[nodiscard]] std::string pointsBytes(
    const std::filesystem::path& file, std::span<const PointsOfCurve> curves
);

}  // namespace bspline_curve
