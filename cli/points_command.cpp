// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve points MESH --curve FILE --count N …: points at distances along curves.
#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "bspline_curve/lines.h"
#include "cli/result_files.h"
#include "cli/use_input.h"
#include "cli/value_checks.h"
#include "cli/verb_parser.h"
#include "filters/imprint_requests.h"
#include "text/error_messages.h"

#include <optional>
#include <vector>

namespace bspline_curve::cli {

namespace {

struct PointsArguments : UseArguments {
    int count = 0;                  ///< 0: not said
    std::vector<double> distances;  ///< empty: not said
    bool atPicks = false;
    CurveUse use;
};

struct PointsParser {
    PointsParser() {
        addOutput(
            app,
            arguments.output,
            std::string("Points to write: ") + kPointsExtensions +
                "; .csv and .json have distance, frame and curvature as well"
        );
        auto* const count =
            app.add_option(
                   "--count",
                   arguments.count,
                   "Number of points of each curve, at equal distances along it; those of an open "
                   "one with both ends"
            )
                ->check(atLeast(1).validator())
                ->type_name("N");
        auto* const distances =
            app.add_option(
                   "--distances",
                   arguments.distances,
                   "Distances of the points along the curve from its start, in the mesh's unit, "
                   "with commas between them"
            )
                ->delimiter(',')
                ->type_name("NUMBERS")
                ->excludes(count);
        app.add_flag("--at-picks", arguments.atPicks, "Points where the curve's picks are")
            ->excludes(count)
            ->excludes(distances);
    }

    PointsArguments finish() {
        options.finish();
        if (arguments.count == 0 && arguments.distances.empty() && !arguments.atPicks) {
            throw CLI::ValidationError("one of --count, --distances and --at-picks is required");
        }
        arguments.use = imprintRequest(options.described.values()).use;
        return arguments;
    }

    CLI::App app{
        "Places points along curves on a mesh, at equal distances (semilandmarks), at chosen ones, "
        "or at the\ncurve's picks, each with a frame (tangent, normal, left) and curvatures.\n\n"
        "Exit status: 0 done; 1 bad mesh or file, or a curve that is not on this mesh; 2 wrong "
        "usage; 130\ninterrupted by Ctrl-C. No output is written unless the status is 0.\n",
        "bspline_curve points"
    };
    PointsArguments arguments;
    UseOptions options{app, arguments, imprintFilter()};
};

std::vector<double> distancesOn(
    const PointsArguments& arguments, const SurfacePolyline& line, const std::filesystem::path& file
) {
    if (!arguments.distances.empty()) {
        return arguments.distances;
    }
    if (arguments.atPicks) {
        if (line.picks.empty()) {
            throw InputError(
                InputErrorCode::BadOption,
                file.string() + " keeps no picks; give the curve as .json, or --count"
            );
        }
        return distancesOfPicks(line);
    }
    if (arguments.count == 1 && !line.closed) {
        throw InputError(
            InputErrorCode::BadOption, "--count of an open curve must be 2 or more: its ends"
        );
    }
    return evenDistances(line, arguments.count);
}

ExitCode placePoints(const PointsArguments& arguments, ProgressBar& bar) {
    checkOutput(arguments.output, checkPointsExtension);
    const CurvesOnMesh read = curvesOnMesh(arguments, arguments.use.placing, bar, 1.0);
    const CurvePoints along(read.workpiece().mesh());
    std::vector<PointsOfCurve> curves;
    for (std::size_t i = 0; i < read.lines.size(); ++i) {
        const SurfacePolyline& line = read.lines[i];
        const std::optional<SplineData>& spline = read.splines[i];
        curves.push_back({
            .closed = line.closed,
            .points = along.at(
                line, spline ? &*spline : nullptr, distancesOn(arguments, line, read.files[i])
            ),
        });
    }
    ResultFiles files;
    files.add(arguments.output, pointsBytes(arguments.output, curves));
    bar.clear();
    files.commit();
    std::size_t count = 0;
    for (const PointsOfCurve& curve : curves) {
        count += curve.points.size();
    }
    bar.tell(arguments.output, describeCount(count, "point", "points"));
    return ExitCode::Success;
}

}  // namespace

ExitCode runPoints(Arguments arguments) {
    return runParsed<PointsParser>(arguments, placePoints);
}

}  // namespace bspline_curve::cli
