// SPDX-License-Identifier: GPL-3.0-or-later
// polyline_comparison MESH PICKS: times the same curve as a spline and as a polyline that is
// optimised itself (relaxPolyline), for several numbers of samples, and prints a JSON document.
#include "benchmarks/polyline_relaxation.h"
#include "bspline_curve/files.h"
#include "design/curve_designer.h"
#include "design/curve_solver.h"
#include "design/initial_path.h"
#include "design/prepared_surface.h"
#include "surface/picks.h"
#include "surface/surface.h"
#include "utility/stopwatch.h"
#include "utility/worker_task.h"
#include "utility/worker_thread.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace {

using namespace bspline_curve;
using namespace bspline_curve::benchmarks;
using Json = nlohmann::ordered_json;

// The least of several runs, in seconds: what else a machine does only ever adds.
template <class Task>
double leastTime(int repeat, const Task& task) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < repeat; ++i) {
        Stopwatch watch;
        task();
        least = std::min(least, watch.lap());
    }
    return least;
}

Json resultOf(double seconds, bool usable, std::size_t points, int steps, double internal) {
    return {
        {"seconds", seconds},
        {"usable", usable},
        {"points", points},
        {"steps", steps},
        {"internal", internal}
    };
}

Json asSpline(
    const CurveDesigner& designer,
    const std::vector<Vec3>& picks,
    const SolverOptions& options,
    int samples,
    int repeat
) {
    SamplingOptions sampling;
    sampling.samples = samples;
    Curve curve;
    const double seconds =
        leastTime(repeat, [&] { curve = designer.design(picks, options, sampling); });
    const SolveReport& report = curve.report;
    return resultOf(
        seconds,
        report.usable,
        curve.polyline.points.size(),
        report.newtonIterations,
        report.iterations.back().terms.internal
    );
}

// From the path on, as design() does. What is not in it: the way of the segments over the surface.
Json asPolyline(
    const PreparedSurface& prepared,
    const std::vector<Vec3>& picks,
    const SolverOptions& options,
    int samples,
    int repeat
) {
    RelaxedPolyline curve;
    const double seconds = leastTime(repeat, [&] {
        std::optional<WorkerThread> side;
        if (areWorthTwoThreads(prepared.surface().faces().size())) {
            side.emplace();
        }
        const std::vector<SurfacePoint> located =
            locatePicks(prepared.surface(), prepared.tree(), picks, options.closed).points;
        PathConstraints constraints;
        constraints.patches = &prepared.patches();
        constraints.side = side ? &*side : nullptr;
        const PickPath path = makePickPath(
            prepared.surface(), *prepared.extended(), located, options.closed, constraints
        );
        CurveProblem problem = makeProblem(prepared, options, path.picks);
        problem.side = constraints.side;
        curve = relaxPolyline(problem, path.path, samples);
    });
    return resultOf(
        seconds,
        curve.isWithinTolerance,
        curve.line.points.size(),
        curve.steps,
        curve.internalEnergy
    );
}

int run(int count, const char* const* words) {
    CLI::App app("Times the same curve as a spline and as an optimised polyline.");
    std::filesystem::path meshFile;
    std::filesystem::path picksFile;
    std::vector<int> samples{600, 5132};
    double tension = 0.0;
    int repeat = 5;
    app.add_option("mesh", meshFile)->required();
    app.add_option("picks", picksFile)->required();
    app.add_option("--samples", samples, "Points on the curve, each compared in turn");
    app.add_option("--tension", tension, "As of bspline_curve");
    app.add_option("--repeat", repeat, "Runs of each, of which the quickest counts");
    CLI11_PARSE(app, count, words);
    const TriangleMesh mesh = readMesh(meshFile);
    const PicksFile input = readPicks(picksFile);
    SolverOptions options;
    options.closed = input.closed.value_or(false);
    options.tension = tension;
    options.fairness = Fairness::Parametric;  // the energy of the polyline
    options.validate();
    const CurveDesigner designer(mesh);
    const PreparedSurface prepared(std::make_shared<const Surface>(mesh), {});
    Json rows = Json::array();
    for (const int number : samples) {
        rows.push_back(
            {{"samples", number},
             {"spline", asSpline(designer, input.picks, options, number, repeat)},
             {"polyline", asPolyline(prepared, input.picks, options, number, repeat)}}
        );
    }
    std::cout << Json{{"faces", mesh.faces.size()}, {"rows", rows}}.dump(1) << '\n';
    return 0;
}

}  // namespace

int main(int count, char** words) {
    try {
        return run(count, words);
    } catch (const std::exception& failure) {
        std::cerr << "polyline_comparison: " << failure.what() << '\n';
        return 1;
    }
}
