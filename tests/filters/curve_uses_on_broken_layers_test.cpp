// SPDX-License-Identifier: GPL-3.0-or-later
// The filters that use curves, on layers whose meshes are mended in memory.
#include "filters/broken_plates.h"
#include "filters/run_curve_uses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

// A round curve through them leaves the boundary alone.
const std::vector<Vec3> kInnerPicks = {{0.3, 0.3, 0.0}, {0.5, 0.7, 0.0}, {0.7, 0.35, 0.0}};

/// The layer, and a closed curve that was drawn on it.
CurvesOnLayer withCurve(const LayerInput& layer) {
    CurveRequest request;
    request.solver.closed = true;
    WorkpieceCache cache;
    const CurveResult drawn =
        runCurveFilter(layer, {.tool = kInnerPicks, .layer = {}}, request, cache);
    CurvesOnLayer input{.surface = layer, .checksum = checksumOf(layer.mesh), .curves = {}};
    PolylineLayer curve;
    curve.label = "curve";
    curve.points = drawn.curve.polyline.points;
    curve.places = drawn.curve.polyline.surfacePoints;
    curve.drawnOn = input.checksum;
    const auto count = static_cast<int>(curve.points.size());
    for (int i = 0; i < count; ++i) {
        curve.edges.push_back({i, (i + 1) % count});
    }
    input.curves.push_back(std::move(curve));
    return input;
}

Vec3 placeIn(const TriangleMesh& mesh, int face, const Vec3& weights) {
    Vec3 position = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        position += weights[k] * mesh.vertices[mesh.faces[face][k]];
    }
    return position;
}

/// Vertices and faces come from those of the layer.
void expectMadeFrom(const LayerInput& layer, const MadeMesh& made) {
    const TriangleMesh& mesh = made.mesh();
    const std::vector<double> quality = made.carried(layer.quality);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const Vec3& position = mesh.vertices[v];
        EXPECT_NEAR(quality[v], 2.0 * position.x() + position.y(), 1e-12);
        const int id = made.vertexOf(static_cast<int>(v));
        EXPECT_TRUE(id < 0 || layer.mesh.vertices[id] == position);
    }
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const int parent = made.faceOf(static_cast<int>(f));
        for (int k = 0; parent >= 0 && k < 3; ++k) {
            const Vec3 weights = made.placeOf(static_cast<int>(f), k);
            EXPECT_GE(weights.minCoeff(), -1e-14);
            const Vec3 place = placeIn(layer.mesh, parent, weights);
            EXPECT_LT((place - mesh.vertices[mesh.faces[f][k]]).norm(), 1e-14);
        }
    }
}

TEST(CurveUsesOnBrokenLayers, MakeMeshesOfWhatIsTheLayers) {
    for (const BrokenPlate& broken : brokenPlates()) {
        SCOPED_TRACE(broken.name);
        const CurvesOnLayer input = withCurve(broken.layer);
        const MeshesResult imprinted = runImprintFilter(input, {});
        EXPECT_EQ(figure<int>(imprinted.figures, "projected_curves"), 0);
        EXPECT_GE(figure<int>(imprinted.figures, "parts"), 2);
        ASSERT_EQ(imprinted.log.warnings.size(), 1U);
        expectPart(imprinted.log.warnings[0], broken.said);
        expectMadeFrom(input.surface, imprinted.layers.at(0).made);
        CutRequest request;
        request.words.keep = KeptParts::Outside;
        request.words.fill = FillKind::Flat;
        const MeshesResult cut = runCutFilter(input, {}, request);
        expectMadeFrom(input.surface, cut.layers.at(0).made);
        SegmentRequest split;
        split.split = true;
        for (const MeshLayer& part : runSegmentFilter(input, split).layers) {
            expectMadeFrom(input.surface, part.made);
        }
    }
}

TEST(CurveUsesOnBrokenLayers, DrawOffsetsOnFacesOfTheLayer) {
    for (const BrokenPlate& broken : brokenPlates()) {
        SCOPED_TRACE(broken.name);
        const CurvesOnLayer input = withCurve(broken.layer);
        const TriangleMesh& mesh = input.surface.mesh;
        OffsetRequest request;
        request.offset.distance = 0.05;
        request.selectBand = true;
        const OffsetResult result = runOffsetFilter(input, request);
        ASSERT_FALSE(result.pieces.empty());
        for (const OffsetResult::Piece& piece : result.pieces) {
            for (std::size_t i = 0; i < piece.line.points.size(); ++i) {
                const auto& [face, weights] = piece.line.surfacePoints[i];
                EXPECT_LT((placeIn(mesh, face, weights) - piece.line.points[i]).norm(), 1e-12);
            }
        }
        ASSERT_EQ(result.band.size(), mesh.faces.size());
        for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
            const Vec3 middle = placeIn(mesh, static_cast<int>(f), Vec3::Constant(1.0 / 3.0));
            double nearest = 1.0;
            for (const Vec3& point : input.curves[0].points) {
                nearest = std::min(nearest, (point - middle).norm());
            }
            EXPECT_TRUE(result.band[f] == 0 || nearest < 0.06) << f;
        }
        EXPECT_GT(std::ranges::count(result.band, char{1}), 10);
    }
}

TEST(CurveUsesOnBrokenLayers, AreRefusedWhereTheyAreStrict) {
    for (const BrokenPlate& broken : brokenPlates()) {
        SCOPED_TRACE(broken.name);
        const CurvesOnLayer input = withCurve(broken.layer);
        ImprintRequest request;
        request.use.mending.strict = true;
        expectPart(refusal([&] { return runImprintFilter(input, request); }), broken.refused);
    }
}

// On a plate with a second one that stands on its middle, from the first to the second.
TEST(CurveUsesOnBrokenLayers, ImprintACurveFromSheetToSheet) {
    LayerInput layer = plateLayer();
    const TriangleMesh flat = layer.mesh;
    std::vector<int> ids(flat.vertices.size());
    for (std::size_t v = 0; v < ids.size(); ++v) {
        const Vec3& p = flat.vertices[v];
        ids[v] = static_cast<int>(v);
        if (p.x() > 0.5) {
            ids[v] = static_cast<int>(layer.mesh.vertices.size());
            layer.mesh.vertices.emplace_back(0.5, p.y(), p.x() - 0.5);
        }
    }
    for (const Triangle& face : flat.faces) {
        const auto isRight = [&](int v) { return flat.vertices[v].x() >= 0.5; };
        if (std::ranges::all_of(face, isRight)) {
            layer.mesh.faces.push_back({ids[face[0]], ids[face[1]], ids[face[2]]});
        }
    }
    for (const Vec3& vertex : layer.mesh.vertices) {
        layer.quality.push_back(2.0 * vertex.x() + vertex.y());
    }
    WorkpieceCache designers;
    const std::vector<Vec3> picks = {{0.2, 0.5, 0.0}, {0.5, 0.4, 0.3}};
    const CurveResult drawn = runCurveFilter(layer, {.tool = picks, .layer = {}}, {}, designers);
    PolylineLayer curve;
    curve.label = "curve";
    curve.points = drawn.curve.polyline.points;
    curve.places = drawn.curve.polyline.surfacePoints;
    curve.drawnOn = checksumOf(layer.mesh);
    for (int i = 0; i + 1 < static_cast<int>(curve.points.size()); ++i) {
        curve.edges.push_back({i, i + 1});
    }
    const CurvesOnLayer input{
        .surface = layer, .checksum = checksumOf(layer.mesh), .curves = {curve}
    };
    const MeshesResult imprinted = runImprintFilter(input, {});
    EXPECT_EQ(figure<int>(imprinted.figures, "projected_curves"), 0);
    const MadeMesh& made = imprinted.layers.at(0).made;
    expectMadeFrom(layer, made);
    const std::vector<double> flags = made.curveFlags();
    const auto isMarked = [&](const Vec3& place) {
        for (std::size_t v = 0; v < flags.size(); ++v) {
            if (flags[v] == 1.0 && (made.mesh().vertices[v] - place).norm() < 1e-12) {
                return true;
            }
        }
        return false;
    };
    EXPECT_TRUE(std::ranges::all_of(curve.points, isMarked));
    OffsetRequest offset;
    offset.offset.distance = 0.05;
    expectPart(refusal([&] { return runOffsetFilter(input, offset); }), "from sheet to sheet");
}

}  // namespace
}  // namespace bspline_curve
