// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve imprint MESH --curve FILE …: curves as edges of the mesh.
#include "cli/command.h"
#include "cli/imprint_input.h"
#include "cli/interrupt.h"
#include "cli/parse_with.h"
#include "cli/progress_bar.h"
#include "cli/verb.h"
#include "io/atomic_file.h"
#include "io/imprint_writer.h"
#include "io/mesh_writer.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <list>
#include <string>
#include <variant>
#include <vector>

namespace bspline_curve::cli {

namespace {

struct ImprintArguments {
    ImprintInput input;
    std::filesystem::path output;
    std::filesystem::path map, report;  ///< empty: none asked for
};

class ImprintParser {
public:
    ImprintParser() {
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
    }

    /// Throws CLI::ParseError.
    ImprintArguments parse(Arguments words) {
        // CLI11 takes them in reverse order.
        app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        input_.finish();
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
    ImprintInputOptions input_{app_, arguments_.input};
};

ExitCode imprintCurves(const ImprintArguments& arguments, ProgressBar& bar) {
    checkMeshExtension(arguments.output);
    for (const std::filesystem::path& file : {arguments.output, arguments.map, arguments.report}) {
        if (!file.empty()) {
            checkWritable(file);
        }
    }
    const ImprintedFile file = readAndImprint(arguments.input, bar);
    const auto& [imprinted, origins, parts, inputQuality, quality, figures] = file;
    throwIfInterrupted();
    bar.show(0.7, "writing");
    // All files appear, or none.
    std::list<AtomicFile> files;
    files.emplace_back(
        arguments.output,
        meshBytes(
            arguments.output, imprinted.mesh, {.vertexQuality = quality, .faceLabels = parts.labels}
        )
    );
    if (!arguments.map.empty()) {
        files.emplace_back(
            arguments.map, imprintMapBytes(imprinted, origins, parts, inputQuality, quality)
        );
    }
    if (!arguments.report.empty()) {
        files.emplace_back(arguments.report, imprintReportBytes(imprinted, parts, figures));
    }
    bar.clear();
    beginWriting();
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
