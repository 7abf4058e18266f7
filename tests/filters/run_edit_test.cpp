// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/run_edit.h"

#include "bspline_curve/spline.h"
#include "runs_on_plates.h"
#include "surface/strict_line.h"
#include "surface/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

/// A layer of a curve as hosts with layers have it.
PolylineLayer layerOf(const Curve& curve, const std::string& label, int id) {
    PolylineLayer layer;
    layer.label = label;
    layer.points = curve.polyline.points;
    const auto count = static_cast<int>(layer.points.size());
    for (int i = 0; i + 1 < count; ++i) {
        layer.edges.push_back({i, i + 1});
    }
    if (curve.polyline.closed) {
        layer.edges.push_back({count - 1, 0});
    }
    layer.places = curve.polyline.surfacePoints;
    layer.drawnOn = checksumOf(plateLayer().mesh);
    layer.drawn = std::make_shared<const Curve>(curve);
    layer.id = id;
    return layer;
}

Curve drawnThrough(const std::vector<Vec3>& picks, bool closed = false) {
    CurveRequest request;
    request.solver.closed = closed;
    WorkpieceCache workpieces;
    return runCurveFilter(plateLayer(), {.tool = picks, .layer = {}}, request, workpieces).curve;
}

const std::vector<Vec3> kLeft = {{0.1, 0.2, 0.0}, {0.25, 0.3, 0.0}, {0.4, 0.25, 0.0}};
const std::vector<Vec3> kRight = {{0.9, 0.3, 0.0}, {0.7, 0.4, 0.0}, {0.45, 0.25, 0.0}};

CurvesOnLayer layersOnPlate(std::vector<PolylineLayer> curves) {
    CurvesOnLayer input{.surface = plateLayer(), .checksum = {}, .curves = std::move(curves)};
    input.checksum = checksumOf(input.surface.mesh);
    return input;
}

EditRequest asked(const std::vector<std::pair<std::string, ParameterValue>>& given) {
    ParameterValues values(editFilter());
    for (const auto& [id, value] : given) {
        values.set(id, value);
    }
    return editRequest(values);
}

EditRequest askedTo(const std::string& edit) {
    return asked({{"edit", edit}});
}

EditResult edit(const CurvesOnLayer& input, const EditRequest& request) {
    WorkpieceCache workpieces;
    EditResult result = runEditFilter(input, request, workpieces);
    const Surface surface(plateLayer().mesh);
    for (const EditResult::EditedCurve& each : result.curves) {
        EXPECT_TRUE(isStrict(surface, each.curve.polyline)) << each.label;
        EXPECT_EQ(each.curve.polyline.parameters.size(), each.curve.polyline.points.size());
    }
    return result;
}

TEST(EditFilter, JoinsTheCurvesOfAllLayersByTheNearestEnds) {
    const Curve left = drawnThrough(kLeft);
    const Curve right = drawnThrough(kRight);
    const CurvesOnLayer input =
        layersOnPlate({layerOf(left, "left", 7), layerOf(right, "right", 3)});
    const EditResult result = edit(input, askedTo("join"));
    ASSERT_EQ(result.curves.size(), 1U);
    const auto& [curve, label] = result.curves.front();
    EXPECT_EQ(label, "left joined");
    EXPECT_EQ(result.usedLayers, (std::vector<int>{3, 7}));
    EXPECT_LT((positionOf(curve.spline, 0.0) - kLeft.front()).norm(), 1e-9);
    EXPECT_LT((positionOf(curve.spline, 1.0) - kRight.front()).norm(), 1e-9);
    EXPECT_EQ(figure<int>(result.figures, "curves"), 2);
    EXPECT_EQ(figure<int>(result.figures, "new_curves"), 1);
    EXPECT_GT(
        figure<double>(result.figures, "length"), lengthOf(left.polyline) + lengthOf(right.polyline)
    );
    expectPart(result.log.summary, "2 curves became 1, ");
    // A gap of 0.05 is too wide for a third of an edge, which is about 0.14 long.
    const std::string refused =
        refusal([&] { return edit(input, asked({{"gap", std::string("0.3 edges")}})); });
    expectPart(refused, "gap");
    const EditResult smooth = edit(input, asked({{"smooth", true}}));
    EXPECT_TRUE(cornersOf(smooth.curves.front().curve.spline).empty());
}

TEST(EditFilter, JoinsNothingToASingleCurve) {
    const CurvesOnLayer input = layersOnPlate({layerOf(drawnThrough(kLeft), "left", 1)});
    expectPart(refusal([&] { return edit(input, askedTo("join")); }), "there is 1 curve");
}

TEST(EditFilter, CutsCurvesWithTheirSplines) {
    const Curve whole = drawnThrough(kLeft);
    const CurvesOnLayer input = layersOnPlate({layerOf(whole, "left", 1)});
    const EditResult parts = edit(input, asked({{"edit", "split"}, {"at", "0.6,0.2"}}));
    ASSERT_EQ(parts.curves.size(), 3U);
    EXPECT_EQ(parts.curves[0].label, "left part 1");
    const std::vector<double> ends = {0.0, 0.2, 0.6, 1.0};
    for (std::size_t i = 0; i < 3; ++i) {
        const SplineData& spline = parts.curves[i].curve.spline;
        EXPECT_EQ(spline.degree, 3);
        const double middle = 0.5 * (ends[i] + ends[i + 1]);
        const Vec3 gap = positionOf(spline, 0.5) - positionOf(whole.spline, middle);
        EXPECT_LT(gap.norm(), 1e-12) << i;
    }
    EXPECT_NEAR(figure<double>(parts.figures, "length"), lengthOf(whole.polyline), 1e-12);
    const EditResult trimmed = edit(input, asked({{"edit", "trim"}, {"at", "0.2 0.6"}}));
    ASSERT_EQ(trimmed.curves.size(), 1U);
    EXPECT_EQ(trimmed.curves[0].label, "left part");
    EXPECT_EQ(trimmed.curves[0].curve.polyline.points, parts.curves[1].curve.polyline.points);
}

TEST(EditFilter, ExtendsEndsThatAreMeant) {
    const Curve curve = drawnThrough(kLeft);
    const CurvesOnLayer input = layersOnPlate({layerOf(curve, "left", 1)});
    const double length = lengthOf(curve.polyline);
    for (const auto& [ends, times] :
         {std::pair("end", 1), std::pair("start", 1), std::pair("both", 2)}) {
        const EditResult longer =
            edit(input, asked({{"edit", "extend"}, {"extension", 0.05}, {"ends", ends}}));
        EXPECT_NEAR(lengthOf(longer.curves[0].curve.polyline), length + 0.05 * times, 1e-4);
        EXPECT_EQ(longer.curves[0].label, "left longer");
    }
    // 2 % of the diagonal unless something else is said.
    const EditResult longer = edit(input, askedTo("extend"));
    EXPECT_NEAR(lengthOf(longer.curves[0].curve.polyline), length + 0.02 * std::sqrt(2.0), 1e-4);
}

TEST(EditFilter, TurnsClosedCurvesRoundToo) {
    const std::vector<Vec3> ring = {
        {0.3, 0.3, 0.0}, {0.7, 0.35, 0.0}, {0.65, 0.7, 0.0}, {0.3, 0.65, 0.0}
    };
    const Curve curve = drawnThrough(ring, true);
    const CurvesOnLayer input = layersOnPlate({layerOf(curve, "ring", 1)});
    const EditResult result = edit(input, askedTo("reverse"));
    ASSERT_EQ(result.curves.size(), 1U);
    EXPECT_TRUE(result.curves[0].curve.polyline.closed);
    for (const double t : {0.1, 0.4, 0.8}) {
        const Vec3 gap =
            positionOf(result.curves[0].curve.spline, t) - positionOf(curve.spline, 1.0 - t);
        EXPECT_LT(gap.norm(), 1e-12);
    }
}

TEST(EditFilter, TakesPolylinesWithoutASpline) {
    PolylineLayer line = layerOf(drawnThrough(kLeft), "left", 1);
    // One that was moved is no longer the curve that it was drawn as.
    line.points[4] += Vec3(0.0, 0.02, 0.0);
    const EditResult result =
        edit(layersOnPlate({line}), asked({{"edit", "split"}, {"at", "0.5"}}));
    ASSERT_EQ(result.curves.size(), 2U);
    EXPECT_EQ(result.curves[0].curve.spline.degree, 1);
    EXPECT_EQ(figure<int>(result.figures, "projected_curves"), 1);
    expectPart(result.log.summary, "1 curve, 1 of them projected, became 2, together ");
}

TEST(EditRequest, RefusesParametersThatAreNone) {
    for (const char* const text : {"", "1.5", "-0.1", "a", "0.2;0.4", "nan"}) {
        for (const char* const edit : {"split", "trim"}) {
            const std::string said = refusal([&] { return asked({{"edit", edit}, {"at", text}}); });
            EXPECT_TRUE(said.starts_with("at is ")) << said;
        }
    }
    expectPart(refusal([] { return asked({{"edit", "trim"}, {"at", "0.5"}}); }), "two parameters");
    EXPECT_EQ(asked({{"edit", "join"}, {"at", "a"}}).edit, CurveEdit::Join);  // not looked at
    expectPart(refusal([] { return asked({{"gap", "wide"}}); }), "gap is \"wide\"");
}

}  // namespace
}  // namespace bspline_curve
