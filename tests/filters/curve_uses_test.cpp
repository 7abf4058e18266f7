// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/run_curve_uses.h"
#include "filters/runs_on_plates.h"
#include "text/sentences.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

PolylineLayer polyline(const std::string& label, std::vector<Vec3> points, bool closed) {
    PolylineLayer layer;
    layer.label = label;
    const auto count = static_cast<int>(points.size());
    layer.points = std::move(points);
    for (int i = 0; i + 1 < count; ++i) {
        layer.edges.push_back({i, i + 1});
    }
    if (closed) {
        layer.edges.push_back({count - 1, 0});
    }
    return layer;
}

PolylineLayer square(double z = 0.0) {
    return polyline(
        "square", {{0.3, 0.3, z}, {0.7, 0.31, z}, {0.69, 0.72, z}, {0.33, 0.68, z}}, true
    );
}

CurvesOnLayer onPlate(std::vector<PolylineLayer> curves) {
    CurvesOnLayer input{.surface = plateLayer(), .checksum = {}, .curves = std::move(curves)};
    input.checksum = checksumOf(input.surface.mesh);
    return input;
}

double areaOf(const TriangleMesh& mesh) {
    double area = 0.0;
    for (const Triangle& face : mesh.faces) {
        const Vec3& a = mesh.vertices[face[0]];
        area += 0.5 * (mesh.vertices[face[1]] - a).cross(mesh.vertices[face[2]] - a).norm();
    }
    return area;
}

std::vector<double> xOf(const TriangleMesh& mesh) {
    std::vector<double> x;
    for (const Vec3& vertex : mesh.vertices) {
        x.push_back(vertex.x());
    }
    return x;
}

TEST(FillFilter, ClosesTheHolesOfAMeshWithoutCurves) {
    CurvesOnLayer input = onPlate({});
    std::vector<Triangle>& faces = input.surface.mesh.faces;
    faces.erase(faces.begin() + 108);  // no edge of it is on the boundary
    const MeshesResult filled = runFillFilter(input, {.shape = FillShape::Flat, .mostEdges = 3});
    ASSERT_EQ(filled.layers.size(), 1U);
    EXPECT_EQ(filled.layers[0].suffix, " filled");
    EXPECT_NEAR(areaOf(filled.layers[0].made.mesh()), 1.0, 1e-12);
    EXPECT_EQ(figure<int>(filled.figures, "filled_holes"), 1);
    EXPECT_EQ(figure<int>(filled.figures, "new_faces"), 1);
    expectPart(filled.log.summary, "1 hole filled, with 1 new face.");
    ASSERT_EQ(filled.log.warnings.size(), 1U);
    EXPECT_EQ(filled.log.warnings[0], "1 hole stays open.");
    FillRequest none;
    none.mostLength = 1e-3;
    expectPart(refusal([&] { return runFillFilter(input, none); }), "none of 2 holes");
}

TEST(ImprintFilter, MakesOneLayerThatKnowsWhereItComesFrom) {
    const CurvesOnLayer input = onPlate({square(0.005)});
    const MeshesResult result = runImprintFilter(input, {});
    ASSERT_EQ(result.layers.size(), 1U);
    EXPECT_EQ(result.layers[0].suffix, " imprinted");
    const MadeMesh& made = result.layers[0].made;
    const TriangleMesh& mesh = made.mesh();
    EXPECT_EQ(figure<int>(result.figures, "curves"), 1);
    EXPECT_EQ(figure<int>(result.figures, "projected_curves"), 1);
    EXPECT_EQ(figure<int>(result.figures, "parts"), 2);
    EXPECT_NEAR(areaOf(mesh), 1.0, 1e-12);
    const std::vector<double> carried = made.carried(xOf(input.surface.mesh));
    const std::vector<double> flags = made.curveFlags();
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const int id = made.vertexOf(static_cast<int>(i));
        EXPECT_NEAR(carried[i], mesh.vertices[i].x(), 1e-14);
        EXPECT_EQ(id < 0, i >= input.surface.mesh.vertices.size());
        EXPECT_TRUE(id >= 0 || flags[i] == 1.0);
    }
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const Triangle& parent = input.surface.mesh.faces[made.faceOf(static_cast<int>(f))];
        for (int k = 0; k < 3; ++k) {
            const Vec3 place = made.placeOf(static_cast<int>(f), k);
            Vec3 position = Vec3::Zero();
            for (int j = 0; j < 3; ++j) {
                position += place[j] * input.surface.mesh.vertices[parent[j]];
            }
            EXPECT_LT((position - mesh.vertices[mesh.faces[f][k]]).norm(), 1e-14);
        }
    }
}

TEST(ImprintFilter, TakesCurvesThatKnowTheirPlacesExactly) {
    CurveRequest request;
    request.solver.closed = true;
    const CurveResult drawn = draw(plateLayer(), request);
    PolylineLayer layer = polyline("curve", drawn.curve.polyline.points, true);
    layer.places = drawn.curve.polyline.surfacePoints;
    layer.drawnOn = checksumOf(plateLayer().mesh);
    CurvesOnLayer input = onPlate({layer});
    EXPECT_EQ(figure<int>(runImprintFilter(input, {}).figures, "projected_curves"), 0);
    // Moved by hand: where it lies now.
    input.curves[0].points[5] += Vec3(0.01, 0.0, 0.0);
    EXPECT_EQ(figure<int>(runImprintFilter(input, {}).figures, "projected_curves"), 1);
    // On a mesh that changed.
    input.surface.mesh.vertices[0].x() -= 0.1;
    input.checksum = checksumOf(input.surface.mesh);
    const std::string refused = refusal([&] { return runImprintFilter(input, {}); });
    expectPart(refused, "layer \"curve\" was drawn on layer \"plate\"");
    expectPart(refused, "whose mesh changed since the curve was drawn");
    ImprintRequest projecting;
    projecting.use.placing.project = true;
    EXPECT_EQ(figure<int>(runImprintFilter(input, projecting).figures, "projected_curves"), 1);
}

TEST(ImprintFilter, RefusesWhatIsNotNearByItsLayerAndDistance) {
    const CurvesOnLayer far = onPlate({square(), polyline("far", {{0, 0, 0}, {1, 1, 1}}, false)});
    const std::string refused = refusal([&] { return runImprintFilter(far, {}); });
    expectPart(refused, "layer \"far\" is not near layer \"plate\": vertex 1");
    expectPart(refused, "is 1 away");
    expectPart(refused, "max_distance");
    CurvesOnLayer optional = far;
    optional.curves[1].isOptional = true;
    const MeshesResult result = runImprintFilter(optional, {});
    EXPECT_EQ(figure<int>(result.figures, "curves"), 1);
    ASSERT_EQ(result.log.warnings.size(), 1U);
    expectPart(result.log.warnings[0], "Layer \"far\" was left out");
    optional.curves.erase(optional.curves.begin());
    expectPart(refusal([&] { return runImprintFilter(optional, {}); }), "layer \"far\" is not");
    expectPart(refusal([&] { return runImprintFilter(onPlate({}), {}); }), "no visible layer");
}

TEST(ImprintFilter, DrapesAlongADirectionAndTellsWhereALineIsBeside) {
    const CurvesOnLayer far = onPlate({polyline("plan", {{0.2, 0.5, 3}, {1.4, 0.5, 7}}, false)});
    ImprintRequest draping;
    draping.use.placing.direction = "0 0 -1";
    const MeshesResult result = runImprintFilter(far, draping);
    EXPECT_EQ(figure<int>(result.figures, "curves"), 1);
    ASSERT_EQ(result.log.warnings.size(), 1U);
    EXPECT_EQ(
        result.log.warnings[0],
        "Layer \"plan\": along the direction it is beside the mesh 1 time (first behind vertex 0), "
        "and parted there."
    );
    draping.use.placing.direction = "1,0,0";
    expectPart(
        refusal([&] { return runImprintFilter(far, draping); }),
        "layer \"plan\" does not meet layer \"plate\" along the direction"
    );
    for (const char* const wrong : {"0 0 0", "1 2", "up"}) {
        draping.use.placing.direction = wrong;
        EXPECT_FALSE(refusal([&] { return runImprintFilter(far, draping); }).empty()) << wrong;
    }
}

TEST(PointsFilter, PlacesPointsAtStepsAtDistancesAndAtThePicks) {
    const CurveResult drawn = draw(plateLayer(), {});
    PolylineLayer layer = polyline("curve", drawn.curve.polyline.points, false);
    layer.places = drawn.curve.polyline.surfacePoints;
    layer.drawnOn = checksumOf(plateLayer().mesh);
    const CurvesOnLayer unknown = onPlate({layer, square()});
    layer.drawn = std::make_shared<const Curve>(drawn.curve);
    const CurvesOnLayer known = onPlate({layer});
    const double length = lengthOf(drawn.curve.polyline);

    PointsRequest request;
    request.count = 5;
    const PointsResult even = runPointsFilter(unknown, request);
    ASSERT_EQ(even.points.size(), 10U);
    EXPECT_EQ(even.curveOf, (std::vector<int>{0, 0, 0, 0, 0, 1, 1, 1, 1, 1}));
    EXPECT_EQ(figure<int>(even.figures, "points"), 10);
    for (int i = 0; i < 5; ++i) {
        EXPECT_NEAR(even.points[i].distance, length * i / 4.0, 1e-12);
        EXPECT_NEAR(even.points[i].normal.z(), 1.0, 1e-12);
    }
    EXPECT_EQ(even.points[0].position, drawn.curve.polyline.points.front());

    // With its spline a curve has the curvature of that.
    const std::vector<CurvePoint> expected =
        CurvePoints(plateLayer().mesh)
            .at(drawn.curve.polyline, &drawn.curve.spline, std::vector{0.4 * length});
    request.distances = "0, " + std::to_string(length * 0.4);
    const PointsResult chosen = runPointsFilter(known, request);
    ASSERT_EQ(chosen.points.size(), 2U);
    EXPECT_NEAR(chosen.points[1].curvature, expected[0].curvature, 1e-4);
    EXPECT_GT(chosen.points[1].curvature, 0.1);

    request.distances.clear();
    request.atPicks = true;
    const PointsResult picked = runPointsFilter(known, request);
    ASSERT_EQ(picked.points.size(), drawn.curve.polyline.picks.size());
    for (std::size_t i = 0; i < picked.points.size(); ++i) {
        const Vec3& pick = drawn.curve.polyline.points[drawn.curve.polyline.picks[i]];
        EXPECT_LT((picked.points[i].position - pick).norm(), 1e-12);
    }
    expectPart(refusal([&] { return runPointsFilter(unknown, request); }), "keeps no picks");
    request = {.count = 1};
    expectPart(refusal([&] { return runPointsFilter(known, request); }), "is an open curve");
    request = {.distances = "0, far"};
    expectPart(refusal([&] { return runPointsFilter(known, request); }), "\"far\"");
    request = {.distances = "1e9"};
    EXPECT_FALSE(refusal([&] { return runPointsFilter(known, request); }).empty());
}

TEST(CutFilter, MakesALayerForAllForEachOrForOnePart) {
    const CurvesOnLayer input = onPlate({square()});
    CutRequest request;
    MeshesResult result = runCutFilter(input, {}, request);
    ASSERT_EQ(result.layers.size(), 1U);
    EXPECT_EQ(result.layers[0].suffix, " cut");
    EXPECT_GT(figure<int>(result.figures, "doubled_vertices"), 4);
    request.words.split = true;
    result = runCutFilter(input, {}, request);
    ASSERT_EQ(result.layers.size(), 2U);
    EXPECT_EQ(result.layers[1].suffix, " part 1");
    const double inside = areaOf(result.layers[1].made.mesh());
    EXPECT_NEAR(areaOf(result.layers[0].made.mesh()) + inside, 1.0, 1e-12);
    request.words = {.keep = KeptParts::Seeds, .seed = "0.5 0.5 0"};
    result = runCutFilter(input, {}, request);
    ASSERT_EQ(result.layers.size(), 1U);
    EXPECT_EQ(result.layers[0].suffix, " part");
    EXPECT_NEAR(areaOf(result.layers[0].made.mesh()), inside, 1e-12);
    request.words.seed.clear();
    result = runCutFilter(input, {Vec3(0.1, 0.1, 0.0)}, request);
    EXPECT_NEAR(areaOf(result.layers[0].made.mesh()), 1.0 - inside, 1e-12);
}

TEST(CutFilter, FillsWhatIsTakenAway) {
    CutRequest request;
    request.words = {.keep = KeptParts::Largest, .seed = "", .fill = FillKind::Smooth};
    const CurvesOnLayer input = onPlate({square()});
    const MeshesResult result = runCutFilter(input, {}, request);
    const MadeMesh& made = result.layers[0].made;
    EXPECT_EQ(figure<int>(result.figures, "filled_holes"), 1);
    EXPECT_NEAR(areaOf(made.mesh()), 1.0, 1e-6);
    EXPECT_EQ(made.faceOf(static_cast<int>(made.mesh().faces.size()) - 1), -1);
    const std::vector<double> carried = made.carried(xOf(input.surface.mesh));
    for (std::size_t i = 0; i < carried.size(); ++i) {
        const bool isNew = made.vertexOf(static_cast<int>(i)) < 0;
        EXPECT_NEAR(carried[i], made.mesh().vertices[i].x(), isNew ? 0.01 : 0.0);
    }
}

TEST(CutFilter, MovesAPartAlongItsNormals) {
    CutRequest request;
    request.words = {.keep = KeptParts::Inside, .seed = "", .relief = 0.125};
    const CurvesOnLayer input = onPlate({square()});
    MeshesResult result = runCutFilter(input, {}, request);
    ASSERT_EQ(result.layers.size(), 1U);
    EXPECT_EQ(result.layers[0].suffix, " relief");
    EXPECT_TRUE(result.log.warnings.empty());
    const MadeMesh& made = result.layers[0].made;
    const auto perimeters = figure<std::vector<double>>(result.figures, "part_perimeters");
    EXPECT_NEAR(areaOf(made.mesh()), 1.0 + 0.125 * perimeters[1], 1e-9);
    // Hosts take the places of vertices that did not move from the layer.
    for (std::size_t i = 0; i < made.mesh().vertices.size(); ++i) {
        const int id = made.vertexOf(static_cast<int>(i));
        if (id >= 0) {
            EXPECT_EQ(made.mesh().vertices[i], input.surface.mesh.vertices[id]);
        }
    }
    const std::vector<double> carried = made.carried(xOf(input.surface.mesh));
    for (std::size_t i = 0; i < carried.size(); ++i) {
        EXPECT_NEAR(carried[i], made.mesh().vertices[i].x(), 1e-12);
    }
}

TEST(CutFilter, MakesSolidsOfParts) {
    const CurvesOnLayer input = onPlate({square()});
    CutRequest request;
    request.words = {.keep = KeptParts::Inside, .seed = "", .thickness = -0.125};
    MeshesResult result = runCutFilter(input, {}, request);
    ASSERT_EQ(result.layers.size(), 1U);
    EXPECT_EQ(result.layers[0].suffix, " part");
    EXPECT_TRUE(result.log.warnings.empty());
    const double area = figure<std::vector<double>>(result.figures, "part_areas")[1];
    const double perimeter = figure<std::vector<double>>(result.figures, "part_perimeters")[1];
    EXPECT_NEAR(areaOf(result.layers[0].made.mesh()), 2.0 * area + 0.125 * perimeter, 1e-9);
    request.words = {.keep = KeptParts::Inside, .seed = "", .base = 0.25};
    result = runCutFilter(input, {}, request);
    EXPECT_TRUE(result.log.warnings.empty());
    EXPECT_NEAR(areaOf(result.layers[0].made.mesh()), 2.0 * area + 0.25 * perimeter, 1e-9);
}

TEST(CutFilter, DrawsStrokesOfAWidth) {
    ParameterValues values(cutFilter());
    values.set("stroke", 0.1);
    values.set("relief", -0.05);
    const CutRequest request = cutRequest(values);
    EXPECT_EQ(request.words.keep, KeptParts::Inside);
    const CurvesOnLayer input = onPlate({polyline("line", {{0.3, 0.5, 0}, {0.7, 0.5, 0}}, false)});
    const MeshesResult result = runCutFilter(input, {}, request);
    const auto perimeters = figure<std::vector<double>>(result.figures, "part_perimeters");
    ASSERT_EQ(perimeters.size(), 2U);
    EXPECT_NEAR(perimeters[1], 0.8 + 0.1 * 3.14159, 1e-3);
    EXPECT_NEAR(areaOf(result.layers[0].made.mesh()), 1.0 + 0.05 * perimeters[1], 1e-9);
}

TEST(CutFilter, RefusesWhatCannotBeByName) {
    CutRequest request;
    const auto refused = [&](const CurvesOnLayer& input) {
        return refusal([&] { return runCutFilter(input, {}, request); });
    };
    const CurvesOnLayer rim = onPlate({polyline("rim", {{0, 0, 0}, {1, 0, 0}}, false)});
    expectPart(refused(rim), "there is nothing to cut");
    request.words = {.keep = KeptParts::Seeds, .seed = "0.3 0.3 0"};
    expectPart(refused(onPlate({square()})), "lies on a curve");
    request.words.seed.clear();
    expectPart(refused(onPlate({square()})), "there is no point");
    ParameterValues values(cutFilter());
    values.set("fill", std::string("flat"));
    expectPart(refusal([&] { return cutRequest(values); }), "fill needs the option keep or split");
    values.set("keep", std::string("inside"));
    values.set("relief", 0.5);
    expectPart(refusal([&] { return cutRequest(values); }), "no hole to fill");
    values.set("keep", std::string("all"));
    values.set("fill", std::string("none"));
    expectPart(refusal([&] { return cutRequest(values); }), "relief needs the option keep");
    values.set("relief", std::numeric_limits<double>::infinity());
    expectPart(refusal([&] { return cutRequest(values); }), "relief must be finite");
    values.set("relief", 0.0);
    values.set("thickness", 1.0);
    expectPart(refusal([&] { return cutRequest(values); }), "need the option keep or split");
    values.set("keep", std::string("inside"));
    values.set("base", 1.0);
    expectPart(refusal([&] { return cutRequest(values); }), "exclude each other");
    values.set("thickness", 0.0);
    values.set("base_direction", std::string("1 0 0; 0 1 0"));
    expectPart(refusal([&] { return cutRequest(values); }), "must be one direction");
    values.set("base", 0.0);
    values.set("base_direction", std::string());
    values.set("profile", std::string("ramp"));
    expectPart(refusal([&] { return cutRequest(values); }), "need the option relief");
}

TEST(CutFilter, ALayerForEachPartIsWhereAllAreKept) {
    const CurvesOnLayer input = onPlate({square()});
    CutRequest request;
    request.words = {.keep = KeptParts::Inside, .seed = "", .split = true};
    const MeshesResult result = runCutFilter(input, {}, request);
    ASSERT_EQ(result.layers.size(), 1U);
    EXPECT_EQ(result.layers[0].suffix, " part");
}

TEST(CutFilter, KeepsTogetherWhatNoCurveParts) {
    CurvesOnLayer input = onPlate({square()});
    const TriangleMesh plate = input.surface.mesh;
    for (const double x : {5.0, 10.0}) {
        const int first = static_cast<int>(input.surface.mesh.vertices.size());
        for (const Vec3& vertex : plate.vertices) {
            input.surface.mesh.vertices.push_back(0.1 * vertex + Vec3(x, 0.0, 0.0));
        }
        for (const Triangle& face : plate.faces) {
            input.surface.mesh.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
        }
    }
    CutRequest request;
    request.words.split = true;
    const MeshesResult result = runCutFilter(input, {}, request);
    ASSERT_EQ(result.layers.size(), 3U);
    EXPECT_EQ(result.layers[1].suffix, " part 1");
    EXPECT_EQ(result.layers[2].suffix, " rest");
    EXPECT_NEAR(areaOf(result.layers[2].made.mesh()), 0.02, 1e-12);
}

TEST(CutFilter, SaysWhichCurvesPartNothing) {
    const PolylineLayer slit = polyline("slit", {{0.1, 0.1, 0}, {0.9, 0.15, 0}}, false);
    const PolylineLayer across = polyline("across", {{0, 0.1, 0}, {1, 0.15, 0}}, false);
    CutRequest request;
    request.words.split = true;
    MeshesResult result = runCutFilter(onPlate({slit}), {}, request);
    ASSERT_EQ(result.layers.size(), 1U);
    EXPECT_EQ(result.layers[0].suffix, " cut");
    ASSERT_EQ(result.log.warnings.size(), 1U);
    expectPart(result.log.warnings[0], "The curve parts nothing: the mesh is cut open along it (");
    expectPart(result.log.warnings[0], "from boundary to boundary, to part the mesh.");
    result = runCutFilter(onPlate({across, square()}), {}, request);
    EXPECT_EQ(result.layers.size(), 3U);
    EXPECT_TRUE(result.log.warnings.empty());
    request.words.keep = KeptParts::Inside;
    result = runCutFilter(onPlate({slit, square()}), {}, request);
    ASSERT_EQ(result.log.warnings.size(), 1U);
    expectPart(result.log.warnings[0], "1 of 2 curves parts nothing; draw a closed curve");
    result = runSegmentFilter(onPlate({slit, square()}), {});
    ASSERT_EQ(result.log.warnings.size(), 1U);
    expectPart(result.log.warnings[0], "1 of 2 curves parts nothing; draw a closed curve");
}

TEST(CurveNotes, NameTheFirstLayers) {
    EXPECT_EQ(describeLayers({"a", "b"}), R"(The mesh is parted into 2 layers: "a" and "b".)");
    EXPECT_EQ(
        describeLayers({"a", "b", "c"}), R"(The mesh is parted into 3 layers: "a", "b" and "c".)"
    );
    EXPECT_EQ(
        describeLayers({"a", "b", "c", "d", "e", "f", "g"}),
        R"(The mesh is parted into 7 layers: "a", "b", "c", "d", "e" and 2 more.)"
    );
}

TEST(SegmentFilter, LabelsAndMeasuresParts) {
    const CurvesOnLayer input = onPlate({square()});
    SegmentRequest request;
    MeshesResult result = runSegmentFilter(input, request);
    ASSERT_EQ(result.layers.size(), 1U);
    EXPECT_TRUE(result.layers[0].showsParts);
    const auto areas = figure<std::vector<double>>(result.figures, "part_areas");
    ASSERT_EQ(areas.size(), 2U);
    EXPECT_NEAR(areas[0] + areas[1], 1.0, 1e-12);
    EXPECT_EQ(figure<std::vector<double>>(result.figures, "part_centroids").size(), 6U);
    EXPECT_EQ(
        figure<std::vector<double>>(result.figures, "part_eulers"), (std::vector<double>{0, 1})
    );
    ASSERT_EQ(result.log.table.size(), 2U);
    expectPart(result.log.table[1], "part=1 faces=");
    request.split = true;
    result = runSegmentFilter(input, request);
    ASSERT_EQ(result.layers.size(), 2U);
    EXPECT_NEAR(areaOf(result.layers[1].made.mesh()), areas[1], 1e-12);
    const CurvesOnLayer slit = onPlate({polyline("slit", {{0.2, 0.2, 0}, {0.8, 0.7, 0}}, false)});
    expectPart(refusal([&] { return runSegmentFilter(slit, {}); }), "the curves part nothing");
}

TEST(OffsetFilter, DrawsLinesAndTheBandBetween) {
    const CurvesOnLayer input = onPlate({polyline("line", {{0.3, 0.5, 0}, {0.7, 0.5, 0}}, false)});
    OffsetRequest request;
    request.offset.distance = 0.1;
    request.selectBand = true;
    OffsetResult result = runOffsetFilter(input, request);
    ASSERT_EQ(result.pieces.size(), 1U);
    EXPECT_EQ(result.pieces[0].curve, "line");
    EXPECT_TRUE(result.pieces[0].line.closed);
    EXPECT_NEAR(figure<double>(result.figures, "length"), 0.8 + 0.2 * 3.14159, 0.01);
    EXPECT_EQ(result.band.size(), input.surface.mesh.faces.size());
    request.offset.sides = OffsetSides::Left;
    result = runOffsetFilter(input, request);
    EXPECT_FALSE(result.pieces[0].line.closed);
    EXPECT_NEAR(result.pieces[0].line.points[2].y(), 0.6, 1e-6);
    request.offset.distance = 5.0;
    expectPart(
        refusal([&] { return runOffsetFilter(input, request); }), "layer \"line\": no point"
    );
    request.offset.distance = 0.0;
    request.selectBand = false;
    result = runOffsetFilter(input, request);
    EXPECT_NEAR(figure<double>(result.figures, "offset"), 0.02 * std::sqrt(2.0), 1e-12);
    EXPECT_TRUE(result.band.empty());
}

}  // namespace
}  // namespace bspline_curve
