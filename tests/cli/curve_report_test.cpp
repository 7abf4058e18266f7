// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/reports/curve_report.h"

#include "io/json_values.h"
#include "io/small_curve.h"
#include "io/temporary_files.h"

namespace bspline_curve::cli {

namespace {

using namespace io_tests;

Workpiece square() {
    return Workpiece({{{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {0, 4, 0}}, {{0, 1, 2}, {0, 2, 3}}});
}

nlohmann::json reportOf(const Curve& curve, const RunFigures& figures = {}) {
    return nlohmann::json::parse(reportText(curve, square(), figures));
}

}  // namespace

TEST(ReportWriter, WritesEveryFigureUnderItsName) {
    Curve curve = smallCurve(false);
    curve.report.knotsFirst = 11;
    curve.report.knotsLast = 17;
    curve.report.maxDistance = 0.04;
    curve.report.allowedDistance = 0.15;
    curve.report.maxPickGap = 1e-15;
    curve.report.newtonIterations = 42;
    curve.report.rounds = {{10, 1e6, 11, 7, MinimiseStatus::IterationLimit, 0.3}};
    curve.report.iterations = {{0, 5.0, {1, 2, 3, 4}, 0.5, 1.0}};
    curve.report.seconds.minimise = 0.25;
    RunFigures figures;
    figures.meshFile = "a.ply";
    figures.coldSeconds = 1.5;
    figures.stages.shell = 0.75;
    figures.readMemoryBytes = 1000000;
    figures.peakMemoryBytes = 3000000;
    curve.prisms = 142;
    curve.shell = ShellKind::Simplified;
    figures.shell = {.kind = ShellKind::Simplified, .isFromStore = true, .notes = {}};
    figures.notes = {"a note"};
    const auto report = reportOf(curve, figures);
    expectValues(
        report,
        {{"/status", name(SolveStatus::Converged)},
         {"/usable", true},
         {"/knots_first", 11},
         {"/knots_last", 17},
         {"/max_distance", 0.04},
         {"/allowed_distance", 0.15},
         {"/max_pick_gap", 1e-15},
         {"/newton_iterations", 42},
         {"/shell", "simplified"},
         {"/prisms", 142},
         {"/cached", true},
         {"/notes/0", "a note"},
         {"/seconds/cold", 1.5},
         {"/seconds/shell", 0.75},
         {"/seconds/minimise", 0.25},
         {"/peak_memory_bytes/read", 1000000},
         {"/peak_memory_bytes/cold", 3000000},
         {"/rounds/0/alpha", 10},
         {"/rounds/0/status", name(MinimiseStatus::IterationLimit)},
         {"/iterations/0/distance", 3},
         {"/mesh/file", "a.ply"},
         {"/mesh/vertices", 4},
         {"/mesh/diagonal", 5}}
    );
    for (const char* key : {"validate", "tree", "path", "initial", "knots", "polyline"}) {
        EXPECT_TRUE(report["seconds"].contains(key)) << key;
    }
}

TEST(ReportWriter, MeasuresTheCurveWithItsClosingSegment) {
    const double open = reportOf(smallCurve(false))["curve"]["length"];
    const double closed = reportOf(smallCurve(true))["curve"]["length"];
    const auto& points = smallCurve(true).polyline.points;
    EXPECT_DOUBLE_EQ(closed - open, (points[2] - points[0]).norm());
    EXPECT_EQ(reportOf(smallCurve(true))["curve"]["vertices"], 3);
}

TEST(ReportWriter, SaysNullWhereNoWarmTimeWasAskedFor) {
    EXPECT_TRUE(reportOf(smallCurve(false))["seconds"]["warm"].is_null());
    RunFigures figures;
    figures.warmSeconds = 0.125;
    EXPECT_EQ(reportOf(smallCurve(false), figures)["seconds"]["warm"], 0.125);
}

TEST(ReportWriter, SaysWhatACurveAvoidsAndHowClearItIs) {
    EXPECT_TRUE(reportOf(smallCurve(false))["avoid"].is_null());
    Curve curve = smallCurve(false);
    curve.report.avoidedFaces = 7;
    curve.report.clearance = 0.25;
    expectValues(reportOf(curve), {{"/avoid/faces", 7}, {"/avoid/clearance", 0.25}});
}

TEST(ReportWriter, SurvivesFileNamesThatAreNotUtf8) {
    RunFigures figures;
    figures.meshFile = "a\xff.ply";
    EXPECT_NO_THROW(reportOf(smallCurve(false), figures));
}

}  // namespace bspline_curve::cli
