// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/append_binary.h"
#include "io/tetrahedral_grid.h"

#include <cstdint>

namespace bspline_curve {

namespace {

/// A section of one number per node or element; these count from 1.
template <class ValueAt>
std::string dataSection(
    const std::string& section, const std::string& name, std::size_t count, const ValueAt& valueAt
) {
    // String tags: the name; real tags: a time; integer tags: time step, components,
    // entries.
    std::string bytes =
        "$" + section + "\n1\n\"" + name + "\"\n1\n0\n3\n0\n1\n" + std::to_string(count) + "\n";
    for (std::size_t i = 0; i < count; ++i) {
        appendBinary(bytes, static_cast<std::int32_t>(i + 1));
        appendBinary(bytes, static_cast<double>(valueAt(i)));
    }
    return bytes + "\n$End" + section + "\n";
}

std::string nodes(const TetrahedralGrid& grid) {
    std::string bytes = "$Nodes\n" + std::to_string(grid.points.size()) + "\n";
    std::int32_t id = 0;
    for (const Vec3& point : grid.points) {
        appendBinary(bytes, ++id);
        for (const double x : point) {
            appendBinary(bytes, x);
        }
    }
    return bytes + "\n$EndNodes\n";
}

std::string elements(const TetrahedralGrid& grid) {
    constexpr std::int32_t kGmshTetrahedron = 4;
    std::string bytes = "$Elements\n" + std::to_string(grid.tetrahedra.size()) + "\n";
    // One block: type, number of elements, number of tags (physical and elementary group).
    for (const std::int32_t x :
         {kGmshTetrahedron, static_cast<std::int32_t>(grid.tetrahedra.size()), 2}) {
        appendBinary(bytes, x);
    }
    for (std::size_t tet = 0; tet < grid.tetrahedra.size(); ++tet) {
        const std::int32_t group = grid.slabs[tet] + 1;
        for (const std::int32_t x : {static_cast<std::int32_t>(tet + 1), group, group}) {
            appendBinary(bytes, x);
        }
        for (const int point : grid.tetrahedra[tet]) {
            appendBinary(bytes, static_cast<std::int32_t>(point + 1));
        }
    }
    return bytes + "\n$EndElements\n";
}

}  // namespace

std::string mshBytes(const TetrahedralGrid& grid) {
    const std::size_t tets = grid.tetrahedra.size();
    std::string bytes = "$MeshFormat\n2.2 1 8\n";
    appendBinary(bytes, std::int32_t{1});  // tells the byte order
    bytes +=
        "\n$EndMeshFormat\n$PhysicalNames\n2\n3 1 \"top\"\n3 2 \"bottom\"\n$EndPhysicalNames\n";
    bytes += nodes(grid);
    bytes += elements(grid);
    bytes += dataSection("NodeData", "f", grid.points.size(), [&](std::size_t i) {
        return grid.heights[i];
    });
    bytes += dataSection("ElementData", grid.slabName, tets, [&](std::size_t i) {
        return grid.slabs[i];
    });
    for (const TetrahedralGrid::CellField& field : grid.fields) {
        bytes += dataSection("ElementData", field.name, tets, [&](std::size_t i) {
            return field.values[i];
        });
    }
    return bytes;
}

}  // namespace bspline_curve
