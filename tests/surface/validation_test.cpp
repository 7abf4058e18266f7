// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "support/meshes.h"
#include "support/refusal.h"
#include "surface/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;
using enum InputErrorCode;
using Elements = std::vector<std::int64_t>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

const std::vector<Vec3> kCorners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

TriangleMesh changed(TriangleMesh mesh, void (*change)(TriangleMesh& mesh)) {
    change(mesh);
    return mesh;
}

struct Defect {
    std::string name;
    TriangleMesh mesh;
    InputErrorCode code;
    std::optional<Elements> elements{};
    std::vector<std::string> said{""};
};

const Defect kDefects[] = {
    {"no mesh", {}, EmptyMesh},
    {"no faces", changed(plate(2, 2), [](TriangleMesh& m) { m.faces.clear(); }), EmptyMesh},
    {"coordinates that are not finite",
     changed(
         plate(3, 3),
         [](TriangleMesh& m) {
             m.vertices[2][1] = kNaN;
             m.vertices[5][0] = -kInfinity;
             m.vertices[7][2] = 1e61;
         }
     ),
     NonFiniteCoordinate,
     Elements{2, 5, 7},
     {"3 vertices", "2, 5, 7"}},
    {"indices out of range",
     changed(plate(2, 1), [](TriangleMesh& m) { m.faces[1][2] = 6, m.faces[3][0] = -1; }),
     IndexOutOfRange,
     Elements{1, 3},
     {"0 to 5"}},
    {"a repeated vertex and a repeated position",
     changed(
         plate(4, 1),
         [](TriangleMesh& m) {
             m.faces[2][1] = m.faces[2][0];
             m.vertices.push_back(m.vertices[0]);
             m.faces.push_back({0, 1, static_cast<int>(m.vertices.size()) - 1});
         }
     ),
     DegenerateFace,
     Elements{2, 8}},
    {"many faces with a repeated vertex, of which the message names some",
     changed(
         plate(10, 1),
         [](TriangleMesh& m) {
             std::ranges::for_each(m.faces, [](Triangle& face) { face[2] = face[0]; });
         }
     ),
     DegenerateFace,
     Elements{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19},
     {"20 faces", "0, 1, 2, 3, 4 and 15 more"}},
    {"an edge with three faces",
     threeFacesAtAnEdge(),
     NonManifoldEdge,
     Elements{0, 1, 2},
     {"1 edge joins"}},
    {"two copies of a face",
     {.vertices = kCorners, .faces = {{0, 1, 2}, {1, 2, 0}}},
     NonManifoldEdge,
     Elements{0, 1}},
    {"two copies of a face that are turned opposite ways",
     {.vertices = kCorners, .faces = {{0, 1, 2}, {1, 0, 2}}},
     NonManifoldEdge,
     Elements{0, 1}},
    // Around vertex 1 the copies lie in a closed chain of faces that passes the edge (0, 1) twice.
    {"two copies of a face between crowded edges",
     {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}},
      .faces = {{1, 0, 2}, {1, 2, 3}, {1, 3, 0}, {1, 0, 4}, {1, 4, 0}}},
     NonManifoldEdge,
     Elements{0, 2, 3, 4},
     {"3 edges join"}},
    {"a face that is turned over, found with its three neighbours",
     withFaceReversed(icosphere(0), 7),
     InconsistentOrientation,
     Elements{4, 7, 16, 17},
     {"3 edges join"}},
    {"a one-sided surface",
     moebiusStrip(12),
     InconsistentOrientation,
     std::nullopt,
     {"1 edge joins", "one-sided"}},
    {"a vertex with two fans", bowTie(), NonManifoldVertex, Elements{0}},
    // The second sphere's vertex 0 becomes the first's vertex 3.
    {"two closed surfaces that share a vertex",
     changed(
         twoComponents(),
         [](TriangleMesh& m) {
             const int second = static_cast<int>(m.vertices.size()) / 2;
             for (Triangle& face : m.faces) {
                 std::ranges::replace(face, second, 3);
             }
         }
     ),
     NonManifoldVertex,
     Elements{3}},
};

TEST(Validation, RefusesDefectsAndNamesTheElements) {
    for (const auto& [name, mesh, code, elements, said] : kDefects) {
        SCOPED_TRACE(name);
        for (const std::string& text : said) {
            expectRefused([&] { return Surface(mesh); }, code, text, elements);
        }
    }
}

TEST(Validation, AcceptsUnreferencedVerticesAnywhere) {
    const Surface surface(changed(plate(1, 1), [](TriangleMesh& m) {
        m.vertices.emplace_back(0, 0, kNaN);
    }));
    EXPECT_EQ(surface.vertexCount(), 5);
    EXPECT_DOUBLE_EQ(surface.diagonal(), std::sqrt(2.0));
}

TEST(Validation, RefusesCollinearCornersEvenWhereRoundingLiftsThemOffTheLine) {
    // y = 3 x in decimal fractions is not exactly collinear in binary.
    for (const double offset : {0.0, 1e3, 1e6}) {
        SCOPED_TRACE("offset " + std::to_string(offset));
        const auto point = [&](double x) { return Vec3(offset + x, offset + 3.0 * x, 0.7 * x); };
        const TriangleMesh mesh{
            .vertices = {point(0.1), point(0.2), point(0.7)}, .faces = {{0, 1, 2}}
        };
        expectRefused([&] { return Surface(mesh); }, DegenerateFace);
    }
}

TEST(Validation, AcceptsNeedlesWhoseHeightIsMoreThanRounding) {
    const TriangleMesh needle{
        .vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-13, 0}}, .faces = {{0, 1, 2}}
    };
    EXPECT_EQ(Surface(needle).faceNormal(0), Vec3::UnitZ());
}

TEST(Validation, AcceptsAnyUnitOfLength) {
    for (const double scale : {1e-30, 1e-9, 1.0, 1e9, 1e30}) {
        const TriangleMesh mesh = transformed(icosphere(1), Eigen::Isometry3d::Identity(), scale);
        EXPECT_EQ(Surface(mesh).componentCount(), 1) << "scale " << scale;
    }
}

TEST(Validation, ReportsTheFirstOfSeveralDefectsInTheDocumentedOrder) {
    TriangleMesh mesh = joined(bowTie(), withFaceReversed(icosphere(0), 2));
    const auto validate = [&] { return Surface(mesh); };
    expectRefused(validate, InconsistentOrientation);
    mesh = joined(mesh, threeFacesAtAnEdge());
    expectRefused(validate, NonManifoldEdge);
    mesh.faces.push_back({0, 0, 1});
    expectRefused(validate, DegenerateFace);
    mesh.faces.push_back({0, 1, 1000});
    expectRefused(validate, IndexOutOfRange);
    mesh.vertices[0][0] = kNaN;
    expectRefused(validate, NonFiniteCoordinate);
}

}  // namespace
}  // namespace bspline_curve
