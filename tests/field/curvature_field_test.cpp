// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature fields against surfaces whose curvature is known.
#include "field/curvature_field.h"

#include "field/curvature_tensors.h"
#include "field/make_field.h"
#include "support/meshes.h"
#include "support/orientation.h"
#include "support/random.h"
#include "support/refusal.h"
#include "surface/vertex_normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <tuple>

namespace bspline_curve {
namespace {

using namespace test_support;

const double kScale = FieldOptions().curvatureScale;

std::vector<double> fieldOn(const Surface& surface, FieldKind kind) {
    return makeField(surface, {.kind = kind}).values();
}

/// Largest difference between two values at a vertex; there must be some.
double largestGap(
    const std::vector<double>& values, const std::function<double(std::size_t)>& expected
) {
    EXPECT_FALSE(values.empty());
    double gap = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        gap = std::max(gap, std::abs(values[i] - expected(i)));
    }
    return gap;
}

/// Root mean square of the differences between two fields.
double meanGap(const std::vector<double>& values, double expected) {
    double sum = 0.0;
    for (const double value : values) {
        sum += (value - expected) * (value - expected);
    }
    return std::sqrt(sum / static_cast<double>(values.size()));
}

// A quadric misses the terms of fourth order of a sphere: at two rings, of width 2 h, its curvature
// is off by about (2 h / radius)^2 / 4; measured 0.7 of that.
TEST(CurvatureField, OfASphereIsOneOverTheRadius) {
    for (const int subdivisions : {2, 3, 4, 5}) {
        for (const double radius : {1e-6, 1.0, 1e6}) {
            const Surface surface(icosphere(subdivisions, radius));
            const double exact = kCurvatureLength * surface.diagonal() / radius;
            const double h = surface.averageEdgeLength() / radius;
            const auto curvatures = principalCurvatures(surface, kScale);
            for (const auto& [largest, smallest] : curvatures) {
                EXPECT_NEAR(largest, exact, exact * h * h) << subdivisions << " " << radius;
                EXPECT_NEAR(smallest, exact, exact * h * h) << subdivisions << " " << radius;
            }
        }
    }
}

// A graph of a quadric is what is fitted: -(h_xx, h_xy; h_xy, h_yy) with the curvatures' places
// changed, exact at the point where it is level.
TEST(CurvatureTensors, OfAQuadricAreExact) {
    TriangleMesh mesh = jitteredPlate(8, 8, 0.2, 3);
    const Vec3 centre = mesh.vertices[40];
    for (Vec3& vertex : mesh.vertices) {
        const double x = vertex.x() - centre.x();
        const double y = vertex.y() - centre.y();
        vertex.z() = -0.3 * x * x - 0.1 * x * y + 0.2 * y * y;
    }
    const std::vector<Vec3> up(mesh.vertices.size(), Vec3::UnitZ());
    Eigen::Matrix3d exact;
    exact << -0.4, -0.1, 0.0, -0.1, 0.6, 0.0, 0.0, 0.0, 0.0;
    EXPECT_LT((curvatureTensors(Surface(mesh), up, 2)[40] - exact).norm(), 1e-12);
}

// With one row of faces y^2 is y times a constant at all points: many quadrics fit as well.
TEST(CurvatureTensors, OfAnOpenRingAreThoseOfItsCircle) {
    const Surface surface(openCylinder(60, 1));
    for (const Eigen::Matrix3d& tensor :
         curvatureTensors(surface, vertexNormals(surface.mesh()), 2)) {
        EXPECT_NEAR(tensor.trace(), 1.0, 0.02);
        EXPECT_NEAR(tensor(2, 2), 1.0, 0.02);
    }
}

/// A cone of so many faces around its tip, with a ring of quads below them.
TriangleMesh coneWithARing(int segments) {
    TriangleMesh mesh = openCylinder(segments, 1);
    for (Vec3& vertex : mesh.vertices) {
        vertex.head<2>() *= vertex.z() > 0.0 ? 1.0 : 2.0;
    }
    const auto tip = static_cast<int>(mesh.vertices.size());
    mesh.vertices.emplace_back(0, 0, 4);
    for (int i = 0; i < segments; ++i) {
        mesh.faces.push_back({segments + i, segments + (i + 1) % segments, tip});
    }
    return mesh;
}

// Else each vertex around a large fan would see all others, in a time of the square of their
// number.
TEST(CurvatureTensors, DoNotDependOnTheFarSideOfALargeFan) {
    for (const int segments : {50, 200}) {
        TriangleMesh mesh = coneWithARing(segments);
        const std::vector<Vec3> normals = vertexNormals(mesh);
        const auto at = [&](int vertex) {
            return curvatureTensors(Surface(mesh), normals, 2)[vertex];
        };
        const int near = segments;
        const int far = segments + segments / 4;  // whose normal is on the same side
        const Eigen::Matrix3d before = at(near);
        mesh.vertices[far] *= 1.1;
        EXPECT_EQ(at(near) == before, segments == 200);
        EXPECT_NE(before, Eigen::Matrix3d::Zero());
    }
}

// Up to the boundary; also with faces 7 times as long as wide.
TEST(CurvatureField, OfACylinderIsThatOfItsCircleUpToTheBoundary) {
    for (const auto& [segments, rings, error] : {std::tuple{160, 80, 0.01}, {200, 10, 0.1}}) {
        const Surface surface(openCylinder(segments, rings));
        const double exact = kCurvatureLength * surface.diagonal();
        for (const auto& [largest, smallest] : principalCurvatures(surface, kScale)) {
            EXPECT_NEAR(largest, exact, 0.01 * exact);
            EXPECT_NEAR(smallest, 0.0, error * exact);
        }
    }
}

// cos(tube) / distance from the axis along the circles about the axis, 1 / 0.3 along the tube.
TEST(CurvatureField, OfATorusHasBothOfItsCurvatures) {
    for (const bool inside : {false, true}) {
        const TriangleMesh mesh = torus(200, 60);
        const Surface surface(inside ? insideOut(mesh) : mesh);
        const double length = kCurvatureLength * surface.diagonal();
        const auto curvatures = principalCurvatures(surface, kScale);
        for (std::size_t i = 0; i < curvatures.size(); ++i) {
            const double distance = mesh.vertices[i].head<2>().norm();
            const double around = length * (distance - 1.0) / 0.3 / distance;
            const double tube = length / 0.3;
            EXPECT_NEAR(curvatures[i].largest, inside ? -around : tube, 0.02 * tube);
            EXPECT_NEAR(curvatures[i].smallest, inside ? -tube : around, 0.02 * tube);
        }
    }
}

// (25) is the constant 1 / 0.3 on the outside of a torus; ridges are strongest on its outer half,
// and valleys of the torus turned inside out as well.
TEST(CurvatureField, RidgesTellTheCirclesOfATorusApart) {
    const TriangleMesh mesh = torus(200, 60);
    const Surface surface(mesh);
    const auto ridge = fieldOn(surface, FieldKind::Ridge);
    const auto reversed = fieldOn(Surface(insideOut(mesh)), FieldKind::Valley);
    const double length = kCurvatureLength * surface.diagonal();
    const auto exact = [&](std::size_t i) {
        const double distance = mesh.vertices[i].head<2>().norm();
        const double around = (distance - 1.0) / 0.3 / distance;
        return length * (1.0 / 0.3 - std::max(0.0, -around));
    };
    EXPECT_LT(largestGap(ridge, exact), 0.02 * length / 0.3);
    EXPECT_LT(largestGap(reversed, [&](std::size_t i) { return ridge[i]; }), 1e-9);
    EXPECT_LT(meanGap(fieldOn(surface, FieldKind::Valley), 0.0), 1e-9);
}

TEST(CurvatureField, CreasesAreCheapAndFlatPartsAreNot) {
    const auto onEdge = [](const Vec3& p) {
        return p.x() == 0.0 && p.y() == 0.0 && p.z() > 0.3 && p.z() < 0.7;
    };
    const auto isFlat = [](const Vec3& p) {
        return p.x() == 0.0 && std::abs(p.y() - 0.5) < 0.2 && std::abs(p.z() - 0.5) < 0.2;
    };
    const Eigen::Isometry3d turned = Random(3).isometry(1.0);
    for (const int cells : {20, 40, 80, 160}) {
        const TriangleMesh mesh = box(cells);
        const auto field = fieldOn(Surface(transformed(mesh, turned)), FieldKind::MaximalCurvature);
        for (std::size_t i = 0; i < field.size(); ++i) {
            const double cost = std::exp(-field[i]);
            if (onEdge(mesh.vertices[i])) {
                EXPECT_LT(cost, 0.1) << cells;
            } else if (isFlat(mesh.vertices[i])) {
                EXPECT_NEAR(cost, 1.0, 1e-6) << cells;
            }
            EXPECT_GE(field[i], kLeastCurvature);
            EXPECT_LE(field[i], kMostCurvature);
        }
    }
    const TriangleMesh inverted = insideOut(box(40));
    const auto field = fieldOn(Surface(inverted), FieldKind::MaximalCurvature);
    const auto valley = fieldOn(Surface(inverted), FieldKind::Valley);
    for (std::size_t i = 0; i < field.size(); ++i) {
        if (onEdge(inverted.vertices[i])) {
            EXPECT_LT(field[i], 0.1);
            EXPECT_LT(std::exp(-valley[i]), 0.1);
        }
    }
}

// The same curvatures on a mesh that was moved and scaled. Its box is another one, so the options
// and values that are relative to the diagonal are converted.
std::vector<double> fieldOnMoved(const TriangleMesh& mesh, std::uint64_t seed, double unit) {
    const Surface moved(transformed(mesh, Random(seed).isometry(10.0), unit));
    const double share = moved.diagonal() / unit / Surface(mesh).diagonal();
    std::vector<double> values;
    for (const auto& [largest, smallest] : principalCurvatures(moved, kScale / share)) {
        values.push_back(largest / share);
    }
    return values;
}

TEST(CurvatureField, IsTheSameInEveryUnitAndPosition) {
    const TriangleMesh mesh = withNoise(torus(120, 40), 0.002, 5);
    const auto curvatures = principalCurvatures(Surface(mesh), kScale);
    for (const double unit : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
        const auto moved = fieldOnMoved(mesh, 6, unit);
        EXPECT_LT(largestGap(moved, [&](std::size_t i) { return curvatures[i].largest; }), 1e-4)
            << unit;
    }
}

// Sums that are exactly zero must not hide a crease.
TEST(CurvatureField, CreasesAlongTheAxesAreThoseOfTurnedOnes) {
    const TriangleMesh mesh = box(30);
    const auto curvatures = principalCurvatures(Surface(mesh), kScale);
    const auto moved = fieldOnMoved(mesh, 4, 1.0);
    EXPECT_LT(largestGap(moved, [&](std::size_t i) { return curvatures[i].largest; }), 1e-3);
}

TEST(CurvatureField, DoesNotDependOnNumbers) {
    const TriangleMesh mesh = withNoise(icosphere(4), 0.005, 7);
    const TriangleMesh other = renumbered(mesh, 8);
    auto field = fieldOn(Surface(mesh), FieldKind::MaximalCurvature);
    auto same = fieldOn(Surface(other), FieldKind::MaximalCurvature);
    std::ranges::sort(field);
    std::ranges::sort(same);
    EXPECT_LT(largestGap(field, [&](std::size_t i) { return same[i]; }), 1e-9);
}

// The same polyhedron with more vertices, up to mean edges of twice the scale: its curvature, that
// of its edges, is spread over scale and rings. Measured 5 % on the coarsest, 1.5 % on the finest.
TEST(CurvatureField, ChangesLittleWhereFacesAreSplit) {
    for (const int segments : {60, 120, 240}) {
        const TriangleMesh coarse = torus(segments, segments / 3);
        const auto field = fieldOn(Surface(coarse), FieldKind::MaximalCurvature);
        auto fine = fieldOn(Surface(midpointSubdivide(coarse)), FieldKind::MaximalCurvature);
        fine.resize(field.size());
        EXPECT_LT(largestGap(fine, [&](std::size_t i) { return field[i]; }), 0.08 * field[0]);
    }
}

// Noise of a tenth of an edge turns normals by 10 degrees; its curvature without averaging would be
// about 0.1 h / h^2, 0.2 to 0.9 in this field's unit.
TEST(CurvatureField, SeesThroughNoise) {
    for (const int subdivisions : {4, 5, 6}) {
        const TriangleMesh mesh = icosphere(subdivisions);
        const double h = Surface(mesh).averageEdgeLength();
        const Surface noisy(withNoise(mesh, 0.1 * h, 9));
        const double exact = kCurvatureLength * noisy.diagonal();
        const auto field = fieldOn(noisy, FieldKind::MaximalCurvature);
        EXPECT_LT(meanGap(field, exact), 0.12) << subdivisions;
        const auto wide = makeField(noisy, {.curvatureScale = 4.0 * kScale}).values();
        EXPECT_LT(meanGap(wide, exact), 0.4 * meanGap(field, exact));
    }
}

TEST(CurvatureField, IsZeroWhereThereIsNothingToFit) {
    // A tetrahedron has no five vertices around a sixth; the last vertex has no faces.
    const Surface surface(
        {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 5, 5}},
         .faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}}
    );
    for (const FieldKind kind :
         {FieldKind::MaximalCurvature, FieldKind::Ridge, FieldKind::Valley}) {
        EXPECT_EQ(fieldOn(surface, kind), std::vector<double>(5, 0.0)) << name(kind);
    }
}

TEST(CurvatureField, RefusesScalesThatAreNoShares) {
    const Surface surface(icosphere(1));
    for (const double scale : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
        expectRefused(
            [&] { return makeField(surface, {.curvatureScale = scale}); },
            InputErrorCode::BadOption,
            "curvature scale"
        );
    }
}

TEST(CurvatureField, CanBeCancelled) {
    const Surface surface(icosphere(3));
    EXPECT_THROW(
        static_cast<void>(makeField(surface, {}, {}, [](double, const char*) { return false; })),
        Cancelled
    );
    double last = 0.0;
    static_cast<void>(makeField(surface, {}, {}, [&](double fraction, const char*) {
        EXPECT_GE(fraction, last);
        last = fraction;
        return true;
    }));
    EXPECT_EQ(last, 1.0);
}

// Also while two threads average.
TEST(CurvatureField, CanBeCancelledAtEachReport) {
    const Surface surface(icosphere(6));
    int reports = 0;
    std::set<std::string> stages;
    static_cast<void>(makeField(surface, {}, {}, [&](double, const char* stage) {
        ++reports;
        stages.insert(stage);
        return true;
    }));
    EXPECT_GT(reports, 8);
    EXPECT_EQ(stages, (std::set<std::string>{"curvature", "field", "smoothing"}));
    for (const int last : {reports / 3, reports / 2, reports - 3}) {
        int count = 0;
        const auto cancelAtLast = [&](double, const char*) { return ++count < last; };
        EXPECT_THROW(static_cast<void>(makeField(surface, {}, {}, cancelAtLast)), Cancelled);
        EXPECT_EQ(count, last);
    }
}

}  // namespace
}  // namespace bspline_curve
