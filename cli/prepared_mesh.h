// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/designer.h"
#include "cli/curve_options.h"
#include "io/mesh_reader.h"
#include "surface/mending.h"
#include "surface/mesh_checksum.h"

#include <cstddef>
#include <cstdint>

// A mesh that is read and prepared once, for as many curves as are asked for.
namespace bspline_curve::cli {

/// A mesh file as curves need it.
struct LoadedMesh {
    MeshFile mesh;
    std::size_t givenVertices = 0, givenFaces = 0;
    MeshChecksum checksum;  ///< of the mesh as it was given
    double readSeconds = 0.0;
    std::int64_t readMemoryBytes = 0;
};

/// Throws InputError, Cancelled.
[[nodiscard]] LoadedMesh loadMesh(const CurveArguments& arguments);

/// A mesh with all that does not depend on the picks. The vertices and faces of `loaded` have moved
/// into the designer.
struct PreparedMesh {
    LoadedMesh loaded;
    Mended<CurveDesigner> mended;
    double seconds = 0.0;  ///< of preparing

    /// Throws InputError, Cancelled.
    PreparedMesh(LoadedMesh from, const CurveArguments& arguments, const Progress& progress);

    [[nodiscard]] const CurveDesigner& designer() const { return mended.made; }
};

/// Draws one curve on a mesh that is ready, and writes it. Prints what goes wrong.
[[nodiscard]] ExitCode drawOn(const PreparedMesh& prepared, CurveArguments arguments);

}  // namespace bspline_curve::cli
