// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/append_binary.h"
#include "io/base64.h"
#include "io/shell_cells.h"

#include <cstdint>

namespace bspline_curve {

namespace {

/// An array of `count` values as VTK's XML has it: base64 of its size and then its bytes.
template <class Number, class ValueAt>
std::string dataArray(
    const std::string& type,
    const std::string& name,
    int components,
    std::size_t count,
    const ValueAt& valueAt
) {
    std::string bytes;
    bytes.reserve(sizeof(std::uint64_t) + count * sizeof(Number));
    appendBinary(bytes, static_cast<std::uint64_t>(count * sizeof(Number)));
    for (std::size_t i = 0; i < count; ++i) {
        appendBinary(bytes, static_cast<Number>(valueAt(i)));
    }
    std::string text = R"(<DataArray type=")";
    text.append(type).append(R"(" Name=")").append(name).append(R"(" NumberOfComponents=")");
    text.append(std::to_string(components)).append(R"(" format="binary">)").append(base64(bytes));
    return text.append("</DataArray>\n");
}

}  // namespace

std::string vtuBytes(const ShellCells& cells) {
    constexpr int kVtkTetrahedron = 10;
    const std::size_t points = cells.points.size();
    const std::size_t tets = cells.tetrahedra.size();
    const auto tet = [](std::size_t i) { return static_cast<int>(i); };
    return "<?xml version=\"1.0\"?>\n"
           "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
           std::to_string(points) + "\" NumberOfCells=\"" + std::to_string(tets) +
           "\">\n<PointData Scalars=\"f\">\n" +
           dataArray<float>(
               "Float32",
               "f",
               1,
               points,
               [](std::size_t i) { return ShellCells::height(static_cast<int>(i)); }
           ) +
           "</PointData>\n<CellData Scalars=\"prism\">\n" +
           dataArray<std::int32_t>(
               "Int32",
               "prism",
               1,
               tets,
               [&](std::size_t i) { return cells.prisms[ShellCells::prismOf(tet(i))]; }
           ) +
           dataArray<std::uint8_t>(
               "UInt8", "slab", 1, tets, [&](std::size_t i) { return ShellCells::slabOf(tet(i)); }
           ) +
           dataArray<std::uint8_t>(
               "UInt8",
               "ghost",
               1,
               tets,
               [&](std::size_t i) { return cells.ghost[ShellCells::prismOf(tet(i))]; }
           ) +
           "</CellData>\n<Points>\n" +
           dataArray<double>(
               "Float64",
               "Points",
               3,
               3 * points,
               [&](std::size_t i) { return cells.points[i / 3][static_cast<int>(i % 3)]; }
           ) +
           "</Points>\n<Cells>\n" +
           dataArray<std::int32_t>(
               "Int32",
               "connectivity",
               1,
               4 * tets,
               [&](std::size_t i) { return cells.tetrahedra[i / 4][i % 4]; }
           ) +
           dataArray<std::int32_t>(
               "Int32", "offsets", 1, tets, [](std::size_t i) { return 4 * (i + 1); }
           ) +
           dataArray<std::uint8_t>(
               "UInt8", "types", 1, tets, [](std::size_t) { return kVtkTetrahedron; }
           ) +
           "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace bspline_curve
