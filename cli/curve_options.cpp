// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/curve_options.h"

#include "cli/mesh_input.h"
#include "cli/option_table.h"
#include "cli/parse_with.h"
#include "cli/shell_cache_option.h"
#include "cli/shell_options.h"
#include "io/curve_writer.h"
#include "surface/input_error.h"

#include <algorithm>
#include <string>
#include <utility>
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
    app.add_option("--output", arguments.output, "Curve to write: " + curveExtensions())
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
    app.add_option(
           "--field",
           arguments.field,
           "Per-vertex values that draw the curve to where they cost little: of the mesh "
           "(bspline_curve field --help tells the kinds; quality: of a .ply mesh), or a file, .npy "
           "or a text of one number per vertex"
    )
        ->type_name(joined(fieldKindNames()) + "|FILE");
    addRepairOption(app, arguments.repair);
    addCacheOption(app, arguments.noCache);
}

void addShape(OptionTable<SolverOptions>& table) {
    using S = SolverOptions;
    table.flag(
        "--closed", &S::closed, "Close the curve, as the picks file may ask too; at least 3 picks"
    );
    table.number("--degree", &S::degree, within(2, 4), "Polynomial degree of the spline");
    table.number("--tension,--lambda", &S::tension, within(0.0, 1.0), "0: smooth … 1: straight");
    table.number(
        "--field-weight,--mu",
        &S::fieldWeight,
        atLeast(0.0),
        "Weight of the field; no effect without --field"
    );
}

const std::string kUnderThreshold = "under-threshold";
const std::string kOverThreshold = "over-threshold";

void addAvoidance(CLI::App& app, std::string& avoid, std::optional<double>& threshold) {
    app.add_option(
           "--avoid",
           avoid,
           "Faces that the curve does not enter: a file of their ids from 0 on, .npy of integers "
           "or "
           "a text; or those over which the mean of the field (without one, of the quality of a "
           ".ply mesh) is under or over --avoid-threshold"
    )
        ->type_name(joined({kUnderThreshold, kOverThreshold, "FILE"}));
    app.add_option("--avoid-threshold", threshold, "Threshold of --avoid")->type_name("X");
}

/// Throws CLI::ValidationError where there is a threshold without a use, or none for one.
RegionArguments avoidedRegion(const std::string& avoid, std::optional<double> threshold) {
    const bool isThreshold = avoid == kUnderThreshold || avoid == kOverThreshold;
    if (isThreshold != threshold.has_value()) {
        throw CLI::ValidationError(
            "--avoid-threshold is for --avoid " + kUnderThreshold + " and --avoid " +
            kOverThreshold + ", which need it"
        );
    }
    RegionArguments region;
    if (avoid == kUnderThreshold) {
        region.under = threshold;
    } else if (avoid == kOverThreshold) {
        region.over = threshold;
    } else {
        region.file = avoid;
    }
    return region;
}

constexpr const char* kNaturalCost = "natural";

/// What a value costs; the natural cost is known once the kind is.
const Names<FieldCost>& fieldCosts() {
    static const Names<FieldCost> names{
        {"identity", FieldCost::Identity},
        {"square", FieldCost::Square},
        {"exp-minus", FieldCost::ExpMinus}
    };
    return names;
}

void addFieldCost(CLI::App& app, std::string& cost) {
    std::vector<std::string> words{kNaturalCost};
    for (const auto& [word, value] : fieldCosts()) {
        words.push_back(word);
    }
    app.add_option(
           "--field-cost",
           cost,
           "Cost of a field value x: x, x^2 or exp(-x); natural: what the kind is meant for, "
           "exp-minus for curvature, ridge and valley, square for normal variation and distances, "
           "else identity"
    )
        ->check(oneOf(words))
        ->type_name(joined(words))
        ->capture_default_str();
}

void addMargin(OptionTable<SolverOptions>& table) {
    table.number(
        "--avoid-margin",
        &SolverOptions::avoidMargin,
        withinAbove(0.0, 1.0),
        "From this far away on what is avoided pushes the curve, relative to the mesh's diagonal"
    );
}

void addSampling(OptionTable<SamplingOptions>& table) {
    table.number(
        "--samples",
        &SamplingOptions::samples,
        atLeast(0),
        "At least this many evenly spaced points, beside the crossings of mesh edges and the picks"
    );
    table.number(
        "--max-segment-length",
        &SamplingOptions::maxSegmentLength,
        atLeast(0.0),
        "No segment of the polyline longer than this, in the mesh's unit; 0: no limit"
    );
}

void addModel(OptionTable<SolverOptions>& table) {
    using S = SolverOptions;
    table.choice(
        "--bending",
        &S::bending,
        Names<Bending>{{"geodesic", Bending::Geodesic}, {"ambient", Bending::Ambient}},
        "Bend little where the surface does not force it, or altogether"
    );
    table.number(
        "--normal-bending-weight",
        &S::normalBendingWeight,
        withinAbove(0.0, 1.0),
        "Share of normal bending kept by --bending geodesic"
    );
    table.choice(
        "--initial-curve",
        &S::initialCurve,
        Names<InitialCurve>{
            {"geodesic-fit", InitialCurve::GeodesicFit},
            {"control-polygon", InitialCurve::ControlPolygon}
        },
        "First spline: a fit to the path through the picks, or Alg. 2 of the paper"
    );
    table.choice(
        "--field-guides-path",
        &S::fieldGuidesPath,
        Names<bool>{{"on", true}, {"off", false}},
        "The path through the picks goes where the field costs little, or is a geodesic"
    );
    table.choice(
        "--quadrature",
        &S::quadrature,
        Names<Quadrature>{{"cells", Quadrature::Cells}, {"samples", Quadrature::Samples}},
        "Integrals exactly cell by cell, or at evenly spaced parameters"
    );
    table.number(
        "--samples-per-span",
        &S::samplesPerSpan,
        atLeast(4),
        "Samples per knot span for --quadrature samples"
    );
    table.choice(
        "--barrier-width",
        &S::barrierWidth,
        Names<BarrierWidth>{{"full", BarrierWidth::Full}, {"tight", BarrierWidth::Tight}},
        "Upper bound of the distance barrier: 1, or Eq. (12) of the paper"
    );
}

void addEffort(OptionTable<SolverOptions>& table) {
    using S = SolverOptions;
    table.choice(
        "--distance-weight",
        &S::distanceWeight,
        Names<DistanceWeight>{
            {"schedule", DistanceWeight::Schedule}, {"adaptive", DistanceWeight::Adaptive}
        },
        "Weight of the distance: a geometric schedule, or Eq. (18) of the paper"
    );
    table.choice(
        "--interpolation",
        &S::interpolation,
        Names<Interpolation>{
            {"constraint", Interpolation::Constraint}, {"penalty", Interpolation::Penalty}
        },
        "Picks as linear constraints, or by a penalty"
    );
    table.choice(
        "--knot-rule",
        &S::knotRule,
        Names<KnotRule>{
            {"energy-and-distance", KnotRule::EnergyAndDistance},
            {"feature-function", KnotRule::FeatureFunction}
        },
        "Where to insert knots: where energy or distance asks for them, or Eq. (19)-(23)"
    );
    table.number(
        "--distance-tolerance",
        &S::distanceTolerance,
        moreThan(0.0),
        "Largest distance of spline and mesh, in average edge lengths"
    );
    table.number(
        "--minimum-span",
        &S::minimumSpan,
        withinAbove(0.0, 0.1),
        "No knot span shorter than this share of the whole parameter range"
    );
    table.number(
        "--max-rounds", &S::maxRounds, atLeast(1), "Rounds of minimisation and knot insertion"
    );
    table.number("--max-iterations", &S::maxIterations, atLeast(1), "Newton iterations per round");
}

/// The command line of one curve, and what was given on it.
class CurveParser {
public:
    CurveParser() {
        app_.set_version_flag("--version", "bspline_curve " BSPLINE_CURVE_VERSION);
        addFiles(app_, arguments_);
        addShape(shape_);
        addFieldCost(app_, fieldCost_);
        addAvoidance(app_, avoid_, avoidThreshold_);
        addMargin(shape_);
        addSampling(sampling_);
        app_.add_option(
                "--preset",
                preset_,
                "Where all other options start: what measured best, or the paper's settings"
        )
            ->check(oneOf({"default", "paper"}))
            ->type_name("default|paper")
            ->capture_default_str();
        addShellKind(shellKind_);
        addFieldOptions(field_, kFieldPrefix);
        addRegionOptions(app_, kFieldGroup, kFieldPrefix, arguments_.fieldRegion);
        addModel(advanced_);
        addEffort(advanced_);
        addShellTargets(shell_);
        addShellOptions(shell_);
    }

    /// Throws CLI::ParseError, InputError (BadOption).
    CurveArguments parse(Arguments words) {
        // CLI11 takes them in reverse order.
        app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        arguments_.solver = preset_ == "paper" ? paperPreset() : SolverOptions{};
        shape_.apply(arguments_.solver);
        advanced_.apply(arguments_.solver);
        sampling_.apply(arguments_.sampling);
        shellKind_.apply(arguments_.shell);
        shell_.apply(arguments_.shell);
        setField();
        arguments_.avoid = avoidedRegion(avoid_, avoidThreshold_);
        arguments_.solver.validate();
        arguments_.fieldOptions.validate();
        arguments_.sampling.validate();
        arguments_.shell.validate();
        return arguments_;
    }

    [[nodiscard]] const CLI::App& app() const { return app_; }

private:
    void setField() {
        field_.apply(arguments_.fieldOptions);
        FieldKind& kind = arguments_.fieldOptions.kind;
        kind = findFieldKind(arguments_.field).value_or(FieldKind::Quality);
        checkRegion(arguments_.fieldRegion, kind, kFieldPrefix);
        const auto found =
            std::ranges::find(fieldCosts(), fieldCost_, &std::pair<std::string, FieldCost>::first);
        arguments_.solver.fieldCost =
            found == fieldCosts().end() ? naturalCost(kind) : found->second;
    }

    CLI::App app_{
        "Draws a smooth B-spline curve through picked points on a triangle mesh and writes it as "
        "a\n"
        "polyline whose every segment lies in one face. The verb \"curve\" may go before the "
        "mesh;\n"
        "the other verbs are \"batch\", \"field\" and \"shell\": bspline_curve batch --help.\n\n"
        "Exit status: 0 done; 1 bad mesh, picks or file, or no usable curve; 2 wrong usage;\n"
        "130 interrupted by Ctrl-C. No output is written unless the status is 0.\n",
        "bspline_curve"
    };
    CurveArguments arguments_;
    std::string preset_ = "default";
    std::string fieldCost_ = kNaturalCost;
    std::string avoid_;  // empty: nothing
    std::optional<double> avoidThreshold_;
    OptionTable<SolverOptions> shape_{app_, kMain};
    OptionTable<SamplingOptions> sampling_{app_, kMain};
    OptionTable<FieldOptions> field_{app_, kFieldGroup};
    OptionTable<SolverOptions> advanced_{app_, kAdvanced};
    OptionTable<ShellOptions> shellKind_{app_, kMain};
    OptionTable<ShellOptions> shell_{app_, kAdvanced};
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
