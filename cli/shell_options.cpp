// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/shell_options.h"

#include "cli/mesh_input.h"
#include "cli/parse_with.h"
#include "cli/shell_cache_option.h"
#include "surface/input_error.h"

namespace bspline_curve::cli {

namespace {

constexpr const char* kMain = "Options";
constexpr const char* kAdvanced = "Advanced options";

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
    addRepairOption(app, arguments.repair);
    addCacheOption(app, arguments.noCache);
}

/// The command line of one shell, and what was given on it.
class ShellParser {
public:
    ShellParser() {
        addFiles(app_, arguments_);
        addShellKind(kind_);
        addShellTargets(kind_);
        addShellOptions(shell_);
    }

    /// Throws CLI::ParseError, InputError (BadOption).
    ShellArguments parse(Arguments words) {
        // CLI11 takes them in reverse order.
        app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        if (arguments_.output.empty() && arguments_.report.empty() && !arguments_.check) {
            throw CLI::RequiredError("one of --output, --report, --check");
        }
        kind_.apply(arguments_.shell);
        shell_.apply(arguments_.shell);
        arguments_.shell.validate();
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
    OptionTable<ShellOptions> kind_{app_, kMain, arguments_.shell};
    OptionTable<ShellOptions> shell_{app_, kAdvanced};
};

}  // namespace

void addShellKind(OptionTable<ShellOptions>& table) {
    table.choice(
        "--shell",
        &ShellOptions::kind,
        Names<ShellKind>{
            {name(ShellKind::Simplified), ShellKind::Simplified},
            {name(ShellKind::FullResolution), ShellKind::FullResolution}
        },
        "Few thick prisms, or one thin prism per face"
    );
}

void addShellTargets(OptionTable<ShellOptions>& table) {
    table.number(
        "--target-thickness",
        &ShellOptions::targetThickness,
        withinAbove(0.0, 1.0),
        "Simplified: largest length of a pillar, bottom to top, relative to the longest side of "
        "the mesh's box"
    );
    table.number(
        "--target-edge-length",
        &ShellOptions::targetEdgeLength,
        withinAbove(0.0, 1.0),
        "Simplified: middle edges shorter than this are collapsed where the invariants allow it, "
        "relative to the longest side of the mesh's box"
    );
}

void addShellOptions(OptionTable<ShellOptions>& table) {
    table.number(
        "--shell-thickness",
        &ShellOptions::thickness,
        moreThan(0.0),
        "Largest distance of a full shell's top and bottom from the mesh, in mean edge lengths"
    );
    table.number(
        "--shell-smoothing-passes",
        &ShellOptions::smoothingPasses,
        atLeast(0),
        "Rounds of averaging of the shell's directions"
    );
}

std::variant<ShellArguments, ExitCode> parseShellArguments(Arguments arguments) {
    return parseWith<ShellParser>(arguments);
}

}  // namespace bspline_curve::cli
