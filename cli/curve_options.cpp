// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/curve_options.h"

#include "bspline_curve/error.h"
#include "bspline_curve/version.h"
#include "cli/described_options.h"
#include "cli/mesh_input.h"
#include "cli/parse_with.h"
#include "cli/shell_cache_option.h"
#include "cli/value_checks.h"
#include "filters/requests.h"
#include "io/curve_writer.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace bspline_curve::cli {

namespace {

constexpr const char* kMain = "Options";
constexpr const char* kAdvanced = "Advanced options";
constexpr const char* kFieldGroup = "Options of the field";
constexpr const char* kFieldPrefix = "--field-";

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

/// Parameters of the filter that have no meaning here: layers, selections, and files, which the
/// program has options of its own for.
constexpr std::array<std::string_view, 10> kOfHosts = {
    "surface_layer",
    "picks_layer",
    "picks_file",
    "picks",
    "field_region",
    "tube_radius",
    "save",
    "control_polygon",
    "shell_layers",
    "replace"
};

std::string groupOf(const ParameterDescription& parameter) {
    if (parameter.group == "advanced.field") {
        return kFieldGroup;
    }
    return parameter.isAdvanced() ? kAdvanced : kMain;
}

/// The command line of one curve, and what was given on it.
class CurveParser {
public:
    CurveParser() {
        app_.set_version_flag("--version", "bspline_curve " BSPLINE_CURVE_VERSION);
        addFiles(app_, arguments_);
        for (const ParameterDescription& parameter : curveFilter().parameters) {
            if (std::ranges::find(kOfHosts, parameter.id) == kOfHosts.end()) {
                options_.add(parameter.id, groupOf(parameter), extrasOf(parameter.id));
            }
        }
        addRegionOptions(app_, kFieldGroup, kFieldPrefix, arguments_.fieldRegion);
    }

    /// Throws CLI::ParseError, InputError (BadOption).
    CurveArguments parse(Arguments words) {
        // CLI11 takes them in reverse order.
        app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        if (!fieldFile_.empty()) {
            // The values of a file are treated as those of a mesh.
            options_.setDefault("field", std::string(name(FieldKind::Quality)));
        }
        const CurveRequest request = curveRequest(options_.values());
        arguments_.solver = request.solver;
        arguments_.sampling = request.sampling;
        arguments_.shell = request.shell;
        arguments_.mending = request.mending;
        setField(request);
        setAvoided(request);
        return arguments_;
    }

    [[nodiscard]] const CLI::App& app() const { return app_; }

private:
    [[nodiscard]] OptionExtras extrasOf(std::string_view id) {
        if (id == "tension") {
            return {.aliases = ",--lambda"};
        }
        if (id == "field_weight") {
            return {.aliases = ",--mu"};
        }
        if (id == "field") {
            return {.file = &fieldFile_, .fileHelp = ".npy, or a text of one number per vertex."};
        }
        if (id == "avoid_threshold") {
            return {.hasDefault = false};  // --avoid needs it
        }
        if (id == "avoid") {
            return {
                .file = &avoidFile_,
                .fileHelp = "ids of the faces from 0 on, .npy of integers or a text."
            };
        }
        return {};
    }

    void setField(const CurveRequest& request) {
        arguments_.fieldOptions.kind = FieldKind::Quality;
        if (request.field) {
            arguments_.fieldOptions = request.field->options;
            arguments_.field = request.field->automatic ? kAutomaticField
                               : fieldFile_.empty()     ? name(arguments_.fieldOptions.kind)
                                                        : fieldFile_;
        }
        checkRegion(arguments_.fieldRegion, arguments_.fieldOptions.kind, kFieldPrefix);
    }

    /// Throws CLI::ValidationError where there is a threshold without a use, or none for one.
    void setAvoided(const CurveRequest& request) {
        const bool isUnder = request.avoid == Avoid::UnderThreshold;
        const bool isOver = request.avoid == Avoid::OverThreshold;
        const bool needsThreshold = avoidFile_.empty() && (isUnder || isOver);
        if (needsThreshold != options_.isGiven("avoid_threshold")) {
            throw CLI::ValidationError(
                "--avoid-threshold is for --avoid under-threshold and --avoid over-threshold, "
                "which "
                "need it"
            );
        }
        arguments_.avoid.file = avoidFile_;
        if (needsThreshold) {
            (isUnder ? arguments_.avoid.under : arguments_.avoid.over) = request.avoidThreshold;
        }
    }

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
    std::string fieldFile_, avoidFile_;  // empty: none
    DescribedOptions options_{app_, curveFilter()};
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
