// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/curve_options.h"

#include "surface/input_error.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace bspline_curve::cli {

namespace {

constexpr int kManyInt = std::numeric_limits<int>::max();
constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr const char* kAdvanced = "Advanced options";

/// An interval of numbers; its text is part of the help.
template <class Number>
struct Interval {
    Number low, high;
    bool withoutLow = false;

    [[nodiscard]] std::string text() const {
        const std::string lowText = CLI::detail::to_string(low);
        if (isUnbounded()) {
            return (withoutLow ? "> " : ">= ") + lowText;
        }
        return std::string("in ") + (withoutLow ? "(" : "[") + lowText + ", " +
               CLI::detail::to_string(high) + "]";
    }

    [[nodiscard]] bool isUnbounded() const {
        return high == std::numeric_limits<Number>::max() ||
               (std::numeric_limits<Number>::has_infinity &&
                static_cast<double>(high) == kUnbounded);
    }

    [[nodiscard]] CLI::Validator validator() const {
        const Interval self = *this;
        const auto check = [self](const std::string& word) {
            Number value{};
            if (!CLI::detail::lexical_cast(word, value)) {
                return word +
                       (std::is_integral_v<Number> ? " is not a whole number" : " is not a number");
            }
            const bool isInside = value >= self.low && value <= self.high &&
                                  !(self.withoutLow && value == self.low) &&
                                  std::isfinite(static_cast<double>(value));
            return isInside ? std::string() : word + " must be " + self.text();
        };
        return CLI::Validator(check, "");
    }
};

/// The names of an enumeration's values.
template <class Enum>
using Names = std::vector<std::pair<std::string, Enum>>;

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : "|") + word;
    }
    return text;
}

CLI::Validator oneOf(const std::vector<std::string>& words) {
    const auto check = [words](const std::string& word) {
        return std::ranges::find(words, word) != words.end()
                   ? std::string()
                   : word + " is none of " + joined(words);
    };
    return CLI::Validator(check, "");
}

/// Declares the options and keeps what was given until the preset is known.
class OptionTable {
public:
    explicit OptionTable(CLI::App& app) : app_(app) {}

    template <class Options, class Number>
    void number(
        const char* flags,
        Number Options::* member,
        const Interval<Number>& range,
        const std::string& help,
        const char* group = ""
    ) {
        const auto keep = [this, member](const Number& value) {
            overridesOf(static_cast<Options*>(nullptr)).push_back([=](Options& options) {
                options.*member = value;
            });
        };
        CLI::Option* const option =
            app_.add_option_function<Number>(flags, keep, help + " (" + range.text() + ")");
        option->check(range.validator())
            ->type_name(std::is_integral_v<Number> ? "N" : "X")
            ->default_str(CLI::detail::to_string(Options{}.*member));
        toGroup(option, group);
    }

    template <class Enum>
    void choice(
        const char* flags,
        Enum SolverOptions::* member,
        const Names<Enum>& names,
        const std::string& help,
        const char* group = ""
    ) {
        const auto keep = [this, member, names](const std::string& word) {
            for (const auto& [name, value] : names) {
                if (name == word) {
                    solverOverrides_.push_back([=](SolverOptions& options) {
                        options.*member = value;
                    });
                }
            }
        };
        std::vector<std::string> words;
        for (const auto& [name, value] : names) {
            words.push_back(name);
        }
        CLI::Option* const option = app_.add_option_function<std::string>(flags, keep, help);
        option->check(oneOf(words))->type_name(joined(words));
        for (const auto& [name, value] : names) {
            if (value == SolverOptions{}.*member) {
                option->default_str(name);
            }
        }
        toGroup(option, group);
    }

    void flag(const char* flags, bool SolverOptions::* member, const std::string& help) {
        const auto keep = [this, member](std::int64_t count) {
            if (count > 0) {
                solverOverrides_.push_back([=](SolverOptions& options) { options.*member = true; });
            }
        };
        app_.add_flag_function(flags, keep, help);
    }

    /// The preset, then what was given explicitly.
    void apply(bool paper, CurveArguments& arguments) const {
        arguments.solver = paper ? paperPreset() : SolverOptions{};
        for (const auto& change : solverOverrides_) {
            change(arguments.solver);
        }
        for (const auto& change : shellOverrides_) {
            change(arguments.shell);
        }
        for (const auto& change : samplingOverrides_) {
            change(arguments.sampling);
        }
    }

private:
    template <class Options>
    using Overrides = std::vector<std::function<void(Options&)>>;

    Overrides<SolverOptions>& overridesOf(SolverOptions* /*tag*/) { return solverOverrides_; }

    Overrides<ShellOptions>& overridesOf(ShellOptions* /*tag*/) { return shellOverrides_; }

    Overrides<SamplingOptions>& overridesOf(SamplingOptions* /*tag*/) { return samplingOverrides_; }

    static void toGroup(CLI::Option* option, const std::string& group) {
        if (!group.empty()) {
            option->group(group);
        }
    }

    CLI::App& app_;
    Overrides<SolverOptions> solverOverrides_;
    Overrides<ShellOptions> shellOverrides_;
    Overrides<SamplingOptions> samplingOverrides_;
};

void addFiles(CLI::App& app, CurveArguments& arguments) {
    app.add_option("MESH", arguments.mesh, "Triangle mesh: .ply, .obj, .off or .stl")
        ->required()
        ->type_name("");
    app.add_option(
           "--picks",
           arguments.picks,
           "Points to pass through, in order: .pp, .json, .xyz or .csv; in the mesh's unit, at "
           "most 1 % of its diagonal from it"
    )
        ->required()
        ->type_name("FILE");
    app.add_option("--output", arguments.output, "Curve to write: .ply, .obj or .json")
        ->required()
        ->type_name("FILE");
    app.add_option(
           "--report",
           arguments.report,
           "Write figures, energies and times as .json; also for a curve that is not usable"
    )
        ->type_name("FILE.json");
    app.add_option(
           "--repeat",
           arguments.repeat,
           "Draw the curve N more times and report the median as seconds.warm (>= 0)"
    )
        ->check(Interval<int>{0, kManyInt}.validator())
        ->type_name("N")
        ->capture_default_str();
    app.add_option(
           "--field",
           arguments.field,
           "Per-vertex values that the curve avoids where high: \"quality\" (of a .ply mesh), a "
           ".npy file or a text of one number per vertex"
    )
        ->type_name("quality|FILE");
}

void addShape(OptionTable& table) {
    using S = SolverOptions;
    table.flag(
        "--closed",
        &S::closed,
        "Close the curve; also where the picks file says so. At least 3 picks"
    );
    table.number("--degree", &S::degree, {2, 4}, "Polynomial degree of the spline");
    table.number("--tension,--lambda", &S::tension, {0.0, 1.0}, "0: smooth … 1: straight");
    table.number(
        "--field-weight,--mu",
        &S::fieldWeight,
        {0.0, kUnbounded},
        "Weight of the field; no effect without --field"
    );
    table.choice<FieldCost>(
        "--field-cost",
        &S::fieldCost,
        {{"identity", FieldCost::Identity},
         {"square", FieldCost::Square},
         {"exp-minus", FieldCost::ExpMinus}},
        "Cost of a field value x: x, x² or exp(-x)"
    );
    table.number(
        "--samples",
        &SamplingOptions::samples,
        {0, kManyInt},
        "At least this many evenly spaced points on the polyline; 0: the crossings of mesh edges "
        "and the picks only"
    );
    table.number(
        "--max-segment-length",
        &SamplingOptions::maxSegmentLength,
        {0.0, kUnbounded},
        "Longest segment of the polyline, in the mesh's unit; 0: no limit"
    );
}

void addModel(OptionTable& table) {
    using S = SolverOptions;
    table.choice<Bending>(
        "--bending",
        &S::bending,
        {{"geodesic", Bending::Geodesic}, {"ambient", Bending::Ambient}},
        "What to bend little: the part that the surface does not force, or all",
        kAdvanced
    );
    table.number(
        "--normal-bending-weight",
        &S::normalBendingWeight,
        {0.0, 1.0, true},
        "Share of normal bending kept by --bending geodesic",
        kAdvanced
    );
    table.choice<InitialCurve>(
        "--initial-curve",
        &S::initialCurve,
        {{"geodesic-fit", InitialCurve::GeodesicFit},
         {"control-polygon", InitialCurve::ControlPolygon}},
        "First spline: a fit to the geodesic through the picks, or Alg. 2 of the paper",
        kAdvanced
    );
    table.choice<Quadrature>(
        "--quadrature",
        &S::quadrature,
        {{"cells", Quadrature::Cells}, {"samples", Quadrature::Samples}},
        "Integrals cell by cell, or at evenly spaced parameters",
        kAdvanced
    );
    table.number(
        "--samples-per-span",
        &S::samplesPerSpan,
        {4, kManyInt},
        "Samples per knot span for --quadrature samples",
        kAdvanced
    );
    table.choice<BarrierWidth>(
        "--barrier-width",
        &S::barrierWidth,
        {{"full", BarrierWidth::Full}, {"tight", BarrierWidth::Tight}},
        "Upper bound of the distance barrier",
        kAdvanced
    );
    table.choice<DistanceWeight>(
        "--distance-weight",
        &S::distanceWeight,
        {{"schedule", DistanceWeight::Schedule}, {"adaptive", DistanceWeight::Adaptive}},
        "Weight of the distance: a geometric schedule, or Eq. (18) of the paper",
        kAdvanced
    );
    table.choice<Interpolation>(
        "--interpolation",
        &S::interpolation,
        {{"constraint", Interpolation::Constraint}, {"penalty", Interpolation::Penalty}},
        "Picks as linear constraints, or by a penalty",
        kAdvanced
    );
}

void addEffort(OptionTable& table) {
    using S = SolverOptions;
    table.number(
        "--distance-tolerance",
        &S::distanceTolerance,
        {0.0, kUnbounded, true},
        "Largest distance of spline and surface, in average edge lengths",
        kAdvanced
    );
    table.choice<KnotRule>(
        "--knot-rule",
        &S::knotRule,
        {{"energy-and-distance", KnotRule::EnergyAndDistance},
         {"feature-function", KnotRule::FeatureFunction}},
        "Which spans get knots",
        kAdvanced
    );
    table.number(
        "--minimum-span",
        &S::minimumSpan,
        {0.0, 0.1, true},
        "No knot span shorter than this, of a parameter in [0, 1]",
        kAdvanced
    );
    table.number(
        "--max-rounds",
        &S::maxRounds,
        {1, kManyInt},
        "Rounds of minimisation and knot insertion",
        kAdvanced
    );
    table.number(
        "--max-iterations",
        &S::maxIterations,
        {1, kManyInt},
        "Newton iterations per round",
        kAdvanced
    );
    table.number(
        "--shell-thickness",
        &ShellOptions::thickness,
        {0.0, kUnbounded, true},
        "Largest distance of the shell's top and bottom from the mesh, in mean edge lengths",
        kAdvanced
    );
    table.number(
        "--shell-smoothing-passes",
        &ShellOptions::smoothingPasses,
        {0, kManyInt},
        "Rounds of averaging of the shell's directions",
        kAdvanced
    );
}

/// CLI11 takes the arguments in reverse order.
std::vector<std::string> reversed(Arguments arguments) {
    return {arguments.rbegin(), arguments.rend()};
}

/// Rules between options, and those of the core that no interval says.
void validate(const CurveArguments& arguments) {
    arguments.solver.validate();
    arguments.shell.validate();
    arguments.sampling.validate();
}

}  // namespace

std::variant<CurveArguments, ExitCode> parseCurveArguments(Arguments words) {
    CLI::App app(
        "Draws a smooth B-spline curve through picked points on a triangle mesh and writes it as "
        "a\n"
        "polyline whose every segment lies in one face.\n\n"
        "Exit status: 0 done; 1 bad mesh, picks or file, or no usable curve; 2 wrong usage;\n"
        "130 interrupted by Ctrl-C. No output is written unless the status is 0.\n",
        "bspline_curve"
    );
    app.set_version_flag("--version", "bspline_curve " BSPLINE_CURVE_VERSION);
    CurveArguments arguments;
    std::string preset = "default";
    OptionTable table(app);
    addFiles(app, arguments);
    addShape(table);
    app.add_option(
           "--preset",
           preset,
           "Where all other options start: what measured best, or the paper's settings"
    )
        ->check(oneOf({"default", "paper"}))
        ->type_name("default|paper")
        ->capture_default_str();
    addModel(table);
    addEffort(table);
    try {
        app.parse(reversed(words));
        table.apply(preset == "paper", arguments);
        validate(arguments);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {
            static_cast<void>(app.exit(error));
            return ExitCode::Success;
        }
        // CLI11 speaks of what is missing first; what is not known tells more.
        const std::vector<std::string> unknown = app.remaining();
        printError(
            (unknown.empty() ? std::string(error.what()) : "unknown argument " + unknown.front()) +
            " (bspline_curve --help lists the options)"
        );
        return ExitCode::Usage;
    } catch (const InputError& error) {
        printError(error.what());
        return ExitCode::Usage;
    }
    return arguments;
}

}  // namespace bspline_curve::cli
