// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/drawn_curve_file.h"

#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "bspline_curve/spline.h"
#include "bspline_curve/workpiece.h"
#include "design/curve_designer.h"
#include "filters/fitting_picks.h"
#include "io/curve_reader.h"
#include "io/damage.h"
#include "io/temporary_files.h"
#include "support/meshes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <span>
#include <sstream>
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

double distanceTo(const SpacePolyline& line, const Vec3& point) {
    double nearest = std::numeric_limits<double>::infinity();
    const std::size_t count = line.points.size();
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < count; ++i) {
        const Vec3& from = line.points[i];
        const Vec3 along = line.points[(i + 1) % count] - from;
        const double t = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (point - from - t * along).norm());
    }
    return nearest;
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
        curves_.back().drawn.picks[1].isCorner = true;
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
                EXPECT_EQ(opened[c].picks[i].isCorner, drawn.picks[i].isCorner);
            }
        }
    }

    CurveDesigner designer_;
    CurveFileSurface surface_;
    std::vector<CurveToSave> curves_;
};

}  // namespace

TEST_F(DrawnCurveFile, KeepsPicksOptionsNameAndColourToTheBit) {
    for (const char* const name : {"a.json", "a.obj", "a.DXF"}) {
        saveDrawnCurves(path(name), curves_, surface_);
        const OpenedCurves opened = openDrawnCurves(path(name), surface_);
        SCOPED_TRACE(name);
        expectSame(opened.curves);
        EXPECT_TRUE(opened.notes.empty());
    }
    EXPECT_EQ(fileCount(), 3U);
}

TEST_F(DrawnCurveFile, OfACurveWithoutItsPicksHasTheCornersOfTheSpline) {
    std::vector<Vec3> picks;
    for (const SketchPick& pick : curves_[1].drawn.picks) {
        picks.push_back(pick.position);
    }
    const std::vector<int> corners = {0, 2};
    const Curve curve = designer_.design(picks, {.closed = true}, {}, {.corners = corners});
    writeCurve(path("a.json"), curve);
    const OpenedCurves opened = openDrawnCurves(path("a.json"), surface_);
    ASSERT_EQ(opened.curves.size(), 1U);
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(opened.curves[0].picks[i].isCorner, i % 2 == 0) << i;
    }
}

TEST_F(DrawnCurveFile, KeepsDirectionsOfPicks) {
    const auto along = PickTangent::along({0.25, -1.0, 3.0});
    const PickTangent free{Vec3(0.1, 0.2, 0.3), Vec3(0.25, 1.0, 3.0)};
    const PickTangent oneSided{Vec3::Zero(), Vec3(0.5, 1.0, 0.0)};
    std::vector<SketchPick>& picks = curves_[0].drawn.picks;
    picks[0].tangent = along;
    picks[1] = {picks[1].point, picks[1].position, true, free};
    picks[2] = {picks[2].point, picks[2].position, true, oneSided};
    for (const char* const name : {"a.json", "a.obj", "a.dxf"}) {
        saveDrawnCurves(path(name), curves_, surface_);
        const OpenedCurves opened = openDrawnCurves(path(name), surface_);
        const std::vector<SketchPick>& read = opened.curves.at(0).picks;
        EXPECT_EQ(read.at(0).tangent, along) << name;
        EXPECT_EQ(read.at(1).tangent, free) << name;
        EXPECT_EQ(read.at(2).tangent, oneSided) << name;
        EXPECT_TRUE(read.at(1).isCorner && read.at(2).isCorner) << name;
        EXPECT_TRUE(opened.curves.at(1).picks.at(0).tangent.isAny()) << name;
    }
}

TEST_F(DrawnCurveFile, OfACurveWithoutItsPicksHasTheDirectionsOfTheSpline) {
    std::vector<Vec3> picks;
    for (const SketchPick& pick : curves_[1].drawn.picks) {
        picks.push_back(pick.position);
    }
    std::vector<PickTangent> tangents(picks.size());
    tangents[1] = PickTangent::along(picks[2] - picks[0]);
    const Curve curve = designer_.design(picks, {.closed = true}, {}, {.tangents = tangents});
    writeCurve(path("a.json"), curve);
    const std::vector<SketchPick> opened =
        openDrawnCurves(path("a.json"), surface_).curves.at(0).picks;
    const Vec3 along = derivativeOf(curve.spline, curve.spline.pickParameters[1]).normalized();
    EXPECT_LE((opened.at(1).tangent.after - along).norm(), 1e-12);
    EXPECT_TRUE(opened.at(1).tangent.isOne());
    EXPECT_TRUE(opened.at(0).tangent.isAny());
}

TEST_F(DrawnCurveFile, KeepsCornersOfPicksThatAreProjected) {
    saveDrawnCurves(path("a.json"), curves_, surface_);
    TriangleMesh other = designer_.mesh();
    for (Vec3& vertex : other.vertices) {
        vertex.z() += 1e-4;
    }
    const OpenedCurves opened =
        openDrawnCurves(path("a.json"), {.mesh = other, .checksum = checksumOf(other)});
    EXPECT_TRUE(opened.curves.at(0).picks.at(1).isCorner);
    EXPECT_FALSE(opened.curves.at(0).picks.at(0).isCorner);
}

TEST_F(DrawnCurveFile, OfPolylinesIsReadByProgramsThatKnowNothingOfPicks) {
    for (const char* const name : {"a.obj", "a.dxf"}) {
        saveDrawnCurves(path(name), curves_, surface_);
        const std::vector<SpacePolyline> lines = readPolylines(path(name)).lines;
        ASSERT_EQ(lines.size(), 2U) << name;
        for (std::size_t c = 0; c < lines.size(); ++c) {
            std::vector<Vec3> points = curves_[c].curve->polyline.points;
            const auto first = std::ranges::find(points, lines[c].points.front());
            std::ranges::rotate(points, first);  // a closed one begins anywhere
            EXPECT_EQ(lines[c].points, points);
            EXPECT_EQ(lines[c].closed, curves_[c].drawn.options.closed);
        }
        std::istringstream text(read(path(name)));
        for (std::string line; std::getline(text, line);) {
            EXPECT_LT(line.size(), 256U);
            EXPECT_TRUE(std::ranges::all_of(line, [](char c) { return c >= ' ' && c <= '~'; }));
        }
    }
    expectContains(read(path("a.obj")), "# bspline_curve {\"curves\":[{\"name\":\"Gr\\u00f6");
    EXPECT_TRUE(read(path("a.dxf")).starts_with("999\nbspline_curve {"));
}

TEST_F(DrawnCurveFile, OfOtherProgramsGivesPicksAlongItsPolylines) {
    for (const char* const name : {"a.obj", "a.dxf", "a.ply"}) {
        const std::vector<const Curve*> curves{curves_[0].curve.get(), curves_[1].curve.get()};
        write(name, curvesBytes(name, curves));
        const OpenedCurves opened = openDrawnCurves(path(name), surface_);
        ASSERT_EQ(opened.curves.size(), 2U) << name;
        ASSERT_EQ(opened.notes.size(), 1U) << name;
        expectContains(opened.notes[0], "keeps no picks: they were chosen along its polylines");
        for (std::size_t c = 0; c < 2; ++c) {
            const DrawnCurve& drawn = opened.curves[c];
            EXPECT_EQ(drawn.options, (DrawnOptions{.closed = c == 1}));
            EXPECT_GE(drawn.picks.size(), 3U);
            EXPECT_LT(drawn.picks.size(), 40U);
            std::vector<Vec3> positions;
            for (const SketchPick& pick : drawn.picks) {
                positions.push_back(pick.position);
            }
            const Curve again = designer_.design(positions, {.closed = drawn.options.closed});
            const SpacePolyline line{again.polyline.points, again.polyline.closed};
            for (const Vec3& point : curves_[c].curve->polyline.points) {
                EXPECT_LT(distanceTo(line, point), 0.005);
            }
        }
    }
}

TEST_F(DrawnCurveFile, RefusesWhatCannotBeSavedOrOpened) {
    const auto saved = [&](const char* name, std::span<const CurveToSave> curves) {
        return refusal(
            [&] {
                saveDrawnCurves(path(name), curves, surface_);
                return 0;
            },
            InputErrorCode::UnwritableFile
        );
    };
    expectContains(saved("a.ply", curves_), "a.ply: curves are saved as .json, .obj or .dxf");
    expectContains(saved("a.json", {}), "a.json: there is no curve to be saved");
    expectContains(saved("none/a.obj", curves_), "does not exist");
    EXPECT_EQ(fileCount(), 0U);
    const auto opened = [&](const char* name, const std::string& bytes) {
        write(name, bytes);
        return refusal([&] { return openDrawnCurves(path(name), surface_); });
    };
    expectContains(opened("a.json", "{}"), "a.json: has no \"closed\"");
    expectContains(opened("a.json", R"({"closed": true})"), "neither \"picks\" nor a \"polyline\"");
    expectContains(opened("a.json", R"({"curves": []})"), "\"curves\" is no list of curves");
    expectContains(opened("a.obj", "# bspline_curve {\nv 0 0 0\n"), "a.obj: is not JSON");
    expectContains(opened("a.obj", "v 0 0 0\n"), "a.obj: has no polyline");
    expectContains(opened("a.txt", "v 0 0 0\n"), "curves are read from .json");
    const auto withOption = [&](const std::string& options) {
        const std::string pick =
            R"({"points": [[0,0,0]], "faces": [0], "barycentrics": [[1,0,0]]})";
        return opened(
            "a.json", R"({"closed": true, "picks": )" + pick + R"(, "options": )" + options + "}"
        );
    };
    expectContains(withOption(R"({"degree": 2.5})"), "option \"degree\" is not a whole number");
    expectContains(withOption(R"({"degree": 99})"), "degree");
    expectContains(withOption(R"({"field": "none at all"})"), "field must be one of");
    expectContains(withOption("[]"), "\"options\" is no object");
}

TEST_F(DrawnCurveFile, OfALaterVersionIsOpenedWithoutTheOptionsThatAreNotKnown) {
    saveDrawnCurves(path("a.json"), std::span(curves_).first(1), surface_);
    std::string text = read(path("a.json"));
    const std::string before = "\"options\":{";
    text.insert(text.find(before) + before.size(), "\"strokes\":7,");
    write("b.json", text);
    const OpenedCurves opened = openDrawnCurves(path("b.json"), surface_);
    EXPECT_EQ(opened.curves.at(0).options, curves_[0].drawn.options);
    ASSERT_EQ(opened.notes.size(), 1U);
    expectContains(opened.notes[0], "the option \"strokes\" is not known here");
}

TEST_F(DrawnCurveFile, ThatIsDamagedIsRefusedOrOpened) {
    std::mt19937 random(7);
    for (const char* const name : {"a.json", "a.obj", "a.dxf"}) {
        saveDrawnCurves(path(name), curves_, surface_);
        const std::string bytes = read(path(name));
        for (int i = 0; i < 300; ++i) {
            write(name, damaged(bytes, "0123456789.-e[]{},:\"ab \\", random));
            try {
                const OpenedCurves opened = openDrawnCurves(path(name), surface_);
                for (const DrawnCurve& curve : opened.curves) {
                    for (const SketchPick& pick : curve.picks) {
                        ASSERT_LT(pick.point.face, surface_.mesh.faces.size());
                        ASSERT_TRUE(pick.position.allFinite());
                    }
                }
            } catch (const InputError& error) {
                expectContains(error.what(), name);
            }
        }
    }
}

TEST_F(DrawnCurveFile, OnABrokenMeshHasItsFaces) {
    TriangleMesh mesh = designer_.mesh();
    mesh.faces.insert(mesh.faces.begin() + 10, mesh.faces[10]);  // twice
    std::swap(mesh.faces[5][0], mesh.faces[5][1]);               // turned over
    const Workpiece workpiece(mesh);
    const CurveFileSurface broken{
        .mesh = mesh, .checksum = checksumOf(mesh), .workpiece = &workpiece
    };
    CurveToSave curve{.drawn = curves_[0].drawn, .curve = nullptr};
    curve.drawn.picks = {pickAt(mesh, 5, {0.1, 0.2, 0.7}), pickAt(mesh, 101, {0.1, 0.2, 0.7})};
    saveDrawnCurves(path("a.json"), std::span(&curve, 1), broken);
    expectContains(read(path("a.json")), "\"faces\":[5,101]");
    const OpenedCurves opened = openDrawnCurves(path("a.json"), broken);
    EXPECT_TRUE(opened.notes.empty());
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(opened.curves[0].picks[i].point.face, curve.drawn.picks[i].point.face);
        EXPECT_EQ(opened.curves[0].picks[i].position, curve.drawn.picks[i].position);
    }
    // Elsewhere they are projected to the surface, whose faces are others.
    const CurveFileSurface moved{.mesh = mesh, .checksum = {}, .workpiece = &workpiece};
    const OpenedCurves projected = openDrawnCurves(path("a.json"), moved);
    EXPECT_EQ(projected.curves[0].picks[1].point.face, 101);
}

TEST(FittingPicks, DescribeALineByItsCornersAndARingByThreeAtLeast) {
    EXPECT_EQ(
        fittingPicks({{{0, 0, 0}, {1, 0, 0}, {2, 1e-4, 0}, {3, 0, 0}, {3, 1, 0}, {3, 2, 0}}}, 1e-3),
        (std::vector<int>{0, 3, 5})
    );
    EXPECT_EQ(fittingPicks({{{0, 0, 0}, {1, 0, 0}}}, 1e-3), (std::vector<int>{0, 1}));
    EXPECT_EQ(
        fittingPicks({{{0, 0, 0}, {1, 1e-4, 0}, {2, 0, 0}, {1, -1e-5, 0}}, true}, 1e-3),
        (std::vector<int>{0, 1, 2})
    );
    SpacePolyline ring{.points = {}, .closed = true};
    for (int i = 0; i < 1000; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 1000;
        ring.points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    }
    const std::size_t count = fittingPicks(ring, 0.01).size();
    EXPECT_GE(count, 8U);
    EXPECT_LE(count, 32U);
    ring.points.assign(5, Vec3(1, 2, 3));
    EXPECT_EQ(fittingPicks(ring, 0.01), (std::vector<int>{0}));
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

// With and without a workpiece, which knows what mending did to the mesh.
TEST_F(DrawnCurveFile, RefusesLinesThatAreTooFarForTheirSquares) {
    write("a.obj", "v 0 0 0\nv 0.1 1e204 0\nv 0 0 1\nl 1 2 3\n");
    const Workpiece workpiece{TriangleMesh(designer_.mesh())};
    for (const Workpiece* const known : {static_cast<const Workpiece*>(nullptr), &workpiece}) {
        surface_.workpiece = known;
        expectContains(
            refusal(
                [&] { return openDrawnCurves(path("a.obj"), surface_); }, InputErrorCode::PickTooFar
            ),
            "a.obj: no curve is near the surface"
        );
    }
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
