// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/shell_options.h"

#include "bspline_curve/error.h"
#include "cli/conforming_grid.h"
#include "cli/described_options.h"
#include "cli/mesh_input.h"
#include "cli/parse_with.h"
#include "cli/shell_cache_option.h"
#include "filters/requests.h"
#include "io/text_parsing.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace bspline_curve::cli {

namespace {

void addFiles(CLI::App& app, ShellArguments& arguments) {
    app.add_option("MESH", arguments.mesh, "Triangle mesh: .ply, .obj, .off or .stl")
        ->required()
        ->type_name("");
    app.add_option(
           "--output",
           arguments.output,
           "Shell to write: .vtu or .msh (tetrahedra with f in [-1, 1]) or .ply (top, middle and "
           "bottom as triangles); may be left out with --report or --check"
    )
        ->type_name("FILE");
    app.add_flag(
        "--conforming-to-surface",
        arguments.isConforming,
        "Write tetrahedra of a simplified shell that the surface does not cut, made anew by "
        "TetGen: "
        "its vertices first, its faces among those of the tetrahedra; .vtu or .msh. Those of a "
        "full shell conform to the surface as they are"
    );
    app.add_option(
           "--report",
           arguments.report,
           "Write counts, thickness, times and memory as .json; also of a shell that is wrong"
    )
        ->type_name("FILE.json");
    app.add_flag(
        "--check",
        arguments.check,
        "Check every invariant of the shell with exact predicates and code of its own; exit "
        "status 1 where one does not hold"
    );
    addRepairOption(app);
    addCacheOption(app, arguments.noCache);
}

void checkConforming(const ShellArguments& arguments) {
    const char* const option = "--conforming-to-surface";
    if (arguments.output.empty()) {
        throw CLI::RequiredError("--output with --conforming-to-surface");
    }
    if (lowerCaseExtension(arguments.output) == ".ply") {
        throw CLI::ValidationError(option, "a .ply file holds no tetrahedra: use .vtu or .msh");
    }
    if (arguments.shell.kind != ShellKind::Simplified) {
        throw CLI::ValidationError(
            option, "the tetrahedra of a full shell conform to the surface as they are"
        );
    }
    if (!hasTetgen()) {
        throw CLI::ValidationError(option, "this program was built without TetGen (libtet1.5-dev)");
    }
}

/// The command line of one shell, and what was given on it.
class ShellParser {
public:
    ShellParser() {
        addFiles(app_, arguments_);
        options_.setDefault("shell", std::string(name(ShellKind::Simplified)));
        for (const char* const id :
             {"shell",
              "target_thickness",
              "target_edge_length",
              "shell_thickness",
              "shell_smoothing_passes",
              "strict",
              "weld"}) {
            options_.add(id, kMainGroup);
        }
    }

    /// Throws CLI::ParseError, InputError (BadOption).
    ShellArguments parse(Arguments words) {
        // CLI11 takes them in reverse order.
        app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        if (arguments_.output.empty() && arguments_.report.empty() && !arguments_.check) {
            throw CLI::RequiredError("one of --output, --report, --check");
        }
        const CurveRequest request = curveRequest(options_.values());
        arguments_.shell = request.shell;
        arguments_.mending = request.mending;
        if (arguments_.shell.kind == ShellKind::Local) {
            throw CLI::ValidationError(
                "--shell",
                "a local shell has no prisms, only the fibres near a curve: use simplified or full"
            );
        }
        if (arguments_.isConforming) {
            checkConforming(arguments_);
        }
        return arguments_;
    }

    [[nodiscard]] const CLI::App& app() const { return app_; }

private:
    CLI::App app_{
        "Builds the shell of a triangle mesh: prisms around the surface, every one split into six\n"
        "tetrahedra, with a piecewise affine f that is -1 at the bottom, 0 in the middle, 1 at the "
        "top.\n\n"
        "Exit status: 0 done; 1 bad mesh or file, or a check failed; 2 wrong usage; 130 "
        "interrupted\n"
        "by Ctrl-C. No output is written unless the status is 0.\n",
        "bspline_curve shell"
    };
    ShellArguments arguments_;
    DescribedOptions options_{app_, curveFilter()};
};

}  // namespace

std::variant<ShellArguments, ExitCode> parseShellArguments(Arguments arguments) {
    return parseWith<ShellParser>(arguments);
}

}  // namespace bspline_curve::cli
