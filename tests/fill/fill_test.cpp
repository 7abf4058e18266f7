// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/curve_designer.h"
#include "fill/capped_parts.h"
#include "fill/fill_holes.h"
#include "fill/mesh_holes.h"
#include "fill/part_filling.h"
#include "imprint/random_curves.h"
#include "support/many_cases.h"
#include "support/meshes.h"
#include "support/orientation.h"
#include "support/refusal.h"
#include "support/seeds.h"
#include "surface/self_intersection.h"
#include "surface/surface.h"
#include "surface/triangle_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

using namespace test_support;

bool isWatertight(const Surface& surface) {
    return std::ranges::all_of(surface.faceNeighbours(), [](const Triangle& neighbours) {
        return std::ranges::all_of(neighbours, [](int face) { return face >= 0; });
    });
}

/// The mesh without the faces whose corners all satisfy a condition.
template <class Condition>
TriangleMesh without(TriangleMesh mesh, const Condition& condition) {
    std::erase_if(mesh.faces, [&](const Triangle& face) {
        return std::ranges::all_of(face, [&](int v) { return condition(mesh.vertices[v]); });
    });
    return mesh;
}

FilledMesh filled(const TriangleMesh& mesh, FillShape shape) {
    return fillHoles(mesh, rimsOf(mesh.faces), shape);
}

void expectGivenComesFirst(const TriangleMesh& given, const TriangleMesh& result) {
    ASSERT_GE(result.vertices.size(), given.vertices.size());
    EXPECT_TRUE(
        std::ranges::equal(
            given.vertices,
            std::vector(
                result.vertices.begin(), result.vertices.begin() + std::ssize(given.vertices)
            )
        )
    );
    EXPECT_TRUE(
        std::ranges::equal(
            given.faces,
            std::vector(result.faces.begin(), result.faces.begin() + std::ssize(given.faces))
        )
    );
}

TEST(Fill, ASmoothCapComesNearTheSphereThatItIsCutFrom) {
    for (const int subdivisions : {3, 4}) {
        const TriangleMesh sphere = icosphere(subdivisions);
        const Vec3 axis = Vec3(0.3, 0.5, 0.8).normalized();
        for (const double degrees : {20.0, 40.0, 60.0, 80.0}) {
            SCOPED_TRACE(std::to_string(subdivisions) + ", " + std::to_string(degrees));
            const double angle = degrees * std::numbers::pi / 180.0;
            const TriangleMesh open =
                without(sphere, [&](const Vec3& v) { return v.dot(axis) > std::cos(angle); });
            const FilledMesh result = filled(open, FillShape::Smooth);
            expectGivenComesFirst(open, result.mesh);
            const Surface surface(result.mesh);
            EXPECT_TRUE(isWatertight(surface));
            EXPECT_EQ(surface.componentCount(), 1);
            double deviation = 0.0;
            for (std::size_t v = open.vertices.size(); v < result.mesh.vertices.size(); ++v) {
                deviation = std::max(deviation, std::abs(result.mesh.vertices[v].norm() - 1.0));
            }
            EXPECT_LT(deviation, 0.02 * std::sin(angle));
            // As many faces as were taken, more or less.
            const double taken = static_cast<double>(sphere.faces.size() - open.faces.size());
            const double given = static_cast<double>(result.mesh.faces.size() - open.faces.size());
            EXPECT_GT(given, 0.6 * taken);
            EXPECT_LT(given, 1.7 * taken);
        }
    }
}

TEST(Fill, APlateGetsItsPlaneBack) {
    const TriangleMesh plate = jitteredPlate(12, 12, 0.2, 5);
    const TriangleMesh open = without(plate, [](const Vec3& v) {
        return std::abs(v.x() - 0.5) < 0.3 && std::abs(v.y() - 0.5) < 0.2;
    });
    std::vector<std::vector<int>> rims = rimsOf(open.faces);
    ASSERT_EQ(rims.size(), 2U);
    std::erase_if(rims, [](const std::vector<int>& rim) { return rim[0] == 0; });  // the outer one
    for (const FillShape shape : {FillShape::Flat, FillShape::Smooth}) {
        const FilledMesh result = fillHoles(open, rims, shape);
        EXPECT_EQ(result.mesh.vertices.size() > open.vertices.size(), shape == FillShape::Smooth);
        EXPECT_TRUE(result.crossing.empty());
        EXPECT_NEAR(Surface(result.mesh).area(), 1.0, 1e-12);
        for (const Vec3& vertex : result.mesh.vertices) {
            EXPECT_NEAR(vertex.z(), 0.0, 1e-12);
        }
    }
}

TEST(Fill, SmoothFacesAreWellShaped) {
    const TriangleMesh open = without(icosphere(4), [](const Vec3& v) { return v.z() > 0.6; });
    const FilledMesh result = filled(open, FillShape::Smooth);
    for (std::size_t f = open.faces.size(); f < result.mesh.faces.size(); ++f) {
        const auto& [a, b, c] = result.mesh.faces[f];
        const Vec3 &p = result.mesh.vertices[a], &q = result.mesh.vertices[b],
                   &r = result.mesh.vertices[c];
        const double longest = std::max({(p - q).norm(), (q - r).norm(), (r - p).norm()});
        EXPECT_GT((q - p).cross(r - p).norm() / (longest * longest), 0.2) << "face " << f;
    }
}

/// Longest side over the height on it, 1 for an equilateral triangle, of new faces, ascending.
std::vector<double> aspectsOfNewFaces(const FilledParts& parts) {
    std::vector<double> aspects;
    for (std::size_t f = parts.firstFace.at(0); f < parts.mesh.faces.size(); ++f) {
        const auto& [a, b, c] = parts.mesh.faces[f];
        const Vec3& p = parts.mesh.vertices[a];
        const Vec3& q = parts.mesh.vertices[b];
        const Vec3& r = parts.mesh.vertices[c];
        const double longest = std::max({(p - q).norm(), (q - r).norm(), (r - p).norm()});
        aspects.push_back(
            0.5 * std::numbers::sqrt3 * longest * longest / (q - p).cross(r - p).norm()
        );
    }
    std::ranges::sort(aspects);
    return aspects;
}

TEST(Fill, SmoothFacesBesideShortPiecesOfACurveAreWellShaped) {
    // A curve passes edges near their ends as well, so that its rim has long and short edges.
    const TriangleMesh mesh = icosphere(4);
    const CurveDesigner designer(mesh);
    SolverOptions options;
    options.closed = true;
    for (const double height : {0.5, 0.8}) {
        std::vector<Vec3> picks;
        for (int i = 0; i < 5; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / 5 + 0.3;
            picks.push_back(
                Vec3(std::cos(angle), std::sin(angle), height + (i % 2) * 0.2).normalized()
            );
        }
        const std::array lines{designer.design(picks, options).polyline};
        const ImprintedMesh imprinted = imprint(Surface(mesh), lines, {});
        const std::vector<double> aspects =
            aspectsOfNewFaces(fillAround(imprinted, partsOf(imprinted), {0}, FillShape::Smooth));
        EXPECT_LT(aspects[aspects.size() * 95 / 100], 8.0) << "height " << height;
    }
}

TEST(Fill, ALargeSmoothCapIsFairAndWellShaped) {
    // So many faces that the patch is made coarse first.
    const TriangleMesh sphere = icosphere(6);
    const TriangleMesh open = without(sphere, [](const Vec3& v) { return v.z() > 0.2; });
    const FilledMesh result = filled(open, FillShape::Smooth);
    const std::size_t added = result.mesh.faces.size() - open.faces.size();
    EXPECT_NEAR(static_cast<double>(added), 0.4 * static_cast<double>(sphere.faces.size()), 8000.0);
    double farthest = 0.0;
    for (std::size_t v = open.vertices.size(); v < result.mesh.vertices.size(); ++v) {
        farthest = std::max(farthest, std::abs(result.mesh.vertices[v].norm() - 1.0));
    }
    EXPECT_LT(farthest, 0.02);
    double sharpest = 1.0;
    for (std::size_t f = open.faces.size(); f < result.mesh.faces.size(); ++f) {
        const auto& [a, b, c] = result.mesh.faces[f];
        const Vec3& p = result.mesh.vertices[a];
        const Vec3 normal =
            (result.mesh.vertices[b] - p).cross(result.mesh.vertices[c] - p).normalized();
        sharpest = std::min(sharpest, normal.dot(p.normalized()));
    }
    EXPECT_GT(sharpest, 0.98);
}

TEST(Fill, LongRimsAreFilledInTwoSteps) {
    const TriangleMesh open = openCylinder(1500, 1);
    ASSERT_EQ(rimsOf(open.faces)[0].size(), 1500U);
    const Surface surface(filled(open, FillShape::Flat).mesh);
    EXPECT_TRUE(isWatertight(surface));
    constexpr double kArea = 2.0 * std::numbers::pi + 4.0 * std::numbers::pi;
    EXPECT_NEAR(surface.area(), kArea, 1e-3);
}

TEST(Fill, MakesNoEdgeThatTheMeshHas) {
    // The lid of a box without its upper face has every edge but the diagonals; without two of its
    // faces, the rim's chord is an edge beyond.
    const TriangleMesh open = without(box(1), [](const Vec3& v) { return v.z() > 0.5; });
    EXPECT_TRUE(isWatertight(Surface(filled(open, FillShape::Flat).mesh)));
    EXPECT_TRUE(isWatertight(Surface(filled(open, FillShape::Smooth).mesh)));
    // A tetrahedron without two faces: the one chord is there already, the other is free.
    const TriangleMesh two{
        .vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)},
        .faces = {{0, 1, 3}, {1, 2, 3}}
    };
    EXPECT_TRUE(isWatertight(Surface(filled(two, FillShape::Flat).mesh)));
}

TEST(Fill, ClosesEveryPartOfRandomNetworks) {
    for (const TriangleMesh& mesh : {icosphere(2), torus(14, 9), box(2)}) {
        const Surface surface(mesh);
        forEachSeed(caseCount(25, 2), [&](Random& random) {
            const ImprintedMesh imprinted = imprint(surface, randomCurves(surface, random), {});
            const MeshParts parts = partsOf(imprinted);
            for (const int label : partedParts(imprinted, parts)) {
                const FilledParts result = fillAround(imprinted, parts, {label}, FillShape::Smooth);
                const Surface whole(result.mesh);
                ASSERT_TRUE(isWatertight(whole));
                ASSERT_EQ(whole.componentCount(), 1);
                ASSERT_EQ(result.openRims, 0);
            }
        });
    }
}

TEST(Fill, IsAsDenseAsTheMeshAroundACurve) {
    // Beside an imprinted curve there are many short edges, which say nothing of the mesh.
    const TriangleMesh mesh = icosphere(5);
    const CurveDesigner designer(mesh);
    SolverOptions options;
    options.closed = true;
    const std::vector<Vec3> picks{{0.6, 0, 0.8}, {0, 0.6, 0.8}, {-0.6, 0, 0.8}, {0, -0.6, 0.8}};
    const std::array lines{designer.design(picks, options).polyline};
    const ImprintedMesh imprinted = imprint(Surface(mesh), lines, {});
    const MeshParts parts = partsOf(imprinted);
    const FilledParts result = fillAround(imprinted, parts, {0}, FillShape::Smooth);
    const auto added = std::ranges::count(result.labels, -1);
    const double removed = parts.parts[1].faces;
    EXPECT_GT(static_cast<double>(added), 0.7 * removed);
    EXPECT_LT(static_cast<double>(added), 1.4 * removed);
}

TEST(Fill, NewVerticesCarryWhatIsHarmonicFromTheirRim) {
    // A linear function is harmonic in a plane; so it comes back as it was.
    const Surface surface(jitteredPlate(8, 8, 0.2, 7));
    const SurfacePolyline square = alongGrid(
        surface,
        8,
        {{2, 2},
         {3, 2},
         {4, 2},
         {5, 2},
         {5, 3},
         {5, 4},
         {5, 5},
         {4, 5},
         {3, 5},
         {2, 5},
         {2, 4},
         {2, 3}},
        true
    );
    const ImprintedMesh imprinted = imprint(surface, std::vector{square}, {});
    const FilledParts result = fillAround(imprinted, partsOf(imprinted), {0}, FillShape::Smooth);
    std::vector<double> given;
    for (const Vec3& vertex : imprinted.mesh.vertices) {
        given.push_back(2.0 * vertex.x() - vertex.y());
    }
    const std::vector<double> values = result.carried(given);
    ASSERT_EQ(values.size(), result.mesh.vertices.size());
    ASSERT_GT(result.endOfNew, result.firstNew.at(0));
    for (std::size_t v = 0; v < values.size(); ++v) {
        const Vec3& vertex = result.mesh.vertices[v];
        EXPECT_NEAR(values[v], 2.0 * vertex.x() - vertex.y(), result.source[v] < 0 ? 0.02 : 0.0);
    }
}

/// A closed curve round a point of a sphere-like mesh, imprinted.
ImprintedMesh ringOn(const TriangleMesh& mesh, double radius, int lobes) {
    const CurveDesigner designer(mesh);
    SolverOptions options;
    options.closed = true;
    const TriangleTree tree(mesh.vertices, mesh.faces);
    std::vector<Vec3> picks;
    const int count = 2 * lobes;
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / count;
        const double reach = radius * (i % 2 == 0 ? 1.0 : 0.6);
        const Vec3 direction(reach * std::cos(angle), reach * std::sin(angle), 1.0);
        picks.push_back(tree.firstHit(Vec3::Zero(), direction).position);
    }
    return imprint(Surface(mesh), std::array{designer.design(picks, options).polyline}, {});
}

TriangleMesh waves(double height) {
    TriangleMesh mesh = icosphere(4);
    for (Vec3& v : mesh.vertices) {
        v *= 1.0 + height * std::sin(9.0 * v.x()) * std::cos(8.0 * v.y());
    }
    return mesh;
}

TEST(Fill, OfEitherSideOfACurveCrossesNothing) {
    TriangleMesh lens = icosphere(4);
    for (Vec3& v : lens.vertices) {
        v.z() *= 0.05;
    }
    TriangleMesh needle = icosphere(4);
    for (Vec3& v : needle.vertices) {
        v *= 1.0 + 2.0 * std::pow(std::max(v.z(), 0.0), 30.0);
    }
    std::size_t tried = 0;
    for (const TriangleMesh& mesh :
         {icosphere(4), waves(0.1), withNoise(icosphere(4), 0.01, 3), lens, needle}) {
        for (const auto& [radius, lobes] : {std::pair{0.3, 2}, std::pair{0.6, 3}}) {
            const ImprintedMesh imprinted = ringOn(mesh, radius, lobes);
            const MeshParts parts = partsOf(imprinted);
            ASSERT_EQ(parts.parts.size(), 2U);
            for (const int kept : {0, 1}) {
                for (const FillShape shape : {FillShape::Flat, FillShape::Smooth}) {
                    SCOPED_TRACE(std::to_string(tried++));
                    const FilledParts result = fillAround(imprinted, parts, {kept}, shape);
                    EXPECT_TRUE(isWatertight(Surface(result.mesh)));
                    EXPECT_TRUE(result.crossing.empty());
                    EXPECT_TRUE(
                        findSelfIntersections(result.mesh.vertices, result.mesh.faces).empty()
                    );
                }
            }
        }
    }
    EXPECT_EQ(tried, 40U);
}

TEST(Fill, APlanarRimGetsAFlatDisc) {
    // The cap of a sphere above a plane, of which all rim vertices are at one height.
    TriangleMesh ball = icosphere(5);
    for (Vec3& v : ball.vertices) {
        v.z() = std::abs(v.z() - 0.6) < 0.04 ? 0.6 : v.z();
    }
    const TriangleMesh cap = without(ball, [](const Vec3& v) { return v.z() <= 0.6; });
    const std::vector<std::vector<int>> rims = rimsOf(cap.faces);
    ASSERT_EQ(rims.size(), 1U);
    const FilledMesh result = fillHoles(cap, rims, FillShape::Flat);
    EXPECT_TRUE(result.crossing.empty());
    EXPECT_EQ(result.mesh.vertices.size(), cap.vertices.size());
    for (std::size_t f = cap.faces.size(); f < result.mesh.faces.size(); ++f) {
        for (const int corner : result.mesh.faces[f]) {
            EXPECT_EQ(result.mesh.vertices[corner].z(), 0.6);
        }
    }
    EXPECT_TRUE(findSelfIntersections(result.mesh.vertices, result.mesh.faces).empty());
}

TEST(Fill, NamesTheFacesOfAKnottedRimThatCross) {
    // Every disc with a trefoil as its boundary crosses itself. A narrow band has it as a rim.
    constexpr int kCount = 60;
    TriangleMesh band;
    for (int i = 0; i < kCount; ++i) {
        const double t = 2.0 * std::numbers::pi * i / kCount;
        const Vec3 point(
            std::sin(t) + 2.0 * std::sin(2.0 * t),
            std::cos(t) - 2.0 * std::cos(2.0 * t),
            -std::sin(3.0 * t)
        );
        band.vertices.push_back(point);
        band.vertices.emplace_back(1.05 * point.x(), 1.05 * point.y(), point.z());
        const int next = 2 * ((i + 1) % kCount);
        band.faces.push_back({2 * i, 2 * i + 1, next});
        band.faces.push_back({next, 2 * i + 1, next + 1});
    }
    std::vector<std::vector<int>> rims = rimsOf(band.faces);
    ASSERT_EQ(rims.size(), 2U);
    rims.resize(1);
    for (const FillShape shape : {FillShape::Flat, FillShape::Smooth}) {
        const FilledMesh result = fillHoles(band, rims, shape);
        EXPECT_FALSE(result.crossing.empty());
        for (const int face : result.crossing) {
            EXPECT_GE(face, std::ssize(band.faces));
            EXPECT_LT(face, std::ssize(result.mesh.faces));
        }
        const auto pairs = findSelfIntersections(result.mesh.vertices, result.mesh.faces);
        EXPECT_FALSE(pairs.empty());
        for (const auto& [one, other] : pairs) {
            EXPECT_TRUE(std::ranges::binary_search(result.crossing, other)) << one << ' ' << other;
        }
    }
}

TEST(WithHolesFilled, ClosesThoseThatAreChosen) {
    // Holes round both poles, of 0.2 and 0.5 radians.
    const TriangleMesh open = without(icosphere(4), [](const Vec3& v) {
        return v.z() > std::cos(0.2) || v.z() < -std::cos(0.5);
    });
    const ImprintedMesh imprinted = imprint(Surface(open), {}, {});
    const MeshParts parts = partsOf(imprinted);
    const auto openRims = [&](const HoleChoice& choice) {
        const FilledParts result = withHolesFilled(imprinted, parts, choice, FillShape::Smooth);
        EXPECT_EQ(result.rims.size() + result.openRims, 2U);
        EXPECT_EQ(rimsOf(result.mesh.faces).size(), static_cast<std::size_t>(result.openRims));
        EXPECT_TRUE(findSelfIntersections(result.mesh.vertices, result.mesh.faces).empty());
        return result.openRims;
    };
    EXPECT_EQ(openRims({}), 0);
    EXPECT_EQ(openRims({.mostLength = 2.0}), 1);
    EXPECT_EQ(openRims({.mostEdges = 40}), 1);
    EXPECT_EQ(openRims({.seed = Vec3(0, 0, -1)}), 1);
    const auto firstNewOf = [&](const Vec3& seed) {
        const FilledParts result =
            withHolesFilled(imprinted, parts, {.seed = seed}, FillShape::Smooth);
        return result.mesh.vertices.at(result.firstNew.at(0));
    };
    EXPECT_GT(firstNewOf(Vec3(0, 0, 3)).z(), 0.9);
    EXPECT_LT(firstNewOf(Vec3(0, 0, -3)).z(), -0.8);
    expectRefused(
        [&] { return withHolesFilled(imprinted, parts, {.mostEdges = 3}, FillShape::Flat); },
        InputErrorCode::NoPath,
        "none of 2 holes is as small as that"
    );
    const ImprintedMesh closed = imprint(Surface(icosphere(1)), {}, {});
    expectRefused(
        [&] { return withHolesFilled(closed, partsOf(closed), {}, FillShape::Flat); },
        InputErrorCode::NoPath,
        "no hole"
    );
}

/// The vertices round the tube of a torus about the z axis, at an angle, in order.
std::vector<int> meridian(const TriangleMesh& mesh, double angle) {
    std::vector<std::pair<double, int>> round;
    const Vec3 outwards(std::cos(angle), std::sin(angle), 0.0);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const Vec3& p = mesh.vertices[v];
        if (std::abs(p.x() * outwards.y() - p.y() * outwards.x()) < 1e-9 && p.dot(outwards) > 0) {
            const double radius = std::hypot(p.x(), p.y()) - 1.0;
            round.emplace_back(std::atan2(p.z(), radius), static_cast<int>(v));
        }
    }
    std::ranges::sort(round);
    std::vector<int> vertices;
    for (const auto& [at, vertex] : round) {
        vertices.push_back(vertex);
    }
    return vertices;
}

TEST(CappedParts, GetTheSameTrianglesOnEitherSide) {
    const Surface surface(torus(24, 12));
    const std::vector<int> ring = meridian(surface.mesh(), 0.0);
    ASSERT_EQ(ring.size(), 12U);
    const std::vector<int> other = meridian(surface.mesh(), std::numbers::pi);
    const std::vector<int> slit(other.begin(), other.begin() + 3);
    const std::vector lines{
        polylineAlong(surface, ring, true), polylineAlong(surface, slit, false)
    };
    const ImprintedMesh imprinted = imprint(surface, lines, {});
    const MeshParts parts = partsOf(imprinted);
    const std::optional<CappedParts> both = cappedOnBothSides(imprinted, parts);
    ASSERT_TRUE(both);
    EXPECT_EQ(both->partOf, (std::vector{0, 0}));
    const FilledParts* const capped = &both->whole;
    EXPECT_TRUE(capped->crossing.empty());
    ASSERT_EQ(capped->rims.size(), 2U);
    const Surface whole(capped->mesh);
    EXPECT_TRUE(isWatertight(whole));
    // A torus that is cut through is a sphere.
    const auto faces = static_cast<int>(capped->mesh.faces.size());
    EXPECT_EQ(static_cast<int>(capped->mesh.vertices.size()) - faces / 2, 2);
    const int caps = (faces - capped->firstFace[0]) / 2;
    EXPECT_EQ(caps, 10);
    for (int f = 0; f < caps; ++f) {
        const auto& [a, b, c] = capped->mesh.faces[capped->firstFace[0] + f];
        const auto& [p, q, r] = capped->mesh.faces[capped->firstFace[1] + f];
        EXPECT_EQ(capped->mesh.vertices[a], capped->mesh.vertices[p]);
        EXPECT_EQ(capped->mesh.vertices[b], capped->mesh.vertices[r]);
        EXPECT_EQ(capped->mesh.vertices[c], capped->mesh.vertices[q]);
    }
    const ImprintedMesh slitAlone = imprint(surface, {&lines[1], 1}, {});
    EXPECT_FALSE(cappedOnBothSides(slitAlone, partsOf(slitAlone)));
}

TEST(CappedParts, AreSolidsThatFitTogether) {
    // A bent tube in three pieces, the middle one with two rims.
    const Surface surface(torus(24, 12));
    const std::vector lines{
        polylineAlong(surface, meridian(surface.mesh(), 0.0), true),
        polylineAlong(surface, meridian(surface.mesh(), std::numbers::pi / 2.0), true),
        polylineAlong(surface, meridian(surface.mesh(), std::numbers::pi), true)
    };
    const ImprintedMesh imprinted = imprint(surface, lines, {});
    const MeshParts parts = partsOf(imprinted);
    ASSERT_EQ(parts.parts.size(), 3U);
    const std::optional<CappedParts> capped = cappedOnBothSides(imprinted, parts);
    ASSERT_TRUE(capped);
    EXPECT_EQ(capped->edges, curveEdges(imprinted));
    std::vector<int> owners = capped->partOf;
    std::ranges::sort(owners);
    EXPECT_EQ(owners, (std::vector{0, 0, 1, 1, 2, 2}));
    const std::vector<double> heights = [&] {
        std::vector<double> values;
        for (const Vec3& vertex : imprinted.mesh.vertices) {
            values.push_back(vertex.z());
        }
        return values;
    }();
    double volume = 0.0;
    for (int label = 0; label < 3; ++label) {
        const FilledParts part = cappedParts(*capped, {label});
        EXPECT_TRUE(part.crossing.empty());
        EXPECT_TRUE(isWatertight(Surface(part.mesh)));
        ASSERT_EQ(part.rims.size(), 2U);
        for (const int vertex : part.rims[1]) {
            EXPECT_EQ(part.mesh.vertices[vertex], imprinted.mesh.vertices[part.source[vertex]]);
        }
        EXPECT_EQ(std::ranges::count(part.labels, -1), 20);
        EXPECT_EQ(std::ranges::count(part.labels, label), parts.parts[label].faces);
        const std::vector<double> carried = part.carried(heights);
        for (std::size_t v = 0; v < carried.size(); ++v) {
            EXPECT_NEAR(carried[v], part.mesh.vertices[v].z(), 1e-12);
        }
        volume += volumeOf(part.mesh);
    }
    EXPECT_NEAR(volume, volumeOf(surface.mesh()), 1e-12);
}

TEST(Fill, RefusesWhereTheBoundaryIsPartOfTheRim) {
    const Surface surface(plate(2, 2));
    const ImprintedMesh imprinted =
        imprint(surface, std::vector{polylineAlong(surface, {1, 4, 7}, false)}, {});
    expectRefused(
        [&] { return fillAround(imprinted, partsOf(imprinted), {0}, FillShape::Flat); },
        InputErrorCode::NoPath,
        "there is no hole to fill"
    );
}

}  // namespace

}  // namespace bspline_curve
