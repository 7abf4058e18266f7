// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/run_filters.h"

#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "filters/filter_description.h"
#include "filters/labels.h"
#include "filters/parameter_values.h"
#include "filters/requests.h"
#include "filters/runs_on_plates.h"
#include "io/temporary_files.h"
#include "support/meshes.h"
#include "surface/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <new>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

TEST(RunCurveFilter, DrawsThroughThePicksOfTheTool) {
    const CurveResult result = draw(plateLayer(), {});
    const SurfacePolyline& line = result.curve.polyline;
    ASSERT_EQ(line.picks.size(), kPicks.size());
    for (std::size_t i = 0; i < kPicks.size(); ++i) {
        EXPECT_LT((line.points[line.picks[i]] - kPicks[i]).norm(), 1e-9);
    }
    EXPECT_TRUE(figure<bool>(result.figures, "usable"));
    EXPECT_EQ(figure<int>(result.figures, "vertices"), static_cast<int>(line.points.size()));
    EXPECT_EQ(
        figure<std::vector<double>>(result.figures, "control_points").size(),
        3 * result.curve.spline.controlPoints.size()
    );
    EXPECT_EQ(result.quality, line.parameters);
    EXPECT_TRUE(result.log.warnings.empty());
}

TEST(RunCurveFilter, NamesEachFigureOnceAndLogsThoseThatAreNoLists) {
    const CurveResult result = draw(plateLayer(), {});
    std::set<std::string> names;
    expectPart(result.log.figures, "shell=fibres field=none usable=true ");
    for (const Figure& each : result.figures) {
        EXPECT_TRUE(names.insert(each.name).second) << each.name;
        const bool isList = std::holds_alternative<std::vector<double>>(each.value);
        EXPECT_NE(result.log.figures.find(" " + each.name + "=") == std::string::npos, !isList)
            << each.name;
    }
}

TEST(RunCurveFilter, KeepsTheDesignerForTheNextCurve) {
    WorkpieceCache designers;
    const CurveResult first = draw(plateLayer(), {}, designers);
    const CurveResult second = draw(plateLayer(), {}, designers);
    EXPECT_FALSE(figure<bool>(first.figures, "surface_kept"));
    EXPECT_TRUE(figure<bool>(second.figures, "surface_kept"));
    EXPECT_EQ(figure<double>(second.figures, "seconds_shell"), 0.0);
    expectPart(second.log.figures, " shell_cached=false surface_kept=true ");
    EXPECT_EQ(first.curve.polyline.points, second.curve.polyline.points);
}

TEST(RunCurveFilter, FollowsAMeshThatChanged) {
    WorkpieceCache designers;
    LayerInput layer = plateLayer();
    static_cast<void>(draw(layer, {}, designers));
    for (Vec3& vertex : layer.mesh.vertices) {
        vertex.z() += 0.001;
    }
    const CurveResult moved = draw(layer, {}, designers);
    EXPECT_FALSE(figure<bool>(moved.figures, "surface_kept"));
    for (const Vec3& point : moved.curve.polyline.points) {
        EXPECT_DOUBLE_EQ(point.z(), 0.001);
    }
}

TEST(RunCurveFilter, CarriesTheFieldToTheVertices) {
    LayerInput layer = plateLayer();
    for (const Vec3& vertex : layer.mesh.vertices) {
        layer.quality.push_back(2.0 * vertex.x() + vertex.y());
    }
    CurveRequest request;
    request.field = FieldRequest{.options = {.kind = FieldKind::Quality}};
    request.solver.fieldWeight = 1.0;
    const CurveResult result = draw(layer, request);
    const std::vector<Vec3>& points = result.curve.polyline.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(result.quality[i], 2.0 * points[i].x() + points[i].y(), 1e-12);
    }
}

/// The request of a user who changed these parameters.
CurveRequest requestWith(const std::vector<std::pair<std::string, ParameterValue>>& values = {}) {
    ParameterValues all(curveFilter());
    for (const auto& [id, value] : values) {
        all.set(id, value);
    }
    return curveRequest(all);
}

TEST(RunCurveFilter, FollowsTheQualityOnlyWhereItIsAskedTo) {
    LayerInput layer = plateLayer();
    for (const Vec3& vertex : layer.mesh.vertices) {
        layer.quality.push_back(100.0 + 20.0 * std::abs(vertex.y() - 0.5));  // mapped to [0, 1]
    }
    const CurveResult automatic =
        draw(layer, requestWith({{"field", std::string(kAutomaticField)}}));
    const CurveResult asked =
        draw(layer, requestWith({{"field", std::string("quality")}, {"field_normalised", true}}));
    const CurveResult without = draw(layer, requestWith());
    EXPECT_EQ(automatic.curve.polyline.points, asked.curve.polyline.points);
    EXPECT_NE(automatic.curve.polyline.points, without.curve.polyline.points);
    expectPart(automatic.log.figures, " field=quality ");
    expectPart(without.log.figures, " field=none ");
}

TEST(RunCurveFilter, FollowsNoQualityThatSaysNothing) {
    LayerInput layer = plateLayer();
    const CurveRequest automatic = requestWith({{"field", std::string(kAutomaticField)}});
    const CurveResult without = draw(layer, automatic);
    expectPart(without.log.figures, " field=none ");
    layer.quality.assign(layer.mesh.vertices.size(), 3.0);
    EXPECT_EQ(draw(layer, automatic).curve.polyline.points, without.curve.polyline.points);
    layer.quality.front() = std::nan("");
    EXPECT_EQ(draw(layer, automatic).curve.polyline.points, without.curve.polyline.points);
}

TEST(RunCurveFilter, FollowsNoQualityThatFacesToAvoidAreNamedBy) {
    LayerInput layer = plateLayer();
    for (const Vec3& vertex : layer.mesh.vertices) {
        layer.quality.push_back(vertex.y());
    }
    const CurveResult result = draw(
        layer,
        requestWith(
            {{"field", std::string(kAutomaticField)},
             {"avoid", std::string("over-threshold")},
             {"avoid_threshold", 0.95}}
        )
    );
    expectPart(result.log.figures, " field=none ");
    EXPECT_GT(figure<int>(result.figures, "avoided_faces"), 0);
}

TEST(RunCurveFilter, TakesSelectionsAsFacesToAvoid) {
    LayerInput layer = plateLayer();
    const std::vector<Triangle>& faces = layer.mesh.faces;
    const auto isInWall = [&](int v) {
        const Vec3& p = layer.mesh.vertices[v];
        return p.x() > 0.2 && p.x() < 0.8 && p.y() < 0.3;
    };
    std::size_t wall = 0;
    for (const Triangle& face : faces) {
        layer.selectedFaces.push_back(std::ranges::all_of(face, isInWall) ? 1 : 0);
        wall += static_cast<std::size_t>(layer.selectedFaces.back());
    }
    for (int v = 0; v < static_cast<int>(layer.mesh.vertices.size()); ++v) {
        layer.selectedVertices.push_back(isInWall(v) ? 1 : 0);
    }
    ASSERT_GT(wall, 0u);
    WorkpieceCache designers;
    for (const auto by : {FaceChoice::By::SelectedFaces, FaceChoice::By::SelectedVertices}) {
        CurveRequest request;
        request.avoid.by = by;
        const std::vector<Vec3> picks = {{0.1, 0.1, 0.0}, {0.9, 0.1, 0.0}};
        const CurveResult result =
            runCurveFilter(layer, {.tool = picks, .layer = {}}, request, designers);
        EXPECT_EQ(figure<int>(result.figures, "avoided_faces"), static_cast<int>(wall));
        for (const SurfacePoint& point : result.curve.polyline.surfacePoints) {
            EXPECT_EQ(layer.selectedFaces[point.face], 0);
        }
    }
}

TEST(RunCurveFilter, SaysWhatIsMissing) {
    CurveRequest request;
    request.field = FieldRequest{.options = {.kind = FieldKind::Quality}};
    expectPart(
        refusal([&] { return draw(plateLayer(), request); }),
        "layer \"plate\" has no per-vertex quality"
    );
    request.field.reset();
    request.avoid.by = FaceChoice::By::OverThreshold;
    expectPart(refusal([&] { return draw(plateLayer(), request); }), "no per-vertex quality");
    request.field = FieldRequest{.options = {.kind = FieldKind::Obstacle}};
    expectPart(refusal([&] { return draw(plateLayer(), request); }), "region has no faces");
}

TEST(RunCurveFilter, SaysThatIdsLeaveOutDeletedElements) {
    LayerInput layer;
    layer.mesh = bowTie();
    CurveRequest request;
    request.mending.strict = true;
    expectPart(refusal([&] { return draw(layer, request); }), "vert");
    layer.hasLayersIds = false;
    expectPart(
        refusal([&] { return draw(layer, request); }), "without the layer's deleted elements)"
    );
}

/// A curve on a sphere that does not reach its tolerance.
CurveResult drawUnusable(CurveRequest request) {
    LayerInput layer;
    layer.mesh = icosphere(2);
    request.solver.distanceTolerance = 1e-9;
    request.solver.maxRounds = 1;
    request.solver.maxIterations = 1;
    WorkpieceCache designers;
    return runCurveFilter(
        layer,
        {.tool = {layer.mesh.vertices[0], layer.mesh.vertices[40]}, .layer = {}},
        request,
        designers
    );
}

TEST(RunCurveFilter, WarnsOfACurveThatIsNotUsable) {
    const CurveResult result = drawUnusable({});
    EXPECT_FALSE(figure<bool>(result.figures, "usable"));
    ASSERT_EQ(result.log.warnings.size(), 1u);
    expectPart(result.log.warnings[0], "The curve is not usable (");
}

TEST(RunCurveFilter, ReportsProgressThatNeverFallsAndCanBeCancelled) {
    WorkpieceCache designers;
    const PickCandidates picks{.tool = kPicks, .layer = {}};
    std::vector<double> fractions;
    static_cast<void>(
        runCurveFilter(plateLayer(), picks, {}, designers, [&](double fraction, const char*) {
            fractions.push_back(fraction);
            return true;
        })
    );
    ASSERT_FALSE(fractions.empty());
    EXPECT_TRUE(std::ranges::is_sorted(fractions));
    EXPECT_DOUBLE_EQ(fractions.back(), 1.0);
    EXPECT_THROW(
        static_cast<void>(runCurveFilter(
            plateLayer(), picks, {}, designers, [](double, const char*) { return false; }
        )),
        Cancelled
    );
}

// ---- what a curve leaves besides its layer ----

TEST(RunCurveFilter, LeavesNothingElseUnlessItIsAskedFor) {
    const CurveResult result = draw(plateLayer(), {});
    EXPECT_FALSE(result.tube);
    EXPECT_FALSE(result.controlPolygon);
    EXPECT_FALSE(result.shellLayers);
}

TEST(RunCurveFilter, MakesATubeAroundTheCurve) {
    CurveRequest request;
    request.tubeRadius = 0.01;
    request.solver.closed = true;
    const CurveResult result = draw(plateLayer(), request);
    ASSERT_TRUE(result.tube);
    const Surface tube(*result.tube);
    EXPECT_EQ(tube.vertexCount() - tube.faceCount() / 2, 0) << "a torus";
    for (const Vec3& vertex : tube.vertices()) {
        EXPECT_LE(std::abs(vertex.z()), 0.01 + 1e-12);
    }
    request.tubeRadius = 10.0;
    expectPart(
        refusal([&] { return draw(plateLayer(), request); }),
        "tube radius is 10, but must be at most the diagonal of the mesh, 1.414"
    );
}

TEST(RunCurveFilter, GivesTheControlPolygonWithoutRepeatedPoints) {
    CurveRequest request;
    request.controlPolygon = true;
    for (const bool closed : {false, true}) {
        request.solver.closed = closed;
        const CurveResult result = draw(plateLayer(), request);
        ASSERT_TRUE(result.controlPolygon);
        EXPECT_EQ(result.controlPolygon->closed, closed);
        const std::vector<Vec3>& points = result.controlPolygon->points;
        const std::size_t repeated = closed ? 3 : 0;
        EXPECT_EQ(points.size() + repeated, result.curve.spline.controlPoints.size());
        EXPECT_GT((points.front() - points.back()).norm(), 1e-3);
    }
}

TEST(RunCurveFilter, GivesTopAndBottomOfTheShell) {
    CurveRequest request;
    request.shellLayers = true;
    const CurveResult result = draw(plateLayer(), request);
    ASSERT_TRUE(result.shellLayers);
    EXPECT_GE(result.shellLayers->top.faces.size(), plateLayer().mesh.faces.size());
    EXPECT_GT(result.shellLayers->top.vertices.front().z(), 0.0);
    EXPECT_LT(result.shellLayers->bottom.vertices.front().z(), 0.0);
}

using SavedCurve = io_tests::FileTest;

TEST_F(SavedCurve, HasTheFormatsOfTheWriter) {
    std::string extensions;
    for (const std::string& extension : curveFilter().parameter("save").extensions) {
        extensions += (extensions.empty() ? "" : ", ") + extension;
    }
    EXPECT_EQ(extensions, curveExtensions());
}

TEST_F(SavedCurve, IsOfTheFormatOfItsExtension) {
    for (const std::string& extension : curveFilter().parameter("save").extensions) {
        CurveRequest request;
        request.saveFile = path("kurve ä" + extension).string();
        static_cast<void>(draw(plateLayer(), request));
        EXPECT_GT(std::filesystem::file_size(request.saveFile), 100u) << extension;
    }
}

TEST(RunCurveFilter, RefusesFilesThatItCannotWriteBeforeItDraws) {
    CurveRequest request;
    request.saveFile = "/no/such/folder/curve.ply";
    WorkpieceCache designers;
    const auto refused = [&] {
        return refusal([&] { return draw(plateLayer(), request, designers); });
    };
    expectPart(refused(), "/no/such/folder");
    request.saveFile = "curve.doc";
    expectPart(refused(), "\".doc\"");
}

TEST_F(SavedCurve, IsWrittenWithAWarningWhereItIsNotUsable) {
    CurveRequest request;
    request.saveFile = path("curve.ply").string();
    const CurveResult result = drawUnusable(request);
    EXPECT_TRUE(std::filesystem::exists(request.saveFile));
    EXPECT_EQ(result.log.warnings.size(), 1u);
}

// ---- picks ----

TEST(RunCurveFilter, TakesPicksFromTextAndLayerAlike) {
    WorkpieceCache designers;
    const CurveResult tool = draw(plateLayer(), {}, designers);
    CurveRequest request;
    request.picksText = "0.1 0.15 0; 0.5 0.8 0; 0.9 0.2 0";
    EXPECT_EQ(
        runCurveFilter(plateLayer(), {}, request, designers).curve.polyline.points,
        tool.curve.polyline.points
    );
    const PickCandidates layer{.tool = {}, .layer = PicksLayer{"picks", kPicks, false}};
    EXPECT_EQ(
        runCurveFilter(plateLayer(), layer, {}, designers).curve.polyline.points,
        tool.curve.polyline.points
    );
}

TEST(RunCurveFilter, PassesOverALayerWithFacesThatNobodyChose) {
    WorkpieceCache designers;
    PickCandidates picks{
        .tool = kPicks,
        .layer = PicksLayer{.label = "mesh", .points = {}, .hasFaces = true, .isOffered = true}
    };
    EXPECT_EQ(
        runCurveFilter(plateLayer(), picks, {}, designers).curve.polyline.points,
        draw(plateLayer(), {}).curve.polyline.points
    );
    const auto run = [&] { return runCurveFilter(plateLayer(), picks, {}, designers); };
    picks.layer->isOffered = false;
    expectPart(refusal(run), "\"mesh\" has faces");
    picks.layer->isOffered = true;
    picks.tool.clear();
    expectPart(refusal(run), "\"mesh\" has faces");
}

TEST(RunCurveFilter, RefusesPicksThatAreMissingOrGivenTwice) {
    WorkpieceCache designers;
    CurveRequest request;
    expectPart(
        refusal([&] { return runCurveFilter(plateLayer(), {}, request, designers); }),
        "or give one of the options picks, picks_file and picks_layer"
    );
    request.picksText = "0 0 0; 1 0 0";
    request.picksFile = "p.pp";
    const PickCandidates layer{.tool = {}, .layer = PicksLayer{"p", kPicks, false}};
    expectPart(
        refusal([&] { return runCurveFilter(plateLayer(), layer, request, designers); }),
        "more than one option: picks and picks_file and picks_layer; use one of them"
    );
    const PickCandidates mesh{.tool = {}, .layer = PicksLayer{"p", kPicks, true}};
    expectPart(
        refusal([&] { return runCurveFilter(plateLayer(), mesh, {}, designers); }),
        "picks_layer: layer \"p\" has faces"
    );
}

// ---- fields ----

TEST(RunFieldFilter, AnswersWithOneValuePerVertexAndTheirRange) {
    const LayerInput layer = plateLayer();
    FieldLayerRequest request;
    request.options.kind = FieldKind::BoundaryDistance;
    const FieldResult result = runFieldFilter(layer, request);
    EXPECT_EQ(result.values.size(), layer.mesh.vertices.size());
    EXPECT_EQ(figure<double>(result.figures, "minimum"), 0.0);
    EXPECT_EQ(figure<double>(result.figures, "maximum"), 1.0);
    expectPart(result.log.figures, "minimum=0 mean=0.");
}

TEST(DescribeFailure, SaysWhatHappened) {
    const InputError input(InputErrorCode::EmptyMesh, "no faces");
    EXPECT_EQ(describeFailure("curve", input), "no faces");
    const InputError refused(
        InputErrorCode::DegenerateFace, "flat", {}, {.kind = Remedy::Kind::Mend}
    );
    EXPECT_EQ(
        withLabels(describeFailure("curve", refused), curveFilter()),
        "flat; without the option \"Refuse broken meshes\" the mesh is mended"
    );
    const InputError parted(
        InputErrorCode::PicksOnDifferentComponents,
        "parted",
        {},
        {.kind = Remedy::Kind::Weld, .distance = 0.005}
    );
    EXPECT_EQ(
        withLabels(describeFailure("curve", parted), curveFilter()),
        "parted; the option \"Weld vertices within\" (0.005) joins these components"
    );
    EXPECT_EQ(describeFailure("field", Cancelled()), "The field was cancelled.");
    EXPECT_EQ(
        describeFailure("curve", std::bad_alloc()),
        "There is not enough memory for a curve on this mesh."
    );
    EXPECT_EQ(
        describeFailure("curve", std::runtime_error("why")), "The curve could not be made: why"
    );
}

}  // namespace
}  // namespace bspline_curve
