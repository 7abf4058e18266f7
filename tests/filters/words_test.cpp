// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/edit_requests.h"
#include "filters/fit_requests.h"
#include "filters/imprint_requests.h"
#include "filters/labels.h"
#include "filters/pattern_requests.h"
#include "filters/run_curve_uses.h"
#include "filters/run_pattern.h"
#include "filters/runs_on_plates.h"
#include "filters/summaries.h"
#include "workpiece/curve_notes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

// What people read in a window: summaries and messages, with the labels of dialogs.
namespace bspline_curve {
namespace {

using namespace test_support;

void expectMatch(const std::string& text, const std::string& pattern) {
    EXPECT_TRUE(std::regex_match(text, std::regex(pattern))) << text << "\nis not: " << pattern;
}

const std::string kNumber = R"(-?\d[\d.]*(?:e[+-]\d+)?)";
const std::string kTime = " Time: " + kNumber + R"( s\.)";

std::string inQuotes(const std::string& text) {
    return "\"" + text + "\"";
}

const std::vector<const FilterDescription*>& filters() {
    static const std::vector<const FilterDescription*> all = {
        &curveFilter(),
        &fieldFilter(),
        &imprintFilter(),
        &cutFilter(),
        &segmentFilter(),
        &offsetFilter(),
        &patternFilter(),
        &fitFilter(),
        &editFilter(),
        &pointsFilter(),
        &fillFilter()
    };
    return all;
}

// ---- labels ----

void expectLabelled(const FilterDescription& filter, const ParameterDescription& parameter) {
    const std::string label = inQuotes(parameter.label);
    const ParameterDescription& other = filter.parameters.front();
    const std::string otherLabel = inQuotes(other.label);
    const auto labelled = [&](const std::string& text) { return withLabels(text, filter); };
    EXPECT_EQ(labelled(parameter.id + " is 2, but not 3"), label + " is 2, but not 3");
    EXPECT_EQ(labelled(parameter.id + " must be finite"), label + " must be finite");
    EXPECT_EQ(labelled("try the option " + parameter.id), "try the option " + label);
    std::string list = "the options ";
    list.append(other.id).append(", ").append(parameter.id).append(" and ").append(other.id);
    std::string labels = "the options ";
    labels.append(otherLabel).append(", ").append(label).append(" and ").append(otherLabel);
    EXPECT_EQ(labelled(list), labels);
    if (parameter.id.find('_') != std::string::npos) {
        EXPECT_EQ(labelled("choose " + parameter.id + "."), "choose " + label + ".");
    }
}

void expectChoicesLabelled(const FilterDescription& filter, const ParameterDescription& parameter) {
    const std::string label = inQuotes(parameter.label);
    for (const EnumOption& option : parameter.options) {
        EXPECT_EQ(
            withLabels(parameter.id + " is " + inQuotes(option.id), filter),
            label + " is " + inQuotes(option.label)
        );
    }
}

TEST(Labels, TakeThePlaceOfEveryParameterThatAMessageNames) {
    for (const FilterDescription* const filter : filters()) {
        for (const ParameterDescription& parameter : filter->parameters) {
            expectLabelled(*filter, parameter);
            expectChoicesLabelled(*filter, parameter);
        }
    }
}

/// What a request with a value below the range of a parameter is refused with; empty where it is
/// accepted.
std::string refusedBelow(const FilterDescription& filter, const ParameterDescription& parameter) {
    ParameterValues values(filter);
    const double below = parameter.min.value_or(0.0) - 1.0;
    if (parameter.type == ParameterType::Int) {
        values.set(parameter.id, static_cast<int>(below));
    } else {
        values.set(parameter.id, below);
    }
    try {
        if (&filter == &curveFilter()) {
            values.set("field", std::string("ridge"));  // else nothing of the field is asked for
            static_cast<void>(curveRequest(values));
        } else if (&filter == &fieldFilter()) {
            static_cast<void>(fieldRequest(values));
        } else if (&filter == &imprintFilter()) {
            static_cast<void>(imprintRequest(values));
        } else if (&filter == &cutFilter()) {
            static_cast<void>(cutRequest(values));
        } else if (&filter == &segmentFilter()) {
            static_cast<void>(segmentRequest(values));
        } else if (&filter == &offsetFilter()) {
            static_cast<void>(offsetRequest(values));
        } else if (&filter == &fitFilter()) {
            static_cast<void>(fitRequest(values));
        } else if (&filter == &editFilter()) {
            static_cast<void>(editRequest(values));
        } else if (&filter == &pointsFilter()) {
            static_cast<void>(pointsRequest(values));
        } else if (&filter == &fillFilter()) {
            static_cast<void>(fillRequest(values));
        } else {
            values.set("drawing", std::string("a.svg"));
            static_cast<void>(patternRequest(values));
        }
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Labels, TakeThePlaceOfEveryNumberThatIsRefused) {
    int refused = 0;
    for (const FilterDescription* const filter : filters()) {
        for (const ParameterDescription& parameter : filter->parameters) {
            if (!parameter.min) {
                continue;
            }
            const std::string message = refusedBelow(*filter, parameter);
            if (message.empty()) {
                continue;  // refused where it is used
            }
            ++refused;
            EXPECT_TRUE(withLabels(message, *filter).starts_with(inQuotes(parameter.label)))
                << filter->id << ", " << parameter.id << ": " << withLabels(message, *filter);
        }
    }
    EXPECT_GT(refused, 50);
}

TEST(Labels, LeaveWordsAndNamesOfLayersAsTheyAre) {
    for (const char* const text :
         {"picks come from more than one option",
          "the field has 3 values for 4 vertices: give one value per vertex",
          R"(layer "picks_file" is not near layer "quality": vertex 1)",
          "give a smaller size, fewer copies or another start",
          "the drawing is longer than the curve",
          "an \"unfinished quote of picks_file",
          ""}) {
        EXPECT_EQ(withLabels(text, curveFilter()), text);
    }
    const ParameterDescription& keep = cutFilter().parameter("keep");
    const auto seed = std::ranges::find(keep.options, "seed", &EnumOption::id);
    ASSERT_NE(seed, keep.options.end());
    const std::string seedLabel = inQuotes(cutFilter().parameter("seed").label);
    EXPECT_EQ(
        withLabels(R"(keep is "seed", but there are 2 points: see the option seed)", cutFilter()),
        inQuotes(keep.label) + " is " + inQuotes(seed->label) +
            ", but there are 2 points: see the option " + seedLabel
    );
}

// ---- summaries ----

TEST(Summary, OfACurveSaysHowLongAndHowNearItIs) {
    CurveRequest request;
    request.solver.closed = true;
    const CurveResult closed = draw(plateLayer(), request);
    expectMatch(
        closed.log.summary,
        "Closed curve through 3 picks, " + kNumber +
            " mesh units long, usable: its spline stays within " + kNumber +
            R"( mesh units of the surface\.)" + kTime
    );
    // The length is that of the figures, with four digits.
    const auto length = figure<double>(closed.figures, "length");
    std::smatch found;
    ASSERT_TRUE(
        std::regex_search(
            closed.log.summary, found, std::regex("picks, (" + kNumber + ") mesh units")
        )
    );
    EXPECT_NEAR(std::stod(found[1]), length, 5e-4 * length);
    EXPECT_LE(found[1].str().size(), 6U);

    LayerInput layer = plateLayer();
    for (const Vec3& vertex : layer.mesh.vertices) {
        layer.quality.push_back(vertex.x());
    }
    request.solver.closed = false;
    request.field = FieldRequest{.options = {.kind = FieldKind::Quality}};
    const CurveResult open = draw(layer, request);
    expectPart(open.log.summary, "Open curve through 3 picks, ");
    expectPart(open.log.summary, " It follows the field \"Quality\". Time: ");
}

TEST(Summary, OfACurveGivesLengthsInTheUnitOfTheMesh) {
    Curve curve;
    curve.polyline.points = {Vec3(0, 0, 0), Vec3(12345.678, 0, 0)};
    curve.polyline.picks = {0, 1};
    curve.report.usable = false;
    curve.report.maxDistance = 0.5;
    curve.report.allowedDistance = 0.1;
    curve.report.maxPickGap = 0.01;
    curve.report.meanEdgeLength = 3.0;
    curve.report.diagonal = 200.0;
    curve.report.farPart = FarPart{.from = 0.25, .to = 0.5, .faces = {7, 8}};
    EXPECT_EQ(
        curveSummary(curve, {}, {.seconds = 0.125}),
        "Open curve through 2 picks, 12350 mesh units long, not usable: its spline is up to 1.5 "
        "mesh units from the surface. Time: 0.125 s."
    );
    expectPart(
        curveSummary(curve, {}, {.isSurfaceKept = true}), " s, on a surface that was ready."
    );
    EXPECT_EQ(
        describeUnusable(curve.report),
        "the curve is not usable (round limit): the spline is up to 1.5 mesh units from the "
        "surface, the tolerance is 0.3, between t = 0.25 and 0.5 (faces 7, 8); it misses a pick "
        "by 2 mesh units; try more picks, a finer mesh or a larger distance tolerance"
    );
}

TEST(Summary, OfADetourNamesItsPicks) {
    SolveReport report;
    EXPECT_EQ(describeDetours(report), "");
    report.detours = {{.from = 1, .to = 2, .ratio = 2.0}, {.from = 4, .to = 0, .ratio = 3.5}};
    EXPECT_EQ(
        describeDetours(report),
        "behind picks 2, 5 the curve is up to 3.5 times as long as the shortest path on the "
        "mesh: what it follows or avoids leads it round"
    );
}

TEST(Summary, OfAFieldSaysItsValues) {
    LayerInput layer = plateLayer();
    for (const Vec3& vertex : layer.mesh.vertices) {
        layer.quality.push_back(vertex.x());
    }
    FieldLayerRequest request;
    request.options.kind = FieldKind::Quality;
    EXPECT_EQ(
        runFieldFilter(layer, request).log.summary,
        "Field \"Quality\" at 81 vertices: from 0 to 1, 0.5 on average."
    );
}

CurvesOnLayer squareOnPlate() {
    PolylineLayer square;
    square.label = "square";
    square.points = {{0.25, 0.25, 0}, {0.75, 0.25, 0}, {0.75, 0.75, 0}, {0.25, 0.75, 0}};
    square.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    CurvesOnLayer input{.surface = plateLayer(), .checksum = {}, .curves = {square}};
    input.checksum = checksumOf(input.surface.mesh);
    return input;
}

TEST(Summary, OfUsesOfCurvesSaysWhatCameOfThem) {
    const CurvesOnLayer input = squareOnPlate();
    const std::string imprinted =
        R"(, 1 of them projected: \d+ new vertices, \d+ divided faces, 0 crossings\. )"
        R"(2 parts, with areas of 0\.75 and 0\.25 square mesh units\.)";
    expectMatch(runImprintFilter(input, {}).log.summary, "1 curve imprinted" + imprinted + kTime);
    CutRequest cut;
    cut.words.split = true;
    expectMatch(
        runCutFilter(input, {}, cut).log.summary,
        "1 curve cut" + imprinted + R"( 2 new layers\.)" + kTime
    );
    cut.words.split = false;
    cut.words.keep = KeptParts::Largest;
    cut.words.fill = FillKind::Flat;
    expectMatch(
        runCutFilter(input, {}, cut).log.summary,
        "1 curve cut" + imprinted + R"( 1 new layer, 1 hole filled\.)" + kTime
    );
    const MeshesResult segmented = runSegmentFilter(input, {});
    expectMatch(segmented.log.summary, "1 curve imprinted" + imprinted + kTime);
    ASSERT_EQ(segmented.log.tableInWords.size(), 2U);
    expectMatch(
        segmented.log.tableInWords[1],
        R"(Part 1: area 0\.25 square mesh units, perimeter 2 mesh units, centroid \(0\.5, 0\.5, 0\), )"
        R"(\d+ faces, Euler characteristic 1\.)"
    );
}

TEST(Summary, OfOffsetsSaysDistanceAndLength) {
    OffsetRequest request;
    request.offset.distance = 0.1;
    expectMatch(
        runOffsetFilter(squareOnPlate(), request).log.summary,
        R"(Lines at 0\.1 mesh units from 1 curve: \d+ pieces, together )" + kNumber +
            " mesh units long, at that distance to " + kNumber + R"( mesh units\.)" + kTime
    );
}

TEST(Summary, OfAPatternSaysHowLengthsAreDistorted) {
    const Figures figures = {
        {"curves", 24},
        {"length", 3.25},
        {"tolerance", 0.002},
        {"largest_deviation", 0.00012345},
        {"shortest_ratio", 0.98765},
        {"longest_ratio", 1.0},
        {"seconds", 1.5},
    };
    EXPECT_EQ(
        patternSummary(figures),
        "Pattern of 24 curves, together 3.25 mesh units long, within 0.0001234 mesh units of the "
        "drawing (allowed: 0.002). Lengths are 0.9877 to 1 times those of the drawing. Time: 1.5 s."
    );
}

TEST(Log, HasFiguresForScriptsAndWordsForWindows) {
    const FilterLog log{
        .figures = "usable=true",
        .table = {"part=0 area=1"},
        .warnings = {"Take a larger max_distance."},
        .summary = "A curve.",
        .tableInWords = {"Part 0: area 1."}
    };
    const LogLines forScripts = scriptLog(log);
    EXPECT_EQ(forScripts.lines, (std::vector<std::string>{"usable=true", "part=0 area=1"}));
    EXPECT_EQ(forScripts.warnings, log.warnings);
    const LogLines forPeople = windowLog(log, cutFilter());
    EXPECT_EQ(forPeople.lines, (std::vector<std::string>{"A curve.", "Part 0: area 1."}));
    EXPECT_EQ(
        forPeople.warnings,
        (std::vector<std::string>{
            "Take a larger " + inQuotes(cutFilter().parameter("max_distance").label) + "."
        })
    );
}

}  // namespace
}  // namespace bspline_curve
