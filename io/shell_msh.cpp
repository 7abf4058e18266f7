// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/append_binary.h"
#include "io/shell_cells.h"

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
        appendBinary(bytes, static_cast<double>(valueAt(static_cast<int>(i))));
    }
    return bytes + "\n$End" + section + "\n";
}

std::string nodes(const ShellCells& cells) {
    std::string bytes = "$Nodes\n" + std::to_string(cells.points.size()) + "\n";
    std::int32_t id = 0;
    for (const Vec3& point : cells.points) {
        appendBinary(bytes, ++id);
        for (const double x : point) {
            appendBinary(bytes, x);
        }
    }
    return bytes + "\n$EndNodes\n";
}

std::string elements(const ShellCells& cells) {
    constexpr std::int32_t kGmshTetrahedron = 4;
    std::string bytes = "$Elements\n" + std::to_string(cells.tetrahedra.size()) + "\n";
    // One block: type, number of elements, number of tags (physical and elementary group).
    for (const std::int32_t x : {kGmshTetrahedron, cells.tetrahedronCount(), 2}) {
        appendBinary(bytes, x);
    }
    for (int tet = 0; tet < cells.tetrahedronCount(); ++tet) {
        const std::int32_t group = ShellCells::slabOf(tet) + 1;
        for (const std::int32_t x : {tet + 1, group, group}) {
            appendBinary(bytes, x);
        }
        for (const int point : cells.tetrahedra[tet]) {
            appendBinary(bytes, static_cast<std::int32_t>(point + 1));
        }
    }
    return bytes + "\n$EndElements\n";
}

}  // namespace

std::string mshBytes(const ShellCells& cells) {
    const std::size_t tets = cells.tetrahedra.size();
    std::string bytes = "$MeshFormat\n2.2 1 8\n";
    appendBinary(bytes, std::int32_t{1});  // tells the byte order
    bytes +=
        "\n$EndMeshFormat\n$PhysicalNames\n2\n3 1 \"top\"\n3 2 \"bottom\"\n$EndPhysicalNames\n";
    bytes += nodes(cells);
    bytes += elements(cells);
    bytes += dataSection("NodeData", "f", cells.points.size(), &ShellCells::height);
    bytes += dataSection("ElementData", "prism", tets, [&](int tet) {
        return cells.prisms[ShellCells::prismOf(tet)];
    });
    bytes += dataSection("ElementData", "slab", tets, &ShellCells::slabOf);
    bytes += dataSection("ElementData", "ghost", tets, [&](int tet) {
        return cells.ghost[ShellCells::prismOf(tet)];
    });
    return bytes;
}

}  // namespace bspline_curve
