// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve edit MESH --curve FILE …: curves turned round, cut, joined and made longer.
#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "bspline_curve/pieces.h"
#include "bspline_curve/spline.h"
#include "cli/result_files.h"
#include "cli/use_input.h"
#include "cli/value_checks.h"
#include "cli/verb_parser.h"
#include "filters/imprint_requests.h"
#include "text/error_messages.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve::cli {

namespace {

struct EditArguments : UseArguments {
    bool reverses = false, joins = false;
    std::vector<double> split, trim;  ///< parameters; empty: not said
    double extension = 0.0;           ///< 0: not said
    std::string at = "end";
    JoinOptions join;
    CurveUse use;
    LengthUnit unit = LengthUnit::Millimetre;
};

struct EditParser {
    EditParser() {
        addOutput(
            app,
            arguments.output,
            "Curve to write: " + curveExtensions() +
                "; where there are several, further ones are FILE-2.json, FILE-3.json, …"
        );
        addUnit(app, arguments.unit);
        app.add_flag("--reverse", arguments.reverses, "From the end to the start");
        addParameters(
            "--trim",
            arguments.trim,
            "The part between two parameters, A,B; of a closed curve A may be more than B"
        )
            ->expected(2);
        addParameters(
            "--split",
            arguments.split,
            "The parts between parameters, with commas between them: each is a curve of its own"
        );
        app.add_flag(
            "--join",
            arguments.joins,
            "All curves as one, each joined to those before by the ends that are nearest; it goes "
            "the way of the first"
        );
        app.add_flag(
            "--smooth",
            arguments.join.isSmooth,
            "Of --join: the curves meet with one direction; else at corners"
        );
        addLength(
            "--gap",
            gap,
            "Of --join: how far apart ends may be, 0.4 or 1edge, in mean edges [1edge]"
        );
        addLength(
            "--blend",
            blend,
            "Of --smooth: how much of either curve gives way to a smooth passage [3edges]"
        );
        app.add_option(
               "--extend",
               arguments.extension,
               "Go on along the surface by this length, in the mesh's unit, as straight as the "
               "surface lets it, or to the mesh's boundary"
        )
            ->check(
                Interval<double>{
                    .low = 0.0, .high = std::numeric_limits<double>::max(), .withLow = false
                }
                    .validator()
            )
            ->type_name("NUMBER");
        app.add_option("--at", arguments.at, "Of --extend: start|end|both [end]")
            ->check(oneOf({"start", "end", "both"}))
            ->type_name("WORD");
    }

    EditArguments finish() {
        options.finish();
        const int asked = (arguments.reverses ? 1 : 0) + (arguments.joins ? 1 : 0) +
                          (arguments.split.empty() ? 0 : 1) + (arguments.trim.empty() ? 0 : 1) +
                          (arguments.extension > 0.0 ? 1 : 0);
        if (asked != 1) {
            throw CLI::ValidationError(
                "one of --reverse, --trim, --split, --join and --extend is required"
            );
        }
        const bool isOfJoin = arguments.join.isSmooth || !gap.empty() || !blend.empty();
        if (isOfJoin && !arguments.joins) {
            throw CLI::ValidationError("--smooth, --gap and --blend are for --join");
        }
        if (!gap.empty()) {
            arguments.join.gap = parseLength(gap, "gap");
        }
        if (!blend.empty()) {
            arguments.join.blend = parseLength(blend, "blend");
        }
        arguments.use = imprintRequest(options.described.values()).use;
        return arguments;
    }

    CLI::Option* addParameters(
        const std::string& flag, std::vector<double>& values, const std::string& help
    ) {
        return app.add_option(flag, values, help)
            ->delimiter(',')
            ->check(Interval<double>{.low = 0.0, .high = 1.0}.validator())
            ->type_name("NUMBERS");
    }

    void addLength(const std::string& flag, std::string& text, const std::string& help) {
        app.add_option(flag, text, help)->type_name("LENGTH");
    }

    CLI::App app{
        "Turns curves round, cuts, joins and extends them. Each result is a curve like others: a "
        "polyline\nstrictly on the mesh, and its spline, which is the same one where nothing was "
        "added.\n\n"
        "Exit status: 0 done; 1 bad mesh or file, a curve that is not on this mesh, or ends that "
        "cannot be\njoined; 2 wrong usage; 130 interrupted by Ctrl-C. No output is written unless "
        "the status is 0.\n",
        "bspline_curve edit"
    };
    EditArguments arguments;
    std::string gap, blend;  // empty: not said
    UseOptions options{app, arguments, imprintFilter()};
};

std::vector<Curve> curvesOf(const CurvesOnMesh& read) {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < read.lines.size(); ++i) {
        Curve curve;
        curve.polyline = read.lines[i];
        const std::optional<SplineData>& spline = read.splines[i];
        curve.spline = spline ? *spline : polygonSpline(read.lines[i]);
        curve.report.usable = true;
        curves.push_back(std::move(curve));
    }
    return curves;
}

std::vector<Curve> edited(
    const EditArguments& arguments,
    const Workpiece& workpiece,
    const std::vector<Curve>& curves,
    const Progress& progress
) {
    if (arguments.joins) {
        if (curves.size() < 2) {
            throw InputError(
                InputErrorCode::BadOption, "--join needs two curves or more: give --curve again"
            );
        }
        Curve whole = curves.front();
        for (std::size_t i = 1; i < curves.size(); ++i) {
            whole = joinedCurves(
                workpiece, whole, curves[i], arguments.join, stepOf(progress, i - 1, curves.size())
            );
        }
        return {whole};
    }
    std::vector<Curve> made;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const Curve& curve = curves[i];
        if (arguments.reverses) {
            made.push_back(reversedCurve(curve));
        } else if (!arguments.trim.empty()) {
            made.push_back(
                partOfCurve(workpiece, curve, arguments.trim.front(), arguments.trim.back())
            );
        } else if (!arguments.split.empty()) {
            std::ranges::move(
                partsOfCurve(workpiece, curve, arguments.split), std::back_inserter(made)
            );
        } else {
            made.push_back(extendedCurve(
                workpiece,
                curve,
                arguments.at == "end" ? 0.0 : arguments.extension,
                arguments.at == "start" ? 0.0 : arguments.extension,
                stepOf(progress, i, curves.size())
            ));
        }
    }
    return made;
}

ExitCode editAndWrite(const EditArguments& arguments, ProgressBar& bar) {
    checkOutput(arguments.output, checkCurveExtension);
    constexpr double kReadShare = 0.5;
    const CurvesOnMesh read = curvesOnMesh(arguments, arguments.use.placing, bar, kReadShare);
    const Workpiece& workpiece = read.workpiece();
    const std::vector<Curve> curves =
        edited(arguments, workpiece, curvesOf(read), progressPart(bar, kReadShare, 1.0));
    bar.clear();
    ResultFiles files;
    std::filesystem::path last;
    for (const Curve& curve : curves) {
        if (!curve.report.usable) {
            printError("note: the spline of what was added is too far from the surface");
        }
        last = files.nextAfter(arguments.output);
        files.add(last, curveBytes(last, curve, {}, workpiece.checksum(), arguments.unit));
    }
    files.replaceSeries(arguments.output);
    files.commit();
    printRemoved(files.stale());
    bar.tell(arguments.output, describeSeries(curves.size(), "curve", "curves", last));
    return ExitCode::Success;
}

}  // namespace

ExitCode runEdit(Arguments arguments) {
    return runParsed<EditParser>(arguments, editAndWrite);
}

}  // namespace bspline_curve::cli
