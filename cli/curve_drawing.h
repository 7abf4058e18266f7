// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/workpiece.h"
#include "cli/drawing_options.h"
#include "cli/loaded_mesh.h"

#include <filesystem>
#include <vector>

// Drawing a curve through the picks of a file, for every verb that takes --picks.
namespace bspline_curve::cli {

/// Refuses words for --field and --avoid that are neither one of their words nor files.
void checkDrawingFiles(const DrawingArguments& arguments);

/// Takes the values and faces of files into the options. Throws InputError.
void readDrawingFiles(DrawingArguments& arguments, const TriangleMesh& mesh);

/// Sets arguments.solver.closed as well where the file asks for it. Throws InputError.
[[nodiscard]] std::vector<Vec3> picksFrom(
    const std::filesystem::path& file, DrawingArguments& arguments
);

/// One curve on a mesh that is ready. Throws InputError, Cancelled.
[[nodiscard]] DesignedCurve drawThrough(
    const std::vector<Vec3>& picks,
    const DrawingArguments& arguments,
    const LoadedMesh& loaded,
    const Progress& progress
);

}  // namespace bspline_curve::cli
