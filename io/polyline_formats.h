// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

// The formats of polylines, one function each; readPolylines() chooses among them. Each throws
// InputError (UnreadableFile) naming file and place.
namespace bspline_curve {

/// Points and the edges between them.
struct PolylineGraph {
    std::vector<Vec3> points;
    std::vector<std::array<int, 2>> edges;
};

/// The elements `vertex` and `edge`; all others are passed over.
[[nodiscard]] PolylineGraph polylinesOfPly(
    const std::filesystem::path& file, std::string_view bytes
);
/// The statements `v` and `l`; all others are passed over.
[[nodiscard]] PolylineGraph polylinesOfObj(
    const std::filesystem::path& file, std::string_view bytes
);
/// LINE, POLYLINE and LWPOLYLINE in the section ENTITIES; equal points are one. Refuses arcs,
/// splines and inserted blocks; passes over what is no curve, as texts.
[[nodiscard]] PolylineGraph polylinesOfDxf(
    const std::filesystem::path& file, std::string_view bytes
);

}  // namespace bspline_curve
