// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/shell_cells.h"
#include "io/vtk_array.h"

#include <cstdint>

namespace bspline_curve {

std::string vtuBytes(const ShellCells& cells) {
    constexpr int kVtkTetrahedron = 10;
    const std::size_t points = cells.points.size();
    const std::size_t tets = cells.tetrahedra.size();
    const auto tet = [](std::size_t i) { return static_cast<int>(i); };
    return std::string(kVtuStart) + "<Piece NumberOfPoints=\"" + std::to_string(points) +
           "\" NumberOfCells=\"" + std::to_string(tets) + "\">\n<PointData Scalars=\"f\">\n" +
           vtkArray<float>(
               "Float32",
               "f",
               1,
               points,
               [](std::size_t i) { return ShellCells::height(static_cast<int>(i)); }
           ) +
           "</PointData>\n<CellData Scalars=\"prism\">\n" +
           vtkArray<std::int32_t>(
               "Int32",
               "prism",
               1,
               tets,
               [&](std::size_t i) { return cells.prisms[ShellCells::prismOf(tet(i))]; }
           ) +
           vtkArray<std::uint8_t>(
               "UInt8", "slab", 1, tets, [&](std::size_t i) { return ShellCells::slabOf(tet(i)); }
           ) +
           vtkArray<std::uint8_t>(
               "UInt8",
               "ghost",
               1,
               tets,
               [&](std::size_t i) { return cells.ghost[ShellCells::prismOf(tet(i))]; }
           ) +
           "</CellData>\n<Points>\n" +
           vtkArray<double>(
               "Float64",
               "Points",
               3,
               3 * points,
               [&](std::size_t i) { return cells.points[i / 3][static_cast<int>(i % 3)]; }
           ) +
           "</Points>\n<Cells>\n" +
           vtkArray<std::int32_t>(
               "Int32",
               "connectivity",
               1,
               4 * tets,
               [&](std::size_t i) { return cells.tetrahedra[i / 4][i % 4]; }
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
