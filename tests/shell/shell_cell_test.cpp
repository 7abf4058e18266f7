// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell_cell.h"

#include "built_shell.h"
#include "support/meshes.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bspline_curve {
namespace {

using namespace test_support;

class ShellCellMaps : public testing::Test {
protected:
    BuiltShell built_{withNoise(icosphere(2), 0.05, 13)};
    const Shell& shell_ = built_.shell();
};

// In the corners and between them.
TEST_F(ShellCellMaps, InterpolateBetweenTheCorners) {
    Random random(14);
    for (int i = 0; i < 5 * shell_.tetrahedronCount(); ++i) {
        const int tet = i / 5;
        const ShellCell cell(shell_, tet);
        Eigen::Vector4d weights = Eigen::Vector4d::Zero();
        for (int k = 0; k < 4; ++k) {
            weights[k] = i % 5 == 4 ? random.uniform(0.0, 1.0) : (i % 5 == k ? 1.0 : 0.0);
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
        for (int k = 0; k < 4; ++k) {
            EXPECT_NEAR(cell.walls[k].at(p), weights[k], 1e-12);
        }
    }
}

TEST_F(ShellCellMaps, HaveTheGradientsOfTheirDifferences) {
    Random random(15);
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
