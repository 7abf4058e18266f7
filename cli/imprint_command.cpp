// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve imprint MESH --curve FILE …: curves as edges of the mesh.
#include "bspline_curve/progress.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/mesh_input.h"
#include "cli/parse_with.h"
#include "cli/progress_bar.h"
#include "cli/value_checks.h"
#include "cli/verb.h"
#include "imprint/imprint.h"
#include "imprint/mesh_parts.h"
#include "io/atomic_file.h"
#include "io/curve_reader.h"
#include "io/imprint_writer.h"
#include "io/mesh_writer.h"
#include "utility/stopwatch.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <list>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace bspline_curve::cli {

namespace {

struct ImprintArguments {
    std::filesystem::path mesh, output;
    std::vector<std::filesystem::path> curves;
    std::filesystem::path map, report;  ///< empty: none asked for
    ImprintOptions imprint;
};

class ImprintParser {
public:
    ImprintParser() {
        app_.add_option("MESH", arguments_.mesh, "Triangle mesh: .ply, .obj, .off or .stl")
            ->required()
            ->type_name("");
        app_.add_option(
                "--curve",
                arguments_.curves,
                "Curve on this mesh, as this program writes it: .json; may be given again"
        )
            ->required()
            ->allow_extra_args(false)
            ->type_name("FILE.json");
        app_.add_option(
                "--output",
                arguments_.output,
                "Mesh to write: " + meshExtensions() +
                    "; .ply has the part of each face as `label`, and the quality of the input"
        )
            ->required()
            ->type_name("FILE");
        app_.add_option(
                "--map", arguments_.map, "Write where each face, vertex and curve comes from"
        )
            ->type_name("FILE.json");
        app_.add_option("--report", arguments_.report, "Write counts, parts, moves and times")
            ->type_name("FILE.json");
        app_.add_option(
                "--snap",
                arguments_.imprint.snap,
                "Take points as one that are nearer than this, relative to the altitudes of a "
                "face; 0: only where they are one"
        )
            ->check(Interval<double>{.low = 0.0, .high = 0.01}.validator())
            ->capture_default_str()
            ->type_name("NUMBER");
    }

    /// Throws CLI::ParseError.
    ImprintArguments parse(Arguments words) {
        // CLI11 takes them in reverse order.
        app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        return arguments_;
    }

    [[nodiscard]] const CLI::App& app() const { return app_; }

private:
    CLI::App app_{
        "Makes curves edges of the mesh. Vertices of the mesh come first, as they are; only faces "
        "that a\ncurve passes are divided. Curves may cross themselves and each other.\n\n"
        "Exit status: 0 done; 1 bad mesh or file, or a curve that is not on this mesh; 2 wrong "
        "usage; 130\ninterrupted by Ctrl-C. No output is written unless the status is 0.\n",
        "bspline_curve imprint"
    };
    ImprintArguments arguments_;
};

ExitCode imprintCurves(const ImprintArguments& arguments, ProgressBar& bar) {
    checkMeshExtension(arguments.output);
    for (const std::filesystem::path& file : {arguments.output, arguments.map, arguments.report}) {
        if (!file.empty()) {
            checkWritable(file);
        }
    }
    Stopwatch watch;
    ImprintFigures figures{.snap = arguments.imprint.snap};
    bar.show(0.0, "reading");
    constexpr bool kStrict = true;  // vertices and faces must stay those of the file
    MeshFile file = readInputMesh(arguments.mesh, kStrict);
    figures.readSeconds = watch.lap();
    const Surface surface(std::move(file.mesh));
    figures.surfaceSeconds = watch.lap();
    std::vector<SurfacePolyline> curves;
    for (const std::filesystem::path& curve : arguments.curves) {
        curves.push_back(readCurve(curve, surface));
    }
    figures.readSeconds += watch.lap();
    if (interrupted()) {
        throw Cancelled();
    }
    bar.show(0.4, "imprinting");
    const ImprintedMesh imprinted = imprint(surface, curves, arguments.imprint);
    figures.imprintSeconds = watch.lap();
    if (interrupted()) {
        throw Cancelled();
    }
    bar.show(0.7, "writing");
    const MeshParts parts = partsOf(imprinted);
    const std::vector<double> quality =
        file.quality.empty() ? std::vector<double>()
                             : interpolated(imprinted, surface.faces(), file.quality);
    // All files appear, or none.
    std::list<AtomicFile> files;
    files.emplace_back(
        arguments.output,
        meshBytes(
            arguments.output, imprinted.mesh, {.vertexQuality = quality, .faceLabels = parts.labels}
        )
    );
    if (!arguments.map.empty()) {
        files.emplace_back(arguments.map, imprintMapBytes(imprinted, parts, file.quality, quality));
    }
    if (!arguments.report.empty()) {
        files.emplace_back(arguments.report, imprintReportBytes(imprinted, parts, figures));
    }
    bar.clear();
    for (AtomicFile& each : files) {
        each.commit();
    }
    return ExitCode::Success;
}

}  // namespace

ExitCode runImprint(Arguments arguments) {
    const auto parsed = parseWith<ImprintParser>(arguments);
    if (const auto* const code = std::get_if<ExitCode>(&parsed)) {
        return *code;
    }
    const auto& asked = std::get<ImprintArguments>(parsed);
    return runVerb([&](ProgressBar& bar) { return imprintCurves(asked, bar); });
}

}  // namespace bspline_curve::cli
