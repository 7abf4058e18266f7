// SPDX-License-Identifier: GPL-3.0-or-later
// The projection of shells that the simplifier made is exact and total: it undoes lifting, lifting
// undoes it, neighbours agree, also in and next to edges, vertices, walls and pillars.
#include "built_shell.h"
#include "lifted_walk.h"
#include "random_mesh.h"
#include "shell/polynomial_trace.h"
#include "shell/shell_cell.h"
#include "support/many_cases.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr int kPointsPerMesh = caseCount(1000000, 5000);
constexpr int kWalksPerMesh = caseCount(100000, 2000);
constexpr int kPointsPerPrism = caseCount(500, 48);

// The diagonal of the surface is 1. Tetrahedra along creases are so thin that rounding costs a
// digit more there.
constexpr double kTolerance = 1e-12;
constexpr double kCreaseTolerance = 1e-11;

struct ProjectionCase {
    RandomKind kind;
    std::uint64_t seed;
    double tolerance;
};

// How well the cells on both sides of walls agree.
struct Agreement {
    double worstShadow = 0.0, worstHeight = 0.0;
    int tried = 0, compared = 0;
};

class SimplifiedProjection : public testing::TestWithParam<ProjectionCase> {
protected:
    // Short middle edges leave few faces to each prism, which all have to be searched.
    SimplifiedProjection()
        : simplified_(
              randomMesh(GetParam().kind, GetParam().seed),
              {.targetThickness = 0.1, .targetEdgeLength = 0.1}
          ),
          shell_(simplified_.shell()),
          extended_(*simplified_.extended),
          random_(GetParam().seed) {}

    struct Lifted {
        SurfacePoint point;
        double height;
    };

    [[nodiscard]] Lifted randomLifted() {
        const int face = random_.integer(0, simplified_.surface.faceCount() - 1);
        const Vec3 barycentric = random_.awkwardBarycentric();
        return {{face, barycentric}, awkwardHeight()};
    }

    [[nodiscard]] double awkwardHeight() {
        const int side = 2 * random_.integer(0, 1) - 1;
        switch (random_.integer(0, 9)) {
            case 0:
                return 0.0;
            case 1:
                return side * 1e-11;
            case 2:
                return side;
            default:
                return random_.uniform(-1.0, 1.0);
        }
    }

    /// A point inside of a tetrahedron, or in or next to its sides, edges and corners: the walls of
    /// the prism, its middle, its pillars.
    [[nodiscard]] Vec3 awkwardPoint(int tet) {
        const Vec3 first = random_.awkwardBarycentric();
        const Vec3 second = random_.awkwardBarycentric();
        const std::array<double, 4> weights = {
            first[0], first[1] + first[2] * second[0], first[2] * second[1], first[2] * second[2]
        };
        const int start = random_.integer(0, 3);
        Vec3 p = Vec3::Zero();
        for (int k = 0; k < 4; ++k) {
            p += weights[k] * shell_.position(tet, (start + k) % 4);
        }
        return p;
    }

    /// The tetrahedron of a prism in which a point lies deepest.
    [[nodiscard]] int deepestTet(int prism, const Vec3& p) const {
        int deepest = -1;
        double depth = -std::numeric_limits<double>::infinity();
        for (int i = 0; i < kTetrahedraPerPrism; ++i) {
            const int tet = kTetrahedraPerPrism * prism + i;
            std::array<AffineForm, 4> forms;
            shell_.barycentrics(tet, forms.data());
            const double here =
                std::min({forms[0].at(p), forms[1].at(p), forms[2].at(p), forms[3].at(p)});
            if (here > depth) {
                deepest = tet;
                depth = here;
            }
        }
        return deepest;
    }

    [[nodiscard]] Vec3 shadowOf(const ShellCell& cell, const Vec3& p) const {
        return extended_.position({cell.face, cell.shadow(p)});
    }

    /// Compares cells in points of the side of a tetrahedron opposite to vertex k.
    void compareAcross(int tet, int k, Agreement& agreement) {
        const int across = shell_.neighbour(tet, k);
        for (int i = 0; i < kPointsPerPrism / (4 * kTetrahedraPerPrism); ++i) {
            ++agreement.tried;
            const Vec3 weights = random_.awkwardBarycentric();
            Vec3 p = Vec3::Zero();
            for (int j = 0; j < 3; ++j) {
                p += weights[j] * shell_.position(tet, (k + 1 + j) % 4);
            }
            const auto here = ShellCell::find(shell_, tet, p);
            const auto there = ShellCell::find(shell_, across, p);
            if (!here || !there ||
                std::min(here->insideness(p), there->insideness(p)) < -GetParam().tolerance) {
                continue;
            }
            ++agreement.compared;
            agreement.worstShadow =
                std::max(agreement.worstShadow, (shadowOf(*here, p) - shadowOf(*there, p)).norm());
            agreement.worstHeight =
                std::max(agreement.worstHeight, std::abs(here->height.at(p) - there->height.at(p)));
        }
    }

    /// Beyond the rim of a surface there are points without shadow, and nowhere else.
    void expectMost(int compared, int tried) const {
        if (extended_.ghostOrigin.empty()) {
            EXPECT_EQ(compared, tried);
        } else {
            EXPECT_GT(compared, tried / 2);
        }
    }

    SimplifiedShell simplified_;
    const Shell& shell_;
    const ExtendedSurface& extended_;
    Random random_;
};

TEST_P(SimplifiedProjection, UndoesLifting) {
    double worstShadow = 0.0;
    double worstHeight = 0.0;
    for (int i = 0; i < kPointsPerMesh; ++i) {
        const auto [point, height] = randomLifted();
        const Vec3 p = shell_.lift(point, height);
        const int prism = shell_.locate(point) / kTetrahedraPerPrism;
        const auto cell = ShellCell::find(shell_, deepestTet(prism, p), p);
        if (!cell) {
            FAIL() << "no cell for point " << i;
        }
        worstShadow =
            std::max(worstShadow, (shadowOf(*cell, p) - extended_.position(point)).norm());
        worstHeight = std::max(worstHeight, std::abs(cell->height.at(p) - height));
    }
    EXPECT_LT(worstShadow, GetParam().tolerance);
    EXPECT_LT(worstHeight, GetParam().tolerance);
}

TEST_P(SimplifiedProjection, IsUndoneByLifting) {
    double worst = 0.0;
    int compared = 0;
    int tried = 0;
    for (int tet = 0; tet < shell_.tetrahedronCount(); ++tet) {
        for (int i = 0; i < kPointsPerPrism / kTetrahedraPerPrism; ++i) {
            ++tried;
            const Vec3 p = awkwardPoint(tet);
            const auto cell = ShellCell::find(shell_, tet, p);
            if (!cell || cell->insideness(p) < -GetParam().tolerance) {
                continue;
            }
            ++compared;
            const Vec3 lifted = shell_.lift({cell->face, cell->shadow(p)}, cell->height.at(p));
            worst = std::max(worst, (lifted - p).norm());
        }
    }
    EXPECT_LT(worst, GetParam().tolerance);
    expectMost(compared, tried);
}

TEST_P(SimplifiedProjection, AgreesAcrossTheSidesOfEveryTetrahedron) {
    Agreement agreement;
    for (int tet = 0; tet < shell_.tetrahedronCount(); ++tet) {
        for (int k = 0; k < 4; ++k) {
            if (shell_.neighbour(tet, k) > tet) {
                compareAcross(tet, k, agreement);
            }
        }
    }
    EXPECT_LT(agreement.worstShadow, GetParam().tolerance);
    EXPECT_LT(agreement.worstHeight, GetParam().tolerance);
    expectMost(agreement.compared, agreement.tried);
}

// A walk may end in the cell before a wall that is nearer than its tolerance.
TEST_P(SimplifiedProjection, LetsWalksReachWhatIsLifted) {
    double worstShadow = 0.0;
    double worstHeight = 0.0;
    for (int i = 0; i < kWalksPerMesh; ++i) {
        const auto [point, height] = randomLifted();
        TraceState state;
        ASSERT_TRUE(walkUp(shell_, extended_, point, height, state)) << "point " << i;
        const Vec3 p = shell_.lift(point, height);
        EXPECT_GE(state.cell.insideness(p), -2.0 * kCellTolerance);
        worstShadow =
            std::max(worstShadow, (shadowOf(state.cell, p) - extended_.position(point)).norm());
        worstHeight = std::max(worstHeight, std::abs(state.cell.height.at(p) - height));
    }
    EXPECT_LT(worstShadow, kCellTolerance);
    EXPECT_LT(worstHeight, kCellTolerance);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds,
    SimplifiedProjection,
    testing::Values(
        ProjectionCase{RandomKind::NoisySphere, 1, kTolerance},
        ProjectionCase{RandomKind::NoisyTorus, 2, kTolerance},
        ProjectionCase{RandomKind::BumpyPlate, 3, kTolerance},
        ProjectionCase{RandomKind::Block, 4, kCreaseTolerance}
    ),
    [](const auto& instance) { return nameOf(instance.param.kind); }
);

// In tetrahedra of a small component that are thinner than 1e-6 of the diagonal, neighbours may
// each round a point into the other.
TEST(WalksInThinTetrahedra, ReachWhatIsLifted) {
    const SimplifiedShell simplified(
        randomMesh(RandomKind::SeveralPieces, 5), {.targetThickness = 0.1, .targetEdgeLength = 0.1}
    );
    Random random(5);
    for (int i = 0; i < kWalksPerMesh; ++i) {
        const int face = random.integer(0, simplified.surface.faceCount() - 1);
        const Vec3 barycentric = random.awkwardBarycentric();
        const double height = random.uniform(-1.0, 1.0);
        TraceState state;
        ASSERT_TRUE(
            walkUp(simplified.shell(), *simplified.extended, {face, barycentric}, height, state)
        ) << "point "
          << i;
    }
}

}  // namespace
}  // namespace bspline_curve
