// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/curve_options.h"

#include "bspline_curve/files.h"
#include "bspline_curve/version.h"
#include "cli/value_checks.h"
#include "cli/verb_parser.h"
#include "text/text_parsing.h"

namespace bspline_curve::cli {

namespace {

void addFiles(CLI::App& app, CurveArguments& arguments) {
    addMesh(app, arguments.mesh);
    const std::string picks = "Points to pass through, in order: " + std::string(kPicksExtensions) +
                              "; -: standard input, as .json";
    orStandardStream(addFile(app, "--picks", arguments.picks, picks), ".json")->required();
    addOutput(
        app,
        arguments.output,
        "Curve to write: " + curveExtensions() +
            "; for trimesh: .ply, meshio: .vtu, PyVista and ParaView: .vtu or .obj, CAD: .step "
            "(docs/FILES.md)"
    );
    addUnit(app, arguments.unit);
    addReport(
        app,
        arguments.report,
        "Write times, figures and energies as .json; also of a curve that is not usable"
    );
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
    addCacheOption(app, arguments.noCache);
}

}  // namespace

CurveParser::CurveParser()
    : app("Draws a smooth B-spline curve through picked points on a triangle mesh and writes it as "
          "a\npolyline whose every segment lies in one face. The verb \"curve\" may be left "
          "out.\n\n"
          "Exit status: 0 done; 1 bad mesh, picks or file; 2 wrong usage;\n"
          "130 interrupted by Ctrl-C. No output is written unless the status is 0.\n",
          "bspline_curve curve") {
    app.set_version_flag("--version", "bspline_curve " BSPLINE_CURVE_VERSION);
    addFiles(app, arguments);
    drawing.add();
}

CurveArguments CurveParser::finish() {
    drawing.finish();
    return arguments;
}

std::vector<CurveOption> curveOptions() {
    const CurveParser parser;
    std::vector<CurveOption> options;
    for (const CLI::Option* const option : parser.app.get_options()) {
        if (option == parser.app.get_help_ptr() || option == parser.app.get_version_ptr()) {
            continue;
        }
        for (const std::string& name : option->get_lnames()) {
            options.push_back({.name = name, .isFlag = option->get_expected_max() == 0});
        }
    }
    return options;
}

CurveArguments readCurveArguments(Arguments arguments) {
    CurveParser parser;
    try {
        CurveArguments parsed = parsedBy(parser, arguments);
        for (const auto& file : {parsed.mesh, parsed.picks, parsed.output, parsed.report}) {
            if (isStandardStream(file)) {
                throw InputError(InputErrorCode::BadOption, "a job needs files in place of -");
            }
        }
        return parsed;
    } catch (const CLI::ParseError& error) {
        throw InputError(InputErrorCode::BadOption, error.what());
    }
}

}  // namespace bspline_curve::cli
