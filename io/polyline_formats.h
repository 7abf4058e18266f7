// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/mesh.h"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

// The formats of polylines, one function each; readPolylines() chooses among them. Each throws
// InputError (UnreadableFile) naming file and place.
namespace bspline_curve {

/// Points and the edges between them.
struct PolylineGraph {
    std::vector<Vec3> points;
    std::vector<std::array<int, 2>> edges;
    /// Where each point is on the mesh that the file is of, as it says; empty: it does not. Faces
    /// may be none of a mesh.
    std::vector<SurfacePoint> places{};
    std::vector<std::string> notes{};  ///< what of the file was left out
};

/// A place of a file: a face that is no whole number of [0, 2^31) becomes -1.
[[nodiscard]] SurfacePoint placeOfNumbers(double face, const Vec3& barycentric);

/// The elements `vertex` and `edge`; all others are passed over. Places by the properties that
/// writeCurve() writes.
[[nodiscard]] PolylineGraph polylinesOfPly(
    const std::filesystem::path& file, std::string_view bytes
);
/// The statements `v` and `l`, and `curv` of B-splines as polylines along them; all others are
/// passed over.
[[nodiscard]] PolylineGraph polylinesOfObj(
    const std::filesystem::path& file, std::string_view bytes
);
/// What curvesOfDxf() reads, arcs and splines as polylines along them; equal points are one.
[[nodiscard]] PolylineGraph polylinesOfDxf(
    const std::filesystem::path& file,
    std::string_view bytes,
    const std::vector<std::string>& layers
);
/// The points of a table, in order, as one polyline; closed where it is one of a closed curve that
/// writeCurve() wrote.
[[nodiscard]] PolylineGraph polylinesOfCsv(
    const std::filesystem::path& file, std::string_view bytes
);
/// The lines of an unstructured grid of VTK, in ASCII or base64.
[[nodiscard]] PolylineGraph polylinesOfVtu(
    const std::filesystem::path& file, std::string_view bytes
);

}  // namespace bspline_curve
