// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/mesh.h"
#include "io/length_unit.h"
#include "surface/mesh_checksum.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace bspline_curve {

/// The ends of names of curve files, for help and messages: ".ply, .obj, …".
[[nodiscard]] std::string curveExtensions();

/// Throws InputError (UnwritableFile) where writeCurve knows no format for the file's name.
void checkCurveExtension(const std::filesystem::path& file);

/// The bytes of a curve file; the format by the end of the name of `file`, in either case:
///   .ply          the polyline, binary, little-endian; vertex: x y z quality t (double), face
///                 (int), barycentric_0..2 (double), is_pick (uchar, 1 where a pick is); edge:
///                 vertex1 vertex2 (int), in order along the curve
///   .obj          the polyline: v, and one l per segment (MeshLab's importer reads two indices
///                 per l)
///   .bspline.obj  the spline: v, cstype bspline, deg, curv, parm u, end; the first `degree`
///                 control points of a closed one are named again at its end
///   .dxf          the polyline: a 3D POLYLINE of R12, closed where the curve is
///   .bspline.dxf  the spline: a SPLINE of R2000; a closed one with clamped knots
///   .vtu          the polyline, VTK XML, base64: lines; points: quality t barycentric (double),
///                 face (int), is_pick (uchar)
///   .csv          the polyline: x,y,z,t,face,b0,b1,b2,quality,is_pick, one line per vertex
///   .step .stp    the spline: B_SPLINE_CURVE_WITH_KNOTS of AP214 in `unit`; a closed one with
///                 clamped knots; .polyline.step: a POLYLINE, closed by its first point once more
///   .iges .igs    likewise as IGES 5.3: entity 126, or 106 of form 12
///   .json         {"closed", "polyline": {"points", "faces", "barycentrics", "t", "picks"},
///                 "spline": {"degree", "closed", "knots", "control_points", "pick_parameters"}};
///                 "quality" in "polyline" where there is a field, and {"mesh": {"vertices",
///                 "faces", "crc32"}} where the mesh is given
/// Numbers are written without loss. `field`: one value per polyline vertex, or empty; quality is
/// the field or, without one, t. `mesh`: the one that the curve's faces are of. Throws InputError
/// (UnwritableFile).
[[nodiscard]] std::string curveBytes(
    const std::filesystem::path& file,
    const Curve& curve,
    std::span<const double> field = {},
    const std::optional<MeshChecksum>& mesh = {},
    LengthUnit unit = LengthUnit::Millimetre
);

/// The ends of names of files that hold several curves.
[[nodiscard]] std::string manyCurvesExtensions();

/// Throws InputError (UnwritableFile) where the file's name is none of a format for several curves.
void checkManyCurvesExtension(const std::filesystem::path& file);

/// Several curves of one mesh in one file: the polylines of .ply, .obj and .dxf, and those of .step
/// and .iges, one after the other; .json {"curves": [{"closed", "polyline", "spline"}, …], "mesh"}.
/// Throws InputError (UnwritableFile).
[[nodiscard]] std::string curvesBytes(
    const std::filesystem::path& file,
    std::span<const Curve* const> curves,
    const std::optional<MeshChecksum>& mesh = {},
    LengthUnit unit = LengthUnit::Millimetre
);

/// Writes curveBytes() to the file: wholly, or not at all. Throws InputError (UnwritableFile).
void writeCurve(
    const std::filesystem::path& file,
    const Curve& curve,
    std::span<const double> field = {},
    const std::optional<MeshChecksum>& mesh = {}
);

}  // namespace bspline_curve
