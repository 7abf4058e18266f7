// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/imprint_input.h"

#include "bspline_curve/progress.h"
#include "cli/interrupt.h"
#include "cli/mesh_input.h"
#include "cli/value_checks.h"
#include "io/curve_reader.h"
#include "utility/stopwatch.h"

#include <CLI/CLI.hpp>

#include <utility>

namespace bspline_curve::cli {

void addImprintOptions(CLI::App& app, ImprintInput& input) {
    app.add_option("MESH", input.mesh, "Triangle mesh: .ply, .obj, .off or .stl")
        ->required()
        ->type_name("");
    app.add_option(
           "--curve",
           input.curves,
           "Curve on this mesh, as this program writes it: .json; may be given again"
    )
        ->required()
        ->allow_extra_args(false)
        ->type_name("FILE.json");
    app.add_option(
           "--snap",
           input.options.snap,
           "Take points as one that are nearer than this, relative to the altitudes of a face; 0: "
           "only where they are one"
    )
        ->check(Interval<double>{.low = 0.0, .high = 0.01}.validator())
        ->capture_default_str()
        ->type_name("NUMBER");
}

void throwIfInterrupted() {
    if (interrupted()) {
        throw Cancelled();
    }
}

ImprintedFile readAndImprint(const ImprintInput& input, ProgressBar& bar) {
    Stopwatch watch;
    ImprintedFile result;
    ImprintFigures& figures = result.figures;
    figures.snap = input.options.snap;
    bar.show(0.0, "reading");
    constexpr bool kStrict = true;  // vertices and faces must stay those of the file
    MeshFile file = readInputMesh(input.mesh, kStrict);
    figures.readSeconds = watch.lap();
    const Surface surface(std::move(file.mesh));
    figures.surfaceSeconds = watch.lap();
    std::vector<SurfacePolyline> curves;
    const MeshChecksum checksum = checksumOf(surface.mesh());
    for (const std::filesystem::path& curve : input.curves) {
        for (SurfacePolyline& line : readCurves(curve, surface, checksum)) {
            curves.push_back(std::move(line));
        }
    }
    figures.readSeconds += watch.lap();
    throwIfInterrupted();
    bar.show(0.4, "imprinting");
    result.imprinted = imprint(surface, curves, input.options);
    figures.imprintSeconds = watch.lap();
    throwIfInterrupted();
    bar.show(0.6, "finding parts");
    result.parts = partsOf(result.imprinted);
    result.inputQuality = std::move(file.quality);
    if (!result.inputQuality.empty()) {
        result.quality = interpolated(result.imprinted, surface.faces(), result.inputQuality);
    }
    return result;
}

}  // namespace bspline_curve::cli
