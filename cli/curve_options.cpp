// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/curve_options.h"

#include "bspline_curve/error.h"
#include "bspline_curve/version.h"
#include "cli/drawing_options.h"
#include "cli/mesh_input.h"
#include "cli/parse_with.h"
#include "cli/shell_cache_option.h"
#include "cli/value_checks.h"
#include "io/curve_writer.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace bspline_curve::cli {

namespace {

void addFiles(CLI::App& app, CurveArguments& arguments) {
    app.add_option("MESH", arguments.mesh, "Triangle mesh: .ply, .obj, .off or .stl")
        ->required()
        ->type_name("");
    app.add_option(
           "--picks",
           arguments.picks,
           "Points to pass through, in order: .pp, .json, .mrk.json, .xyz or .csv; at most 1 % of "
           "the "
           "mesh's diagonal from it"
    )
        ->required()
        ->type_name("FILE");
    app.add_option(
           "--output",
           arguments.output,
           "Curve to write: " + curveExtensions() +
               "; for trimesh: .ply, meshio: .vtu, PyVista and ParaView: .vtu or .obj "
               "(docs/FILES.md)"
    )
        ->required()
        ->type_name("FILE");
    app.add_option(
           "--report",
           arguments.report,
           "Write times, figures and energies as .json; also of a curve that is not usable"
    )
        ->type_name("FILE.json");
    app.add_option(
           "--repeat",
           arguments.repeat,
           "Draw the curve N more times and report the median time as seconds.warm (>= 0)"
    )
        ->check(atLeast(0).validator())
        ->type_name("N")
        ->capture_default_str();
    app.add_flag(
        "--require-usable",
        arguments.requireUsable,
        "Write no curve that is not usable, and exit with 1"
    );
    addRepairOption(app);
    addCacheOption(app, arguments.noCache);
}

/// The command line of one curve, and what was given on it.
class CurveParser {
public:
    CurveParser() {
        app_.set_version_flag("--version", "bspline_curve " BSPLINE_CURVE_VERSION);
        addFiles(app_, arguments_);
        drawing_.addAll();
    }

    /// Throws CLI::ParseError, InputError (BadOption).
    CurveArguments parse(Arguments words) {
        // CLI11 takes them in reverse order.
        app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        drawing_.finish();
        return arguments_;
    }

    [[nodiscard]] const CLI::App& app() const { return app_; }

private:
    CLI::App app_{
        "Draws a smooth B-spline curve through picked points on a triangle mesh and writes it as "
        "a\n"
        "polyline whose every segment lies in one face. The verb \"curve\" may go before the "
        "mesh;\n"
        "the other verbs are \"batch\", \"field\" and \"shell\": bspline_curve help batch.\n\n"
        "Exit status: 0 done; 1 bad mesh, picks or file; 2 wrong usage;\n"
        "130 interrupted by Ctrl-C. No output is written unless the status is 0.\n",
        "bspline_curve"
    };
    CurveArguments arguments_;
    DrawingOptions drawing_{app_, arguments_};
};

}  // namespace

std::variant<CurveArguments, ExitCode> parseCurveArguments(Arguments arguments) {
    return parseWith<CurveParser>(arguments);
}

std::vector<CurveOption> curveOptions() {
    const CurveParser parser;
    const CLI::App& app = parser.app();
    std::vector<CurveOption> options;
    for (const CLI::Option* const option : app.get_options()) {
        if (option == app.get_help_ptr() || option == app.get_version_ptr()) {
            continue;
        }
        for (const std::string& name : option->get_lnames()) {
            options.push_back({.name = name, .isFlag = option->get_expected_max() == 0});
        }
    }
    return options;
}

CurveArguments readCurveArguments(Arguments arguments) {
    try {
        return CurveParser().parse(arguments);
    } catch (const CLI::ParseError& error) {
        throw InputError(InputErrorCode::BadOption, error.what());
    }
}

}  // namespace bspline_curve::cli
