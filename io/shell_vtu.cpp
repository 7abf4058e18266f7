// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tetrahedral_grid.h"
#include "io/vtk_array.h"

#include <cstdint>

namespace bspline_curve {

std::string vtuBytes(const TetrahedralGrid& grid) {
    constexpr int kVtkTetrahedron = 10;
    const std::size_t points = grid.points.size();
    const std::size_t tets = grid.tetrahedra.size();
    std::string cellData = vtkArray<std::uint8_t>(
        "UInt8", grid.slabName, 1, tets, [&](std::size_t i) { return grid.slabs[i]; }
    );
    for (const TetrahedralGrid::CellField& field : grid.fields) {
        cellData += vtkArray<std::int32_t>("Int32", field.name, 1, tets, [&](std::size_t i) {
            return field.values[i];
        });
    }
    return std::string(kVtuStart) + "<Piece NumberOfPoints=\"" + std::to_string(points) +
           "\" NumberOfCells=\"" + std::to_string(tets) + "\">\n<PointData Scalars=\"f\">\n" +
           vtkArray<double>(
               "Float64", "f", 1, points, [&](std::size_t i) { return grid.heights[i]; }
           ) +
           "</PointData>\n<CellData Scalars=\"" + grid.slabName + "\">\n" + cellData +
           "</CellData>\n<Points>\n" +
           vtkArray<double>(
               "Float64",
               "Points",
               3,
               3 * points,
               [&](std::size_t i) { return grid.points[i / 3][static_cast<int>(i % 3)]; }
           ) +
           "</Points>\n<Cells>\n" +
           vtkArray<std::int32_t>(
               "Int32",
               "connectivity",
               1,
               4 * tets,
               [&](std::size_t i) { return grid.tetrahedra[i / 4][i % 4]; }
           ) +
           vtkArray<std::int32_t>(
               "Int32", "offsets", 1, tets, [](std::size_t i) { return 4 * (i + 1); }
           ) +
           vtkArray<std::uint8_t>(
               "UInt8", "types", 1, tets, [](std::size_t) { return kVtkTetrahedron; }
           ) +
           "</Cells>\n" + kVtuEnd;
}

}  // namespace bspline_curve
