// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/prepared_mesh.h"

#include "bspline_curve/progress.h"
#include "cli/interrupt.h"
#include "cli/mesh_input.h"
#include "cli/process_figures.h"
#include "cli/shell_cache_option.h"
#include "design/mended_designer.h"
#include "utility/stopwatch.h"

#include <optional>
#include <utility>

namespace bspline_curve::cli {

namespace {

Mended<CurveDesigner> designerFor(
    TriangleMesh given, const CurveArguments& arguments, const Progress& progress
) {
    const std::optional<ShellCache> cache = cacheUnless(arguments.noCache);
    return makeMendedDesigner(
        std::move(given), arguments.mending, arguments.shell, progress, cache ? &*cache : nullptr
    );
}

}  // namespace

LoadedMesh loadMesh(const CurveArguments& arguments) {
    LoadedMesh loaded;
    Stopwatch watch;
    loaded.mesh = readInputMesh(arguments.mesh, arguments.mending.strict);
    loaded.readSeconds = watch.lap();
    loaded.readMemoryBytes = peakMemoryBytes();
    loaded.givenVertices = loaded.mesh.mesh.vertices.size();
    loaded.givenFaces = loaded.mesh.mesh.faces.size();
    loaded.checksum = checksumOf(loaded.mesh.mesh);
    throwIfInterrupted();
    return loaded;
}

PreparedMesh::PreparedMesh(
    LoadedMesh from, const CurveArguments& arguments, const Progress& progress
)
    : loaded(std::move(from)),
      mended(designerFor(std::move(loaded.mesh.mesh), arguments, progress)) {
    const StageSeconds stages = designer().seconds();
    seconds = stages.validate + stages.tree + stages.shell;
}

}  // namespace bspline_curve::cli
