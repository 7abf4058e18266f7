// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/imprint_input.h"

#include "cli/interrupt.h"
#include "cli/mesh_input.h"
#include "cli/value_checks.h"
#include "imprint/slits.h"
#include "utility/stopwatch.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <string>

namespace bspline_curve::cli {

ImprintInputOptions::ImprintInputOptions(CLI::App& app, ImprintInput& input)
    : use_(app, input.use) {
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

ImprintedFile readAndImprint(const ImprintInput& input, ProgressBar& bar) {
    constexpr double kReadShare = 0.4;
    const CurvesOnMesh read(input.use, bar, kReadShare);
    Stopwatch watch;
    ImprintedFile result;
    ImprintFigures& figures = result.figures;
    figures.snap = input.options.snap;
    figures.readSeconds = read.seconds().read;
    figures.surfaceSeconds = read.seconds().surface;
    figures.drawSeconds = read.seconds().draw;
    throwIfInterrupted();
    bar.show(kReadShare, "imprinting");
    watch.lap();
    result.imprinted = imprint(read.surface(), read.curves(), input.options);
    figures.imprintSeconds = watch.lap();
    throwIfInterrupted();
    bar.show(0.6, "finding parts");
    result.parts = partsOf(result.imprinted);
    result.origins = originsOf(result.imprinted, read.surface(), read.repair());
    figures.repair = reportOf(read.mending());
    if (!read.quality().empty()) {
        result.quality = interpolated(result.imprinted, read.surface().faces(), read.quality());
        result.inputQuality = read.quality();
        // Copies come last.
        result.inputQuality.resize(read.checksum().vertices);
    }
    return result;
}

void saySlits(const ImprintedMesh& imprinted, const MeshParts& parts, bool isCut) {
    const std::string note = describeSlits(slitsOf(imprinted, parts), isCut);
    if (!note.empty()) {
        std::cerr << "bspline_curve: " << note << '\n';
    }
}

}  // namespace bspline_curve::cli
