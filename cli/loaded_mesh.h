// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/workpiece.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace bspline_curve::cli {

/// A mesh file, and what works on it.
struct LoadedMesh {
    LayerInput layer;  ///< its mesh is the workpiece's, once that is there
    std::shared_ptr<const Workpiece> workpiece;
    double readSeconds = 0.0;
    std::int64_t readMemoryBytes = 0;

    /// Makes the workpiece. Throws InputError, Cancelled.
    void prepare(const PreparingOptions& options, const Progress& progress = {});
    /// Likewise, ready to draw curves. `noCache`: without the shells that are kept on disk.
    void prepareForCurves(
        const PreparingOptions& options, bool noCache, const Progress& progress = {}
    );

    [[nodiscard]] std::vector<std::string> notes() const { return workpiece->notes("--strict"); }
};

/// Reads a mesh; unless `strict` also one whose faces name a vertex twice. Throws InputError,
/// Cancelled.
[[nodiscard]] LoadedMesh loadMesh(const std::filesystem::path& file, bool strict);

}  // namespace bspline_curve::cli
