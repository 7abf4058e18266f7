// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/file_checks.h"
#include "surface/types.h"

#include <filesystem>
#include <string>
#include <vector>

// vcglib's importers, kept apart from everything else. Files must have passed their check
// (file_checks.h).
namespace bspline_curve {

struct ImportedMesh {
    TriangleMesh mesh;
    std::vector<double> quality;  ///< one value per vertex, or empty
    std::string error;            ///< why the importer gave up; empty where it did not
};

/// `quality`: the stored type of the per-vertex quality, None where there is none.
[[nodiscard]] ImportedMesh importPly(const std::filesystem::path& file, PlyScalar quality);
[[nodiscard]] ImportedMesh importObj(const std::filesystem::path& file);
[[nodiscard]] ImportedMesh importStl(const std::filesystem::path& file);
[[nodiscard]] ImportedMesh importOffText(const std::string& text);

}  // namespace bspline_curve
