// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/tetrahedral_grid.h"
#include "shell/extended_surface.h"
#include "shell/shell.h"

#include <filesystem>
#include <string>

namespace bspline_curve {

/// The bytes of a shell file, in the user's coordinates; the format by the extension of `file`:
///   .vtu   VTK XML unstructured grid, base64: conforming tetrahedra; points: f (-1, 0, 1); cells:
///          prism (index in the shell), slab (0 top, 1 bottom), ghost (1 beyond the boundary)
///   .msh   Gmsh 2.2, binary: the same fields, and the slabs as physical groups 1 "top", 2 "bottom"
///   .ply   binary, little-endian: top, middle and bottom of each prism as triangles; vertex:
///          x y z quality (double; quality is f), red green blue alpha (uchar); no further
///          properties of faces, which meshio could not read
/// Prisms of blocked faces are left out. Throws InputError (UnwritableFile).
[[nodiscard]] std::string shellBytes(
    const std::filesystem::path& file, const Shell& shell, const ShellFrame& frame
);

/// The same of other tetrahedra of a shell: .vtu and .msh alone.
[[nodiscard]] std::string gridBytes(const std::filesystem::path& file, const TetrahedralGrid& grid);

}  // namespace bspline_curve
