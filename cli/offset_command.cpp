// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve offset MESH --curve FILE --distance D …: curves beside curves.
#include "bspline_curve/error.h"
#include "bspline_curve/shell.h"
#include "cli/command.h"
#include "cli/curve_input.h"
#include "cli/interrupt.h"
#include "cli/numbered_file.h"
#include "cli/parse_with.h"
#include "cli/progress_bar.h"
#include "cli/value_checks.h"
#include "cli/verb.h"
#include "design/curve_on_given_mesh.h"
#include "io/atomic_file.h"
#include "io/curve_writer.h"
#include "io/mesh_writer.h"
#include "io/offset_report.h"
#include "io/text_parsing.h"
#include "offset/offset_curves.h"
#include "shell/extended_surface.h"
#include "utility/report_progress.h"
#include "utility/stopwatch.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <limits>
#include <list>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace bspline_curve::cli {

namespace {

struct OffsetArguments {
    CurveInput input;
    std::filesystem::path output;
    std::filesystem::path band, report;  ///< empty: none asked for
    OffsetOptions offset;
};

class OffsetParser {
public:
    OffsetParser() {
        app_.add_option(
                "--distance",
                arguments_.offset.distance,
                "Distance from the curve along the surface, in the mesh's unit"
        )
            ->required()
            ->check(
                Interval<double>{
                    .low = 0.0, .high = std::numeric_limits<double>::max(), .withLow = false
                }
                    .validator()
            )
            ->type_name("NUMBER");
        app_.add_option(
                "--side",
                side_,
                "left, right (seen along the curve, the surface's normal upwards) or both, which "
                "runs round the ends of an open curve"
        )
            ->check(oneOf({"left", "right", "both"}))
            ->capture_default_str()
            ->type_name("SIDE");
        app_.add_option(
                "--output",
                arguments_.output,
                "Offset to write: " + curveExtensions() +
                    "; where it has several pieces, the longest first, further ones are "
                    "FILE-2.ply, FILE-3.ply, …"
        )
            ->required()
            ->type_name("FILE");
        app_.add_option(
                "--band",
                arguments_.band,
                "Write the mesh with 1 for each face whose middle is within the distance, on the "
                "side asked for, else 0, as label and quality of faces"
        )
            ->type_name("FILE.ply");
        app_.add_option(
                "--report",
                arguments_.report,
                "Write length, largest deviation and spline of each piece, and seconds"
        )
            ->type_name("FILE.json");
    }

    /// Throws CLI::ParseError.
    OffsetArguments parse(Arguments words) {
        // CLI11 takes them in reverse order.
        app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        input_.finish();
        arguments_.offset.sides = side_ == "left"    ? OffsetSides::Left
                                  : side_ == "right" ? OffsetSides::Right
                                                     : OffsetSides::Both;
        return arguments_;
    }

    [[nodiscard]] const CLI::App& app() const { return app_; }

private:
    CLI::App app_{
        "Draws the lines at a distance from a curve, measured along the surface; from several "
        "curves, those\nof each. Where an offset runs into itself it ends there, so that no piece "
        "crosses itself or another\nof its curve.\n\n"
        "Exit status: 0 done; 1 bad mesh or file, or no point has that distance; 2 wrong usage; "
        "130\ninterrupted by Ctrl-C. No output is written unless the status is 0.\n",
        "bspline_curve offset"
    };
    OffsetArguments arguments_;
    CurveInputOptions input_{app_, arguments_.input};
    std::string side_ = "both";
};

/// Refuses what could only fail after the work.
void checkOutputs(const OffsetArguments& arguments) {
    checkCurveExtension(arguments.output);
    checkWritable(arguments.output);
    if (!arguments.band.empty()) {
        if (lowerCaseExtension(arguments.band) != ".ply") {
            throw InputError(
                InputErrorCode::UnwritableFile,
                arguments.band.string() +
                    ": labels of faces are written as .ply; change the "
                    "name's end"
            );
        }
        checkWritable(arguments.band);
    }
    if (!arguments.report.empty()) {
        checkWritable(arguments.report);
    }
}

std::string bandBytes(
    const OffsetArguments& arguments, const CurvesOnMesh& read, const Progress& progress
) {
    const Surface& surface = read.surface();
    std::vector<int> labels(surface.faceCount(), 0);
    const std::vector<SurfacePolyline>& curves = read.curves();
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const std::vector<char> within =
            facesWithin(surface, curves[i], arguments.offset, stepOf(progress, i, curves.size()));
        for (std::size_t f = 0; f < within.size(); ++f) {
            labels[f] |= within[f];
        }
    }
    return meshBytes(arguments.band, surface.mesh(), {.faceLabels = labels});
}

/// Of all curves; refuses where there is none.
std::vector<FittedLine> linesBeside(
    const OffsetArguments& arguments, const CurvesOnMesh& read, const Progress& progress
) {
    const Surface& surface = read.surface();
    const ExtendedSurface extended = extendSurface(surface, ShellOptions().smoothingPasses);
    std::vector<FittedLine> pieces;
    const std::vector<SurfacePolyline>& curves = read.curves();
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const Progress step = stepOf(progress, i, curves.size());
        std::ranges::move(
            offsetCurves(surface, extended, curves[i], arguments.offset, step),
            std::back_inserter(pieces)
        );
    }
    if (pieces.empty()) {
        throw InputError(
            InputErrorCode::NoPath,
            "no point of the surface on that side is at this distance from the curve; give a "
            "smaller --distance"
        );
    }
    return pieces;
}

ExitCode draw(const OffsetArguments& arguments, ProgressBar& bar) {
    checkOutputs(arguments);
    constexpr double kReadShare = 0.3, kLinesShare = 0.9;
    const CurvesOnMesh read(arguments.input, bar, kReadShare);
    Stopwatch watch;
    bar.show(kReadShare, "measuring distances");
    const Progress progress = progressPart(bar, kReadShare, kLinesShare);
    const std::vector<FittedLine> pieces = linesBeside(arguments, read, progress);
    const double offsetSeconds = watch.lap();
    // All files appear, or none.
    std::list<AtomicFile> files;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::filesystem::path file = numberedFile(arguments.output, i);
        Curve piece{
            .polyline = pieces[i].line, .spline = pieces[i].spline, .report = {}, .shell = {}
        };
        bringBack(piece, read.repair());
        files.emplace_back(file, curveBytes(file, piece, {}, read.checksum()));
    }
    if (!arguments.band.empty()) {
        files.emplace_back(
            arguments.band, bandBytes(arguments, read, progressPart(bar, kLinesShare, 1.0))
        );
    }
    if (!arguments.report.empty()) {
        files.emplace_back(
            arguments.report,
            offsetReportBytes(pieces, arguments.offset, read.seconds().draw, offsetSeconds)
        );
    }
    bar.clear();
    beginWriting();
    for (AtomicFile& file : files) {
        file.commit();
    }
    if (pieces.size() > 1) {
        std::cerr << "bspline_curve: the offset has " << pieces.size() << " pieces, the last in "
                  << numberedFile(arguments.output, pieces.size() - 1).string() << '\n';
    }
    return ExitCode::Success;
}

}  // namespace

ExitCode runOffset(Arguments arguments) {
    const auto parsed = parseWith<OffsetParser>(arguments);
    if (const auto* const code = std::get_if<ExitCode>(&parsed)) {
        return *code;
    }
    const auto& offset = std::get<OffsetArguments>(parsed);
    return runVerb([&](ProgressBar& bar) { return draw(offset, bar); });
}

}  // namespace bspline_curve::cli
