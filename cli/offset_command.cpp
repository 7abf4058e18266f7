// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve offset MESH --curve FILE --distance D …: curves beside curves.
#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "cli/reports/offset_report.h"
#include "cli/result_files.h"
#include "cli/use_input.h"
#include "cli/value_checks.h"
#include "cli/verb_parser.h"
#include "utility/stopwatch.h"

#include <algorithm>
#include <limits>

namespace bspline_curve::cli {

namespace {

struct OffsetArguments : UseArguments {
    std::filesystem::path band;  ///< empty: none asked for
    OffsetRequest request;
    LengthUnit unit = LengthUnit::Millimetre;
};

struct OffsetParser {
    OffsetParser() {
        using Limits = std::numeric_limits<double>;
        app.add_option(
               "--distance",
               distance,
               "Distance from the curve along the surface, in the mesh's unit"
        )
            ->required()
            ->check(
                Interval<double>{.low = 0.0, .high = Limits::max(), .withLow = false}.validator()
            )
            ->type_name("NUMBER");
        options.described.add("side");
        addOutput(
            app,
            arguments.output,
            "Offset to write: " + curveExtensions() +
                "; where it has several pieces, the longest first, further ones are FILE-2.ply, "
                "FILE-3.ply, …"
        );
        addUnit(app, arguments.unit);
        addFile(
            app,
            "--band",
            arguments.band,
            "Write the mesh with 1 for each face whose middle is within the distance, on the side "
            "asked for, else 0, as label and quality of faces",
            "FILE.ply"
        );
        addReport(
            app,
            arguments.report,
            "Write length, largest deviation and spline of each piece, and seconds"
        );
    }

    OffsetArguments finish() {
        options.finish();
        options.described.set("offset", distance);
        arguments.request = offsetRequest(options.described.values());
        return arguments;
    }

    CLI::App app{
        "Draws the lines at a distance from a curve, measured along the surface; from several "
        "curves, those\nof each. Where an offset runs into itself it ends there, so that no piece "
        "crosses itself or another\nof its curve.\n\n"
        "Exit status: 0 done; 1 bad mesh or file, or no point has that distance; 2 wrong usage; "
        "130\ninterrupted by Ctrl-C. No output is written unless the status is 0.\n",
        "bspline_curve offset"
    };
    OffsetArguments arguments;
    UseOptions options{app, arguments, offsetFilter()};
    double distance = 0.0;
};

/// Says beside which curves there is nothing; refuses where that is so of all.
void checkLines(const OffsetLines& lines, const std::vector<std::filesystem::path>& files) {
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (!lines.hasBeside(i)) {
            const std::string message = files[i].string() + ": " + kNothingBeside;
            if (lines.pieces.empty()) {
                throw InputError(InputErrorCode::NoPath, message);
            }
            printError("note: " + message);
        }
    }
}

ExitCode drawBeside(const OffsetArguments& arguments, ProgressBar& bar) {
    checkOutput(arguments.output, checkCurveExtension);
    checkOutput(arguments.band, checkHoldsLabels);
    checkOutput(arguments.report);
    constexpr double kReadShare = 0.3;
    const OffsetRequest& request = arguments.request;
    const CurvesOnMesh read = curvesOnMesh(arguments, request.use.placing, bar, kReadShare);
    Stopwatch watch;
    const OffsetLines lines = linesBeside(
        read.workpiece(),
        read.lines,
        request.offset,
        !arguments.band.empty(),
        progressPart(bar, kReadShare, 1.0)
    );
    bar.clear();
    checkLines(lines, read.files);
    const double offsetSeconds = watch.lap();
    ResultFiles files;
    std::filesystem::path last;
    std::vector<FittedLine> pieces;
    for (const auto& [piece, curve] : lines.pieces) {
        last = files.nextAfter(arguments.output);
        const Curve drawn{
            .polyline = piece.line, .spline = piece.spline, .report = {}, .shell = {}
        };
        files.add(last, curveBytes(last, drawn, {}, read.workpiece().checksum(), arguments.unit));
        pieces.push_back(piece);
    }
    files.replaceSeries(arguments.output);
    if (!arguments.band.empty()) {
        const std::vector<int> labels(lines.band.begin(), lines.band.end());
        files.add(
            arguments.band,
            meshBytes(arguments.band, read.workpiece().mesh(), {.faceLabels = labels})
        );
    }
    if (!arguments.report.empty()) {
        files.add(
            arguments.report,
            offsetReportBytes(pieces, request.offset, read.drawSeconds, offsetSeconds)
        );
    }
    files.commit();
    printRemoved(files.stale());
    bar.tell(arguments.output, describeSeries(pieces.size(), "curve", "curves", last));
    return ExitCode::Success;
}

}  // namespace

ExitCode runOffset(Arguments arguments) {
    return runParsed<OffsetParser>(arguments, drawBeside);
}

}  // namespace bspline_curve::cli
