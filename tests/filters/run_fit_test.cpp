// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/run_fit.h"

#include "filters/drawn_options.h"
#include "runs_on_plates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr int kCells = 24;

LayerInput fineLayer() {
    LayerInput layer;
    layer.label = "plate";
    layer.mesh = plate(kCells, kCells);
    return layer;
}

// 1 within a circle about the middle of the plate, 2 beyond a line at the right where `hasStrip`.
std::vector<int> labelsOf(const LayerInput& layer, bool hasStrip) {
    std::vector<int> labels;
    for (const Triangle& face : layer.mesh.faces) {
        const Vec3 centre = (layer.mesh.vertices[face[0]] + layer.mesh.vertices[face[1]] +
                             layer.mesh.vertices[face[2]]) /
                            3.0;
        const bool isInside = (centre - Vec3(0.45, 0.5, 0.0)).norm() < 0.25;
        labels.push_back(isInside ? 1 : hasStrip && centre.x() > 0.85 ? 2 : 0);
    }
    return labels;
}

FitResult fit(const LayerInput& layer, const std::vector<int>& labels, const FitRequest& request) {
    WorkpieceCache workpieces;
    return runFitFilter(layer, labels, request, workpieces);
}

FitRequest defaultFit() {
    return fitRequest(ParameterValues(fitFilter()));
}

TEST(FitFilter, MakesASmoothClosedCurveOfAJaggedBoundary) {
    const LayerInput layer = fineLayer();
    const FitResult result = fit(layer, labelsOf(layer, false), defaultFit());
    ASSERT_EQ(result.curves.size(), 1U);
    const Curve& curve = result.curves.front().result.curve;
    EXPECT_TRUE(curve.polyline.closed);
    EXPECT_TRUE(result.curves.front().request.solver.closed);
    for (const Vec3& p : curve.polyline.points) {
        EXPECT_NEAR((p - Vec3(0.45, 0.5, 0.0)).norm(), 0.25, 1.0 / kCells);
    }
    EXPECT_EQ(figure<int>(result.figures, "curves"), 1);
    EXPECT_EQ(figure<int>(result.figures, "closed_curves"), 1);
    EXPECT_EQ(figure<int>(result.figures, "left_out"), 0);
    EXPECT_LE(figure<double>(result.figures, "largest_deviation"), 1.5 / kCells);
    expectPart(result.log.summary, "Curves along 1 boundary, together 1.");
}

TEST(FitFilter, MakesEachBoundaryBetweenLabelsOnce) {
    const LayerInput layer = fineLayer();
    const FitResult result = fit(layer, labelsOf(layer, true), defaultFit());
    ASSERT_EQ(result.curves.size(), 2U);
    EXPECT_EQ(figure<int>(result.figures, "closed_curves"), 1);
}

TEST(FitFilter, KeepsWithinTheDeviation) {
    const LayerInput layer = fineLayer();
    ParameterValues values(fitFilter());
    values.set("deviation", std::string("0.02"));
    const FitResult result = fit(layer, labelsOf(layer, false), fitRequest(values));
    EXPECT_LE(figure<double>(result.figures, "largest_deviation"), 0.02);
}

TEST(FitFilter, MakesCurvesThatTheDrawingToolTakesUp) {
    const LayerInput layer = fineLayer();
    ParameterValues values(fitFilter());
    values.set("degree", 4);
    const FitResult result = fit(layer, labelsOf(layer, false), fitRequest(values));
    ASSERT_EQ(result.curves.size(), 1U);
    const std::optional<DrawnOptions> options = drawnOptions(result.curves.front().request);
    ASSERT_TRUE(options);
    EXPECT_EQ(options->degree, 4);
    EXPECT_TRUE(options->closed);
    EXPECT_EQ(options->field, "none");
    EXPECT_GE(result.curves.front().result.curve.polyline.picks.size(), 3U);
}

TEST(FitFilter, RefusesWhatHasNoBoundary) {
    const LayerInput layer = fineLayer();
    const std::vector<int> none(layer.mesh.faces.size(), 0);
    expectPart(refusal([&] { return fit(layer, none, defaultFit()); }), "no face is selected");
    FitRequest request = defaultFit();
    request.labels = FaceLabels::FaceQuality;
    expectPart(refusal([&] { return fit(layer, none, request); }), "the same label");
    ParameterValues values(fitFilter());
    values.set("deviation", std::string("wide"));
    expectPart(refusal([&] { return fitRequest(values); }), "deviation");
}

}  // namespace
}  // namespace bspline_curve
