// SPDX-License-Identifier: GPL-3.0-or-later
#include "tetrahedra/conforming_tetrahedra.h"

#include "shell/handmade_shell.h"
#include "support/refusal.h"
#include "support/seeds.h"
#include "surface/predicates.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

ConformingTetrahedra conform(const HandmadeShell& shell) {
    return conformToSurface(*shell.surface, *shell.extended, shell.shell(), shell.blockedFaces);
}

/// The tetrahedra at each triangle of sorted points.
std::map<Triangle, std::vector<int>> trianglesOf(const ConformingTetrahedra& made) {
    std::map<Triangle, std::vector<int>> triangles;
    for (int tet = 0; tet < static_cast<int>(made.tetrahedra.size()); ++tet) {
        for (std::size_t k = 0; k < 4; ++k) {
            Triangle face{};
            for (std::size_t j = 0; j < 3; ++j) {
                face[j] = made.tetrahedra[tet][(k + 1 + j) % 4];
            }
            std::ranges::sort(face);
            triangles[face].push_back(tet);
        }
    }
    return triangles;
}

double volumeOf(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return (b - a).cross(c - a).dot(d - a) / 6.0;
}

double volumeOf(const ConformingTetrahedra& made) {
    double volume = 0.0;
    for (const auto& [a, b, c, d] : made.tetrahedra) {
        volume += volumeOf(made.points[a], made.points[b], made.points[c], made.points[d]);
    }
    return volume;
}

double volumeOf(const Shell& shell, const ShellFrame& frame) {
    double volume = 0.0;
    for (int tet = 0; tet < shell.tetrahedronCount(); ++tet) {
        if (shell.prisms()[tet / kTetrahedraPerPrism].orientation != 0) {
            volume += std::abs(volumeOf(
                frame.toUser(shell.position(tet, 0)),
                frame.toUser(shell.position(tet, 1)),
                frame.toUser(shell.position(tet, 2)),
                frame.toUser(shell.position(tet, 3))
            ));
        }
    }
    return volume;
}

class ConformingShell : public testing::TestWithParam<NamedHandmadeShell> {};

}  // namespace

TEST_P(ConformingShell, FillsTheShellWithPositiveTetrahedra) {
    const HandmadeShell shell = GetParam().make();
    const ConformingTetrahedra made = conform(shell);
    for (const auto& [a, b, c, d] : made.tetrahedra) {
        ASSERT_GT(
            orientationSign(made.points[a], made.points[b], made.points[c], made.points[d]), 0
        );
    }
    const double expected = volumeOf(shell.shell(), shell.extended->frame);
    EXPECT_NEAR(volumeOf(made), expected, 1e-12 * expected);
    for (const auto& [triangle, tets] : trianglesOf(made)) {
        ASSERT_LE(tets.size(), 2U);
    }
}

TEST_P(ConformingShell, HasEachFaceOfTheSurfaceBetweenTheTwoSides) {
    const HandmadeShell shell = GetParam().make();
    const ConformingTetrahedra made = conform(shell);
    const auto triangles = trianglesOf(made);
    const Surface& surface = *shell.surface;
    for (int v = 0; v < surface.vertexCount(); ++v) {
        ASSERT_EQ(made.points[v], surface.vertices()[v]);
    }
    int parted = 0;
    for (int f = 0; f < surface.faceCount(); ++f) {
        if (std::ranges::binary_search(shell.blockedFaces, f)) {
            continue;
        }
        Triangle face = surface.faces()[f];
        std::ranges::sort(face);
        const auto found = triangles.find(face);
        ASSERT_NE(found, triangles.end()) << "face " << f;
        ASSERT_EQ(found->second.size(), 2U);
        EXPECT_NE(made.sides[found->second[0]], made.sides[found->second[1]]);
        ++parted;
    }
    EXPECT_GT(parted, 0);
}

TEST_P(ConformingShell, KnowsTheHeights) {
    const HandmadeShell shell = GetParam().make();
    const ConformingTetrahedra made = conform(shell);
    ASSERT_EQ(made.heights.size(), made.points.size());
    EXPECT_TRUE(std::ranges::all_of(made.heights, [](double f) { return f >= -1.0 && f <= 1.0; }));
    EXPECT_EQ(*std::ranges::max_element(made.heights), 1.0);
    EXPECT_EQ(*std::ranges::min_element(made.heights), -1.0);
    // Tetrahedra with a face on top or bottom are on that side.
    int atEnds = 0;
    for (std::size_t tet = 0; tet < made.tetrahedra.size(); ++tet) {
        for (const double end : {-1.0, 1.0}) {
            const auto count = std::ranges::count_if(made.tetrahedra[tet], [&](int point) {
                return made.heights[point] == end;
            });
            if (count >= 3) {
                EXPECT_EQ(made.sides[tet] == SurfaceSide::Above, end > 0.0) << tet;
                ++atEnds;
            }
        }
    }
    EXPECT_GT(atEnds, 0);
}

INSTANTIATE_TEST_SUITE_P(Shells, ConformingShell, testing::ValuesIn(handmadeShells()), nameOfParam);

TEST(ConformingTetrahedra, AreRefusedWhereTheSurfacePassesTheTop) {
    HandmadeShell shell = coarseSphere();
    for (Pillar& pillar : shell.pillars) {
        pillar.top = pillar.middle + 0.1 * (pillar.top - pillar.middle);
    }
    expectRefused([&] { return conform(shell); }, InputErrorCode::NoShell, "intersect");
}

TEST(ConformingTetrahedra, AreRefusedWhereTheTopIsTooNearForTetgen) {
    HandmadeShell shell = coarseSphere();
    Pillar& pillar = shell.pillars.front();
    pillar.top = pillar.middle + 1e-7 * (pillar.top - pillar.middle);
    expectRefused([&] { return conform(shell); }, InputErrorCode::NoShell, "flat");
}

}  // namespace bspline_curve
