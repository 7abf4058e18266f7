// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/loaded_mesh.h"

#include "bspline_curve/files.h"
#include "bspline_curve/progress.h"
#include "bspline_curve/whole_shell.h"
#include "cli/interrupt.h"
#include "cli/process_figures.h"
#include "utility/stopwatch.h"

#include <utility>

namespace bspline_curve::cli {

void LoadedMesh::prepare(const PreparingOptions& options, const Progress& progress) {
    workpiece = std::make_shared<const Workpiece>(std::move(layer.mesh), options, progress);
}

void LoadedMesh::prepareForCurves(
    const PreparingOptions& options, bool noCache, const Progress& progress
) {
    constexpr double kSurfaceShare = 0.3;
    prepare(options, partOf(progress, 0.0, kSurfaceShare));
    const Progress rest = partOf(progress, kSurfaceShare, 1.0);
    if (noCache) {
        workpiece->prepare(rest);
    } else {
        prepareWithKeptShell(*workpiece, rest);
    }
}

LoadedMesh loadMesh(const std::filesystem::path& file, bool strict) {
    Stopwatch watch;
    MeshFile read = readMeshFile(file, strict ? RepeatedVertices::Refuse : RepeatedVertices::Keep);
    LoadedMesh loaded{
        .layer =
            {.label = file.string(),
             .mesh = std::move(read.mesh),
             .quality = std::move(read.quality),
             .selectedVertices = {},
             .selectedFaces = {},
             .isFile = true},
        .workpiece = nullptr,
        .readSeconds = watch.lap(),
        .readMemoryBytes = peakMemoryBytes()
    };
    throwIfInterrupted();
    return loaded;
}

}  // namespace bspline_curve::cli
