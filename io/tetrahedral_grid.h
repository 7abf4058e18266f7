// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace bspline_curve {

/// Tetrahedra with f at their points, as files have them.
struct TetrahedralGrid {
    std::vector<Vec3> points;
    std::vector<double> heights;                 ///< f of each point
    std::vector<std::array<int, 4>> tetrahedra;  ///< positively oriented, as VTK and Gmsh want
    std::string slabName;                        ///< what the slabs are called
    std::vector<std::uint8_t> slabs;             ///< of each tetrahedron: 0 top, 1 bottom

    struct CellField {
        std::string name;
        std::vector<int> values;
    };

    std::vector<CellField> fields;  ///< further ones, one value per tetrahedron
};

// The formats; see shellBytes().
[[nodiscard]] std::string vtuBytes(const TetrahedralGrid& grid);
[[nodiscard]] std::string mshBytes(const TetrahedralGrid& grid);

}  // namespace bspline_curve
