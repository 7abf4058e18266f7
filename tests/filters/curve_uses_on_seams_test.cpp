// SPDX-License-Identifier: GPL-3.0-or-later
// The filters that use curves, on a layer of two halves with vertices of their own where they meet.
#include "filters/run_curve_uses.h"
#include "filters/runs_on_plates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

/// The quality is that of a texture: it jumps from one half to the other.
LayerInput halvedLayer() {
    LayerInput layer = plateLayer();
    std::vector<int> isRight;
    for (const Triangle& face : layer.mesh.faces) {
        isRight.push_back(std::ranges::any_of(face, [&](int v) {
            return layer.mesh.vertices[v].x() > 0.5;
        }));
    }
    layer.mesh = partedByLabels(layer.mesh, isRight);
    std::vector<char> isOfRight(layer.mesh.vertices.size(), 0);
    for (std::size_t f = 0; f < isRight.size(); ++f) {
        for (const int v : layer.mesh.faces[f]) {
            isOfRight[v] = static_cast<char>(isRight[f]);
        }
    }
    for (std::size_t v = 0; v < layer.mesh.vertices.size(); ++v) {
        layer.quality.push_back(layer.mesh.vertices[v].y() + (isOfRight[v] != 0 ? 10.0 : 0.0));
    }
    return layer;
}

CurvesOnLayer onHalves(const std::vector<Vec3>& points, bool closed) {
    CurvesOnLayer input{.surface = halvedLayer(), .checksum = {}, .curves = {}};
    input.checksum = checksumOf(input.surface.mesh);
    PolylineLayer curve;
    curve.label = "curve";
    curve.points = points;
    const auto count = static_cast<int>(points.size());
    for (int i = 0; i + (closed ? 0 : 1) < count; ++i) {
        curve.edges.push_back({i, (i + 1) % count});
    }
    input.curves.push_back(std::move(curve));
    return input;
}

/// The half that a vertex of a face is of, by its quality.
bool isRightHalf(const std::vector<double>& quality, int vertex) {
    return quality[vertex] > 5.0;
}

void expectHalves(const CurvesOnLayer& input, const MadeMesh& made) {
    const TriangleMesh& mesh = made.mesh();
    const TriangleMesh& given = input.surface.mesh;
    const std::vector<double> quality = made.carried(input.surface.quality);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const int parent = made.faceOf(static_cast<int>(f));
        if (parent < 0) {
            continue;
        }
        const bool isRight = isRightHalf(input.surface.quality, given.faces[parent][0]);
        for (int k = 0; k < 3; ++k) {
            const int vertex = mesh.faces[f][k];
            EXPECT_EQ(isRightHalf(quality, vertex), isRight);
            EXPECT_NEAR(quality[vertex], mesh.vertices[vertex].y() + (isRight ? 10.0 : 0.0), 1e-12);
            const Vec3 place = made.placeOf(static_cast<int>(f), k);
            Vec3 position = Vec3::Zero();
            for (int j = 0; j < 3; ++j) {
                position += place[j] * given.vertices[given.faces[parent][j]];
            }
            EXPECT_NEAR(position.x(), mesh.vertices[vertex].x(), 1e-14);
            EXPECT_NEAR(position.y(), mesh.vertices[vertex].y(), 1e-14);
        }
    }
}

const std::vector<Vec3> kAcross = {{0.3, 0.3, 0}, {0.7, 0.31, 0}, {0.69, 0.72, 0}, {0.33, 0.68, 0}};

TEST(CurveUsesOnSeams, KeepVerticesAndValuesOfEachSide) {
    const CurvesOnLayer input = onHalves(kAcross, true);
    const TriangleMesh& given = input.surface.mesh;
    const MeshesResult result = runImprintFilter(input, {});
    EXPECT_EQ(figure<int>(result.figures, "parts"), 2);
    const MadeMesh& made = result.layers.at(0).made;
    const TriangleMesh& mesh = made.mesh();
    EXPECT_EQ(figure<int>(result.figures, "vertices"), static_cast<int>(mesh.vertices.size()));
    expectHalves(input, made);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const int id = made.vertexOf(static_cast<int>(v));
        EXPECT_EQ(id, v < given.vertices.size() ? static_cast<int>(v) : -1);
    }
    // The curve crosses the seam in two points, whose vertices are there once on each side.
    const std::vector<double> flags = made.curveFlags();
    std::set<double> heights;
    int onSeam = 0;
    for (std::size_t v = given.vertices.size(); v < mesh.vertices.size(); ++v) {
        EXPECT_EQ(flags[v], 1.0);
        if (mesh.vertices[v].x() == 0.5) {
            heights.insert(mesh.vertices[v].y());
            ++onSeam;
        }
    }
    EXPECT_EQ(onSeam, 4);
    EXPECT_EQ(heights.size(), 2U);
}

TEST(CurveUsesOnSeams, MarkBothSidesOfACurveAlongASeam) {
    const CurvesOnLayer input = onHalves({{0.5, 0.0, 0}, {0.5, 0.55, 0}}, false);
    const MeshesResult result = runImprintFilter(input, {});
    const MadeMesh& made = result.layers.at(0).made;
    const std::vector<double> flags = made.curveFlags();
    std::set<double> heights;
    for (std::size_t v = 0; v < flags.size(); ++v) {
        const Vec3& at = made.mesh().vertices[v];
        const bool isOnCurve = at.x() == 0.5 && at.y() <= 0.55;
        EXPECT_EQ(flags[v] == 1.0, isOnCurve);
        if (isOnCurve) {
            heights.insert(at.y());
        }
    }
    EXPECT_GT(heights.size(), 5U);
    EXPECT_EQ(std::ranges::count(flags, 1.0), 2 * std::ssize(heights));
    // Five of them, and their copies, are of the layer.
    const std::size_t given = input.surface.mesh.vertices.size();
    EXPECT_EQ(made.mesh().vertices.size(), given + 2 * (heights.size() - 5));
}

TEST(CurveUsesOnSeams, CutAcrossThem) {
    const CurvesOnLayer input = onHalves(kAcross, true);
    CutRequest request;
    request.words.split = true;
    MeshesResult result = runCutFilter(input, {}, request);
    ASSERT_EQ(result.layers.size(), 2U);
    for (const MeshLayer& layer : result.layers) {
        expectHalves(input, layer.made);
    }
    // The rim of the inner part, with both of its vertices at the two ends of the seam.
    const MadeMesh& inner = result.layers[1].made;
    const std::vector<double> flags = inner.curveFlags();
    EXPECT_EQ(std::ranges::count(flags, 1.0), 2 + figure<int>(result.figures, "doubled_vertices"));
    request.words.split = false;
    result = runCutFilter(input, {}, request);
    ASSERT_EQ(result.layers.size(), 1U);
    expectHalves(input, result.layers[0].made);
    for (std::size_t v = 0; v < input.surface.mesh.vertices.size(); ++v) {
        EXPECT_EQ(result.layers[0].made.vertexOf(static_cast<int>(v)), static_cast<int>(v));
    }
    request.words.keep = KeptParts::Largest;
    for (const FillKind fill : {FillKind::Flat, FillKind::Smooth}) {
        request.words.fill = fill;
        expectHalves(input, runCutFilter(input, {}, request).layers.at(0).made);
    }
    request.words.fill = FillKind::None;
    request.words.relief = 0.1;
    result = runCutFilter(input, {}, request);
    expectHalves(input, result.layers.at(0).made);
}

TEST(CurveUsesOnSeams, AreSegmentedAcrossThem) {
    const CurvesOnLayer input = onHalves(kAcross, true);
    SegmentRequest request;
    for (const bool split : {false, true}) {
        request.split = split;
        const MeshesResult result = runSegmentFilter(input, request);
        ASSERT_EQ(result.layers.size(), split ? 2U : 1U);
        for (const MeshLayer& layer : result.layers) {
            expectHalves(input, layer.made);
        }
    }
}

}  // namespace
}  // namespace bspline_curve
