// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/drawn_curve_file.h"

#include "bspline_curve/designer.h"
#include "bspline_curve/error.h"
#include "io/curve_reader.h"
#include "io/curve_writer.h"
#include "io/temporary_files.h"
#include "support/meshes.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace bspline_curve::io_tests {

namespace {

SketchPick pickAt(const TriangleMesh& mesh, int face, const Vec3& barycentric) {
    SketchPick pick{.point = {face, barycentric}};
    for (int k = 0; k < 3; ++k) {
        pick.position += barycentric[k] * mesh.vertices[mesh.faces[face][k]];
    }
    return pick;
}

TriangleMesh hilly() {
    TriangleMesh mesh = test_support::plate(8, 8);
    for (Vec3& vertex : mesh.vertices) {
        vertex.z() = 0.1 * std::sin(3.0 * vertex.x()) * vertex.y();
    }
    return mesh;
}

/// Curves on a hilly plate, with numbers that need all their digits.
class DrawnCurveFile : public FileTest {
protected:
    DrawnCurveFile()
        : designer_(hilly()),
          surface_{.mesh = designer_.mesh(), .checksum = checksumOf(designer_.mesh())} {
        add({3, 70, 120}, {.degree = 4, .tension = 0.1, .field = "ridge", .fieldWeight = 1.0 / 3});
        curves_.back().drawn.name = "Größe \"1\"  — rim";
        curves_.back().drawn.colour = {255, 0, 7, 128};
        add({20, 50, 100, 90}, {.closed = true, .avoid = "over-threshold", .avoidThreshold = 0.1});
    }

    void add(const std::vector<int>& faces, const DrawnOptions& options) {
        CurveToSave curve;
        std::vector<Vec3> positions;
        for (const int face : faces) {
            const Vec3 barycentric(0.1, 1.0 / 3, 1.0 - 0.1 - 1.0 / 3);
            curve.drawn.picks.push_back(pickAt(designer_.mesh(), face, barycentric));
            positions.push_back(curve.drawn.picks.back().position);
        }
        curve.drawn.options = options;
        curve.curve = std::make_shared<const Curve>(
            designer_.design(positions, {.degree = options.degree, .closed = options.closed})
        );
        curves_.push_back(std::move(curve));
    }

    void expectSame(const std::vector<DrawnCurve>& opened) const {
        ASSERT_EQ(opened.size(), curves_.size());
        for (std::size_t c = 0; c < opened.size(); ++c) {
            const DrawnCurve& drawn = curves_[c].drawn;
            EXPECT_EQ(opened[c].name, drawn.name);
            EXPECT_EQ(opened[c].colour, drawn.colour);
            EXPECT_EQ(opened[c].options, drawn.options);
            ASSERT_EQ(opened[c].picks.size(), drawn.picks.size());
            for (std::size_t i = 0; i < drawn.picks.size(); ++i) {
                EXPECT_EQ(opened[c].picks[i].point.face, drawn.picks[i].point.face);
                EXPECT_EQ(opened[c].picks[i].point.barycentric, drawn.picks[i].point.barycentric);
                EXPECT_EQ(opened[c].picks[i].position, drawn.picks[i].position);
            }
        }
    }

    CurveDesigner designer_;
    CurveFileSurface surface_;
    std::vector<CurveToSave> curves_;
};

}  // namespace

TEST_F(DrawnCurveFile, KeepsPicksOptionsNameAndColourToTheBit) {
    for (const char* const name : {"a.json"}) {
        saveDrawnCurves(path(name), curves_, surface_);
        const OpenedCurves opened = openDrawnCurves(path(name), surface_);
        SCOPED_TRACE(name);
        expectSame(opened.curves);
        EXPECT_TRUE(opened.notes.empty());
    }
    EXPECT_EQ(fileCount(), 1U);
}

TEST_F(DrawnCurveFile, OfOneCurveIsReadAsACurveFileToo) {
    const Surface surface(designer_.mesh());
    saveDrawnCurves(path("two.json"), curves_, surface_);
    curves_.resize(1);
    saveDrawnCurves(path("one.json"), curves_, surface_);
    const SurfacePolyline& line = curves_[0].curve->polyline;
    for (const char* const name : {"one.json", "two.json"}) {
        const SurfacePolyline read = readCurves(path(name), surface, surface_.checksum).front();
        EXPECT_EQ(read.points, line.points);
        EXPECT_EQ(read.picks, line.picks);
        EXPECT_EQ(read.parameters, line.parameters);
    }
    expectSame(openDrawnCurves(path("one.json"), surface_).curves);
}

TEST_F(DrawnCurveFile, KeepsPolylineAndSplineToTheBit) {
    CurveRecords records{.mesh = surface_.checksum, .curves = {}};
    for (const CurveToSave& each : curves_) {
        records.curves.push_back(recordOf(each.drawn, each.curve));
    }
    const CurveRecords read = recordsOf("a.json", recordsText(records));
    EXPECT_EQ(read.mesh, surface_.checksum);
    EXPECT_EQ(recordsText(read), recordsText(records));
    EXPECT_EQ(read.curves[1].curve->spline.controlPoints, curves_[1].curve->spline.controlPoints);
    EXPECT_EQ(read.curves[1].curve->spline.knots, curves_[1].curve->spline.knots);
    EXPECT_EQ(
        shortRecordsText(records).find_first_of(" \n\"\\u"), shortRecordsText(records).find('"')
    );
}

TEST_F(DrawnCurveFile, OfTheProgramGivesPicksOfThePolylineAndOptionsOfTheSpline) {
    writeCurve(path("a.json"), *curves_[0].curve, {}, surface_.checksum);
    const std::vector<DrawnCurve> opened = openDrawnCurves(path("a.json"), surface_).curves;
    ASSERT_EQ(opened.size(), 1U);
    EXPECT_EQ(opened[0].options, (DrawnOptions{.degree = 4}));
    const SurfacePolyline& line = curves_[0].curve->polyline;
    ASSERT_EQ(opened[0].picks.size(), 3U);
    EXPECT_EQ(opened[0].picks[1].position, line.points[line.picks[1]]);
}

TEST_F(DrawnCurveFile, KeepsACurveThatHasNotBeenFound) {
    curves_[0].curve = nullptr;
    saveDrawnCurves(path("a.json"), curves_, surface_);
    expectSame(openDrawnCurves(path("a.json"), surface_).curves);
}

TEST_F(DrawnCurveFile, ProjectsPicksToAMeshThatChanged) {
    saveDrawnCurves(path("a.json"), curves_, surface_);
    TriangleMesh turned = designer_.mesh();
    std::ranges::reverse(turned.faces);
    for (Vec3& vertex : turned.vertices) {
        vertex.z() += 1e-3;
    }
    const OpenedCurves opened =
        openDrawnCurves(path("a.json"), {.mesh = turned, .checksum = checksumOf(turned)});
    ASSERT_EQ(opened.curves.size(), 2U);
    ASSERT_EQ(opened.notes.size(), 2U);
    expectContains(opened.notes[0], "3 of 3 picks were projected to the surface");
    expectContains(opened.notes[0], "since the mesh changed: coordinates, faces or their order");
    const SketchPick& pick = opened.curves[0].picks[0];
    EXPECT_LT((pick.position - curves_[0].drawn.picks[0].position).norm(), 2e-3);
    EXPECT_EQ(pick.position, pickAt(turned, pick.point.face, pick.point.barycentric).position);
    EXPECT_EQ(opened.curves[0].options, curves_[0].drawn.options);
    for (Vec3& vertex : turned.vertices) {
        vertex.z() += 1.0;
    }
    expectContains(
        refusal(
            [&] {
                return openDrawnCurves(
                    path("a.json"), {.mesh = turned, .checksum = checksumOf(turned)}
                );
            },
            InputErrorCode::PickTooFar
        ),
        "a.json: no curve is near the surface"
    );
}

}  // namespace bspline_curve::io_tests
