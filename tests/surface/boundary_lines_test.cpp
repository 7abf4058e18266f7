// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/lines.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

Vec3 middleOf(const TriangleMesh& mesh, std::size_t f) {
    const Triangle& face = mesh.faces[f];
    return (mesh.vertices[face[0]] + mesh.vertices[face[1]] + mesh.vertices[face[2]]) / 3.0;
}

/// Expects that each edge between faces of two labels is part of one line, once, and no other is.
void expectEachEdgeOnce(
    const TriangleMesh& mesh, const std::vector<int>& labels, const std::vector<BoundaryLine>& lines
) {
    std::map<std::pair<int, int>, std::vector<int>> edges;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        for (int k = 0; k < 3; ++k) {
            edges[std::minmax(mesh.faces[f][k], mesh.faces[f][(k + 1) % 3])].push_back(labels[f]);
        }
    }
    std::set<std::pair<int, int>> expected;
    for (const auto& [edge, around] : edges) {
        if (around.size() == 2 && around[0] != around[1]) {
            expected.insert(edge);
        }
    }
    std::set<std::pair<int, int>> seen;
    for (const BoundaryLine& line : lines) {
        const std::size_t count = line.vertices.size();
        for (std::size_t i = 0; i + (line.closed ? 0 : 1) < count; ++i) {
            EXPECT_TRUE(
                seen.insert(std::minmax(line.vertices[i], line.vertices[(i + 1) % count])).second
            );
        }
    }
    EXPECT_EQ(seen, expected);
}

TEST(BoundaryLines, RoundADiskAreOneClosedLine) {
    const TriangleMesh mesh = plate(20, 20);
    std::vector<int> labels;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        labels.push_back((middleOf(mesh, f) - Vec3(0.5, 0.5, 0.0)).norm() < 0.3 ? 7 : 2);
    }
    const std::vector<BoundaryLine> lines = boundaryLines(mesh, labels);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(lines[0].closed);
    expectEachEdgeOnce(mesh, labels, lines);
    // Counterclockwise with the disk on the left, or the other way round.
    double area = 0.0;
    for (std::size_t i = 0; i < lines[0].vertices.size(); ++i) {
        const Vec3& a = mesh.vertices[lines[0].vertices[i]];
        const Vec3& b = mesh.vertices[lines[0].vertices[(i + 1) % lines[0].vertices.size()]];
        area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    EXPECT_EQ(lines[0].left, area > 0.0 ? 7 : 2);
    EXPECT_EQ(lines[0].right, area > 0.0 ? 2 : 7);
}

TEST(BoundaryLines, GoFromJunctionToJunction) {
    const TriangleMesh mesh = plate(20, 20);
    std::vector<int> labels;  // four quarters
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const Vec3 p = middleOf(mesh, f);
        labels.push_back((p.x() < 0.5 ? 0 : 1) + (p.y() < 0.5 ? 0 : 2));
    }
    const std::vector<BoundaryLine> lines = boundaryLines(mesh, labels);
    ASSERT_EQ(lines.size(), 4U);
    expectEachEdgeOnce(mesh, labels, lines);
    constexpr int kMiddle = 10 * 21 + 10;
    for (const BoundaryLine& line : lines) {
        EXPECT_FALSE(line.closed);
        EXPECT_EQ(line.vertices.size(), 11U);
        EXPECT_TRUE(line.vertices.front() == kMiddle || line.vertices.back() == kMiddle);
    }
}

TEST(BoundaryLines, TakeEveryEdgeOnceWhateverTheLabels) {
    const TriangleMesh mesh = torus(24, 12);
    std::vector<int> labels;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        labels.push_back(static_cast<int>(f * 7919 % 101 % 3));
    }
    expectEachEdgeOnce(mesh, labels, boundaryLines(mesh, labels));
}

TEST(BoundaryLines, OfOneLabelAreNone) {
    const TriangleMesh mesh = plate(4, 4);
    EXPECT_TRUE(boundaryLines(mesh, std::vector<int>(mesh.faces.size(), 3)).empty());
}

}  // namespace
}  // namespace bspline_curve
