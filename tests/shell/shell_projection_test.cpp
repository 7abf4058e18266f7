// SPDX-License-Identifier: GPL-3.0-or-later
#include "built_shell.h"
#include "shell/polynomial_trace.h"
#include "support/many_cases.h"
#include "support/meshes.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr int kPointsPerMesh = caseCount(100000, 4000);

// 1e-11, or the rounding of the affine maps where cells are thinner than 1e-4 of the diagonal.
double roundingOf(const Shell& shell) {
    double largest = 0.0;
    for (int tet = 0; tet < shell.tetrahedronCount(); ++tet) {
        if (shell.prisms()[tet / kTetrahedraPerPrism].orientation != 0) {
            const ShellCell cell(shell, tet);
            for (int k = 0; k < cell.wallCount; ++k) {
                largest = std::max(largest, cell.walls[k].gradient.norm());
            }
        }
    }
    return std::max(1e-11, 0x1p-51 * largest);
}

// Walks along straight lines from a point of the surface through points of the shell. Returns
// whether all of them lie inside; the state holds the last one then.
bool walk(
    const Shell& shell,
    const SurfacePoint& start,
    const std::vector<Vec3>& points,
    TraceState& state
) {
    state.cell = ShellCell(shell, shell.locate(start));
    Vec3 from = shell.lift(start, 0.0);
    for (const Vec3& to : points) {
        const PolynomialCurve line{.degree = 1, .coefficients = {from, to - from}};
        const auto ignore = [](const auto&...) {};
        if (!tracePolynomial(shell, line, 1.0, state, ignore, ignore)) {
            return false;
        }
        from = to;
    }
    return true;
}

// The points where the fibre turns on its way from the surface to height w: the outer weight of
// one slot after the other is used up.
std::vector<Vec3> fibrePoints(const Shell& shell, const SurfacePoint& point, double w) {
    const Prism& prism = shell.prisms()[point.face];
    std::vector<Vec3> points;
    double height = 0.0;
    for (const int slot : {2, 1, 0}) {
        height += point.barycentric[prism.faceCorner[slot]];
        if (height >= std::abs(w)) {
            break;
        }
        points.push_back(shell.lift(point, std::copysign(height, w)));
    }
    points.push_back(shell.lift(point, w));
    return points;
}

class ShellProjection : public testing::TestWithParam<NamedMesh> {};

// project(lift(x, w)) = (x, w), by a straight walk where it stays inside, else along the fibre.
TEST_P(ShellProjection, UndoesLifting) {
    constexpr std::uint64_t kSeed = 11;
    SCOPED_TRACE("seed " + std::to_string(kSeed));
    Random random(kSeed);
    const BuiltShell built(GetParam().mesh);
    const Shell& shell = built.shell();
    int straight = 0;
    double worstShadow = 0.0;
    double worstHeight = 0.0;
    for (int i = 0; i < kPointsPerMesh; ++i) {
        const SurfacePoint point{
            random.integer(0, built.surface.faceCount() - 1), random.barycentric()
        };
        const double w = random.uniform(-1.0, 1.0);
        const Vec3 lifted = shell.lift(point, w);
        TraceState state;
        if (walk(shell, point, {lifted}, state)) {
            ++straight;
        } else {
            ASSERT_TRUE(walk(shell, point, fibrePoints(shell, point, w), state)) << "point " << i;
        }
        ASSERT_EQ(state.cell.prism, point.face) << "point " << i;
        ASSERT_GE(state.cell.insideness(lifted), -2.0 * kCellTolerance);
        worstShadow = std::max(
            worstShadow, (state.cell.shadow(lifted) - point.barycentric).cwiseAbs().maxCoeff()
        );
        worstHeight = std::max(worstHeight, std::abs(state.cell.height.at(lifted) - w));
    }
    EXPECT_LT(worstShadow, roundingOf(shell));
    EXPECT_LT(worstHeight, roundingOf(shell));
    EXPECT_GT(straight, kPointsPerMesh / 2);
}

// Wherever two tetrahedra meet, their maps agree: height, and shadow as a point of the surface.
TEST_P(ShellProjection, AgreesAcrossEveryFace) {
    constexpr std::uint64_t kSeed = 12;
    SCOPED_TRACE("seed " + std::to_string(kSeed));
    Random random(kSeed);
    const BuiltShell built(GetParam().mesh);
    const Shell& shell = built.shell();
    double worstHeight = 0.0;
    double worstShadow = 0.0;
    for (int tet = 0; tet < shell.tetrahedronCount(); ++tet) {
        if (shell.prisms()[tet / kTetrahedraPerPrism].orientation == 0) {
            continue;
        }
        const ShellCell here(shell, tet);
        for (int k = 0; k < 4; ++k) {
            const int across = shell.neighbour(tet, k);
            if (across < 0) {
                continue;
            }
            const ShellCell there(shell, across);
            Vec3 p = Vec3::Zero();
            const Vec3 weights = random.barycentric();
            for (int j = 0; j < 3; ++j) {
                p += weights[j] * shell.position(tet, (k + 1 + j) % 4);
            }
            worstHeight = std::max(worstHeight, std::abs(here.height.at(p) - there.height.at(p)));
            const Vec3 shadowHere = built.extended.position({here.face, here.shadow(p)});
            const Vec3 shadowThere = built.extended.position({there.face, there.shadow(p)});
            worstShadow = std::max(worstShadow, (shadowHere - shadowThere).norm());
        }
    }
    EXPECT_LT(worstHeight, roundingOf(shell));
    EXPECT_LT(worstShadow, roundingOf(shell));
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, ShellProjection, testing::ValuesIn(shellMeshes()), [](const auto& instance) {
        return instance.param.name;
    }
);

// ---- One cell ----

class ShellCellMaps : public testing::Test {
protected:
    BuiltShell built_{withNoise(icosphere(2), 0.05, 13)};
    const Shell& shell_ = built_.shell();
};

TEST_F(ShellCellMaps, AreThoseOfTheCorners) {
    for (int tet = 0; tet < shell_.tetrahedronCount(); ++tet) {
        const ShellCell cell(shell_, tet);
        const Prism& prism = shell_.prisms()[cell.prism];
        const int inPrism = tet % kTetrahedraPerPrism;
        for (int k = 0; k < 4; ++k) {
            const Vec3 corner = shell_.position(tet, k);
            const SplitVertex split = kSlabSplit[inPrism % 3][k];
            const double height = split.outer ? (inPrism < 3 ? 1.0 : -1.0) : 0.0;
            EXPECT_NEAR(cell.height.at(corner), height, 1e-12);
            EXPECT_NEAR(cell.shadow(corner)[prism.faceCorner[split.slot]], 1.0, 1e-12);
            EXPECT_NEAR(cell.shadow(corner).cwiseAbs().sum(), 1.0, 1e-11);
            EXPECT_NEAR(cell.insideness(corner), 0.0, 1e-12);
            EXPECT_NEAR(cell.walls[k].at(corner), 1.0, 1e-12);
        }
    }
}

TEST_F(ShellCellMaps, InterpolateBetweenTheCorners) {
    constexpr std::uint64_t kSeed = 14;
    SCOPED_TRACE("seed " + std::to_string(kSeed));
    Random random(kSeed);
    for (int i = 0; i < 2000; ++i) {
        const int tet = random.integer(0, shell_.tetrahedronCount() - 1);
        const ShellCell cell(shell_, tet);
        Eigen::Vector4d weights;
        for (double& weight : weights) {
            weight = random.uniform(0.0, 1.0);
        }
        weights /= weights.sum();
        Vec3 p = Vec3::Zero();
        double height = 0.0;
        Vec3 shadow = Vec3::Zero();
        for (int k = 0; k < 4; ++k) {
            const SplitVertex split = kSlabSplit[tet % 3][k];
            p += weights[k] * shell_.position(tet, k);
            height += split.outer ? weights[k] * (tet % kTetrahedraPerPrism < 3 ? 1.0 : -1.0) : 0.0;
            shadow[shell_.prisms()[cell.prism].faceCorner[split.slot]] += weights[k];
        }
        EXPECT_NEAR(cell.height.at(p), height, 1e-12);
        EXPECT_LT((cell.shadow(p) - shadow).norm(), 1e-12);
        EXPECT_NEAR(cell.insideness(p), weights.minCoeff(), 1e-12);
    }
}

TEST_F(ShellCellMaps, HaveTheGradientsOfTheirDifferences) {
    constexpr std::uint64_t kSeed = 15;
    SCOPED_TRACE("seed " + std::to_string(kSeed));
    Random random(kSeed);
    const double step = 1e-3;
    for (int i = 0; i < 500; ++i) {
        const ShellCell cell(shell_, random.integer(0, shell_.tetrahedronCount() - 1));
        const Vec3 p = random.point(-0.5, 0.5);
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 offset = step * Vec3::Unit(axis);
            const double scale = cell.height.gradient.norm() + cell.walls[0].gradient.norm();
            EXPECT_NEAR(
                (cell.height.at(p + offset) - cell.height.at(p - offset)) / (2.0 * step),
                cell.height.gradient[axis],
                1e-11 * scale
            );
            const Vec3 change = (cell.shadow(p + offset) - cell.shadow(p - offset)) / (2.0 * step);
            for (int corner = 0; corner < 3; ++corner) {
                EXPECT_NEAR(change[corner], cell.shadowForm(corner).gradient[axis], 1e-11 * scale);
            }
        }
    }
}

// Along a fibre the shadow stays and the height grows: their gradients know it.
TEST_F(ShellCellMaps, KeepTheShadowAlongTheFibre) {
    for (int tet = 0; tet < shell_.tetrahedronCount(); ++tet) {
        const ShellCell cell(shell_, tet);
        for (int k = 0; k < 4; ++k) {
            for (int j = 0; j < 4; ++j) {
                const SplitVertex lower = kSlabSplit[tet % 3][k];
                const SplitVertex upper = kSlabSplit[tet % 3][j];
                if (lower.slot != upper.slot || lower.outer || !upper.outer) {
                    continue;
                }
                const Vec3 fibre = shell_.position(tet, j) - shell_.position(tet, k);
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    EXPECT_NEAR(cell.shadowForm(corner).gradient.dot(fibre), 0.0, 1e-12);
                }
                EXPECT_NEAR(std::abs(cell.height.gradient.dot(fibre)), 1.0, 1e-12);
            }
        }
    }
}

TEST_F(ShellCellMaps, BlendFibresBetweenThePillars) {
    for (int i = 0; i < static_cast<int>(shell_.prisms().size()); ++i) {
        const Prism& prism = shell_.prisms()[i];
        Vec3 sum = Vec3::Zero();
        for (std::size_t slot = 0; slot < 3; ++slot) {
            const Pillar& pillar = shell_.pillars()[prism.pillars[slot]];
            const Vec3 fibre = pillar.top - pillar.bottom;
            sum += fibre;
            const SurfacePoint vertex{i, Vec3::Unit(prism.faceCorner[slot])};
            EXPECT_EQ(directionAt(shell_, built_.extended, vertex), fibre.normalized());
        }
        const Vec3 middle = directionAt(shell_, built_.extended, {i, Vec3::Constant(1.0 / 3.0)});
        EXPECT_LT((middle - sum.normalized()).norm(), 1e-15);
    }
}

TEST(ShellLift, FollowsThePillarsAtTheVertices) {
    const BuiltShell built(torus(16, 8));
    for (int f = 0; f < built.surface.faceCount(); ++f) {
        for (int corner = 0; corner < 3; ++corner) {
            const Pillar& pillar = built.shell().pillars()[built.surface.faces()[f][corner]];
            const SurfacePoint vertex{f, Vec3::Unit(corner)};
            EXPECT_EQ(built.shell().lift(vertex, 0.0), pillar.middle);
            EXPECT_EQ(built.shell().lift(vertex, 1.0), pillar.top);
            EXPECT_EQ(built.shell().lift(vertex, -1.0), pillar.bottom);
        }
    }
}

}  // namespace
}  // namespace bspline_curve
