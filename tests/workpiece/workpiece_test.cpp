// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/bspline_curve.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

namespace bspline_curve::workpiece_tests {

namespace {

using test_support::icosphere;

/// A ball with a face twice, which mending leaves out.
TriangleMesh ballWithADoubleFace() {
    TriangleMesh mesh = icosphere(3);
    mesh.faces.insert(mesh.faces.begin(), mesh.faces[7]);
    return mesh;
}

std::vector<Vec3> ringOfPicks() {
    return {
        Vec3(0.8, 0.0, 0.6),
        Vec3(0.0, 0.8, 0.6),
        Vec3(-0.8, 0.0, 0.6),
        Vec3(0.0, -0.8, 0.6),
    };
}

TEST(AWorkpiece, MendsAMeshAndKeepsItsIds) {
    const Workpiece workpiece(ballWithADoubleFace());
    EXPECT_EQ(workpiece.mendedMesh().faces.size() + 1, workpiece.mesh().faces.size());
    ASSERT_NE(workpiece.repair(), nullptr);
    EXPECT_EQ(workpiece.repair()->removedDuplicateFaces, std::vector<int>{8});
    EXPECT_EQ(workpiece.mending(), "the mesh was mended: 1 duplicate face removed");
    const Triangle& last = workpiece.mesh().faces.back();
    const Vec3 middle = (workpiece.mesh().vertices[last[0]] + workpiece.mesh().vertices[last[1]] +
                         workpiece.mesh().vertices[last[2]]) /
                        3.0;
    const ClosestPoint closest = workpiece.closestPoint(2.0 * middle);
    EXPECT_EQ(closest.place.face, static_cast<int>(workpiece.mesh().faces.size()) - 1);
    EXPECT_NEAR(closest.distance, middle.norm(), 0.01);
    EXPECT_LT((positionOf(workpiece.mesh(), closest.place) - closest.position).norm(), 1e-14);
    EXPECT_THROW(Workpiece(ballWithADoubleFace(), {.mending = {.strict = true}}), InputError);
}

TEST(AWorkpiece, MayBeMoved) {
    Workpiece first(icosphere(3));
    const Curve before = first.draw(ringOfPicks()).curve;
    const Workpiece second = std::move(first);
    EXPECT_EQ(second.draw(ringOfPicks()).curve.polyline.points, before.polyline.points);
}

TEST(AWorkpiece, TellsWhatPreparingTook) {
    const Workpiece workpiece(icosphere(3));
    EXPECT_GT(workpiece.seconds().validate, 0.0);
    EXPECT_EQ(workpiece.seconds().tree, 0.0);
    workpiece.prepare();
    EXPECT_GT(workpiece.seconds().tree, 0.0);
}

TEST(AWorkpiece, GivesAFieldTheCostOfItsKindUnlessAnotherIsAskedFor) {
    const Workpiece workpiece(test_support::torus(24, 16));
    FieldRequest request;
    request.options.kind = FieldKind::Ridge;
    const ScalarField field = workpiece.field({}, request);
    EXPECT_EQ(field.naturalCost(), FieldCost::ExpMinus);
    EXPECT_EQ(ScalarField(field.values()).naturalCost(), FieldCost::Identity);
    const TriangleMesh& mesh = workpiece.mesh();
    const std::vector<Vec3> picks{mesh.vertices.front(), mesh.vertices[mesh.vertices.size() / 3]};
    const auto drawnWith = [&](FieldCost cost) {
        SolverOptions options;
        options.fieldCost = cost;
        return workpiece.draw(picks, options, {}, {.field = field}).curve.polyline.points;
    };
    EXPECT_EQ(drawnWith(FieldCost::Natural), drawnWith(FieldCost::ExpMinus));
    EXPECT_NE(drawnWith(FieldCost::Natural), drawnWith(FieldCost::Identity));
    CurveOptions all;
    all.field = request;
    EXPECT_EQ(workpiece.draw(picks, all, {}).curve.polyline.points, drawnWith(FieldCost::ExpMinus));
}

TEST(ShortestPath, IsStraightOnAPlane) {
    const Workpiece workpiece(test_support::plate(9, 9));
    const TriangleMesh& mesh = workpiece.mesh();
    const SurfacePoint from = workpiece.closestPoint(mesh.vertices.front()).place;
    const SurfacePoint to = workpiece.closestPoint(mesh.vertices.back()).place;
    const std::optional<SurfacePolyline> path = shortestPath(workpiece, from, to);
    ASSERT_TRUE(path);
    EXPECT_NEAR(lengthOf(*path), (mesh.vertices.back() - mesh.vertices.front()).norm(), 1e-9);
    EXPECT_EQ(path->parameters.front(), 0.0);
    EXPECT_EQ(path->parameters.back(), 1.0);
    EXPECT_FALSE(shortestPath(workpiece, from, from));
    EXPECT_THROW(static_cast<void>(shortestPath(workpiece, {.face = 100000}, to)), InputError);
}

TEST(DistancesToLines, OfAPointOnAPlaneAreStraight) {
    const Workpiece workpiece(test_support::plate(9, 9));
    const TriangleMesh& mesh = workpiece.mesh();
    SurfacePolyline point;
    point.surfacePoints.push_back(workpiece.closestPoint(mesh.vertices.front()).place);
    const std::vector<double> distances =
        distancesToLines(workpiece, {&point, 1}, std::numeric_limits<double>::infinity());
    ASSERT_EQ(distances.size(), mesh.vertices.size());
    for (std::size_t v = 0; v < distances.size(); ++v) {
        EXPECT_NEAR(distances[v], (mesh.vertices[v] - mesh.vertices.front()).norm(), 1e-9);
    }
}

TEST(FacesWithin, AreTheBandOfTheLinesBeside) {
    const Workpiece workpiece(icosphere(3));
    SolverOptions options;
    options.closed = true;
    const SurfacePolyline line = workpiece.draw(ringOfPicks(), options).curve.polyline;
    OffsetOptions offset;
    offset.distance = 0.2;
    const OffsetLines lines = linesBeside(workpiece, {&line, 1}, offset, true);
    EXPECT_EQ(lines.pieces.size(), 2U);
    EXPECT_EQ(facesWithin(workpiece, line, offset), lines.band);
}

TEST(AnImprint, TellsItsPartsAndIsCut) {
    const Workpiece workpiece(ballWithADoubleFace());
    SolverOptions options;
    options.closed = true;
    const SurfacePolyline line = workpiece.draw(ringOfPicks(), options).curve.polyline;
    const Imprint imprint = imprintOn(workpiece, {&line, 1});
    ASSERT_EQ(imprint.parts.parts.size(), 2U);
    const CutMeshes cut = cutOn(imprint, {.keep = PartChoice{}, .fill = FillShape::Flat});
    EXPECT_EQ(cut.filledHoles, 1);
    EXPECT_EQ(cut.dropped, std::vector<int>{1});
    const MadeMesh& made = cut.pieces.front().mesh;
    const std::vector<double> heights = [&] {
        std::vector<double> values;
        for (const Vec3& vertex : workpiece.mesh().vertices) {
            values.push_back(vertex.z());
        }
        return made.carried(values);
    }();
    for (std::size_t v = 0; v < heights.size(); ++v) {
        EXPECT_NEAR(heights[v], made.mesh().vertices[v].z(), 1e-9);
    }
}

}  // namespace

}  // namespace bspline_curve::workpiece_tests
