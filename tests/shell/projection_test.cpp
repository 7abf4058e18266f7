// SPDX-License-Identifier: GPL-3.0-or-later
// The projection of every kind of shell is exact and total: it undoes lifting, lifting undoes it,
// neighbours agree, also in and next to edges, vertices, walls and pillars.
#include "built_shell.h"
#include "random_mesh.h"
#include "shell/polynomial_trace.h"
#include "support/coarse_shell.h"
#include "support/many_cases.h"
#include "support/seeds.h"
#include "traces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

struct TestedShell {
    std::shared_ptr<const ExtendedSurface> extended;
    Shell shell;
};

struct ProjectionCase {
    std::string name;
    std::function<TestedShell()> make;
    double tolerance, walkTolerance;  ///< 0: from the shell, see roundingOf()
    int points, walks, pointsPerPrism;
};

std::ostream& operator<<(std::ostream& stream, const ProjectionCase& named) {
    return stream << named.name;
}

// 1e-12, or the rounding of the affine maps where cells are thinner than 1e-3 of the diagonal.
double roundingOf(const Shell& shell) {
    double largest = 0.0;
    std::array<AffineForm, 4> forms;
    for (int tet = 0; tet < shell.tetrahedronCount(); ++tet) {
        if (shell.prisms()[tet / kTetrahedraPerPrism].orientation != 0) {
            shell.barycentrics(tet, forms.data());
            for (const AffineForm& form : forms) {
                largest = std::max(largest, form.gradient.norm());
            }
        }
    }
    return std::max(1e-12, 0x1p-51 * largest);
}

// Largest differences of projections and heights, and how many points of those tried were compared.
struct Agreement {
    double worstShadow = 0.0, worstHeight = 0.0;
    int tried = 0, compared = 0;

    void add(double shadow, double height) {
        worstShadow = std::max(worstShadow, shadow);
        worstHeight = std::max(worstHeight, std::abs(height));
        ++compared;
    }

    void expectBelow(double shadowTolerance, double heightTolerance) const {
        EXPECT_LT(worstShadow, shadowTolerance);
        EXPECT_LT(worstHeight, heightTolerance);
        EXPECT_GT(compared, 0);
    }
};

class Projection : public testing::TestWithParam<ProjectionCase> {
protected:
    struct Lifted {
        SurfacePoint point;
        double height;
    };

    [[nodiscard]] Lifted randomLifted() {
        const int face = random_.integer(0, extended_.surfaceFaceCount - 1);
        if (shell_.isFullResolution()) {
            // Thin cells: walks next to their edges end in any of the cells there.
            const Vec3 inside = random_.barycentric();
            return {{face, inside}, random_.uniform(-1.0, 1.0)};
        }
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
        std::array<AffineForm, 4> forms;
        for (int i = 0; i < kTetrahedraPerPrism; ++i) {
            const int tet = kTetrahedraPerPrism * prism + i;
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

    /// The point of the surface, and the height over it.
    struct Projected {
        Vec3 foot;
        double height;
    };

    [[nodiscard]] Projected projected(const ShellCell& cell, const Vec3& p) const {
        const auto [shadow, height] = cell.project(shell_, p);
        return {extended_.position({cell.face, shadow}), height};
    }

    /// Compares a cell with the point of the surface, and the height over it, that p was lifted to.
    void compareWithLifted(
        const ShellCell& cell, const Vec3& p, const Lifted& lifted, Agreement& agreement
    ) const {
        if (shell_.isFullResolution()) {
            ASSERT_EQ(cell.face, lifted.point.face);
        }
        const auto [foot, height] = projected(cell, p);
        agreement.add((foot - extended_.position(lifted.point)).norm(), height - lifted.height);
    }

    /// Beyond the rim of a surface there are points without projection, and nowhere else.
    void expectMost(const Agreement& agreement) const {
        EXPECT_GT(agreement.compared, agreement.tried / 2);
        if (extended_.ghostSource.empty()) {
            EXPECT_EQ(agreement.compared, agreement.tried);
        }
    }

    void expectLiftingUndone() {
        Agreement agreement;
        for (int i = 0; i < GetParam().points; ++i) {
            const Lifted lifted = randomLifted();
            const Vec3 p = shell_.lift(lifted.point, lifted.height);
            const int prism = shell_.locate(lifted.point) / kTetrahedraPerPrism;
            const auto cell = ShellCell::find(shell_, deepestTet(prism, p), p);
            if (!cell) {
                FAIL() << "no cell for point " << i;
            }
            compareWithLifted(*cell, p, lifted, agreement);
        }
        agreement.expectBelow(tolerance_, heightTolerance_);
    }

    void expectUndoneByLifting() {
        Agreement agreement;
        for (int tet = 0; tet < shell_.tetrahedronCount(); ++tet) {
            const bool isBlocked = shell_.prisms()[tet / kTetrahedraPerPrism].orientation == 0;
            const int count = isBlocked ? 0 : GetParam().pointsPerPrism / kTetrahedraPerPrism;
            for (int i = 0; i < count; ++i) {
                ++agreement.tried;
                const Vec3 p = awkwardPoint(tet);
                const auto cell = ShellCell::find(shell_, tet, p);
                if (cell && cell->insideness(p) >= -wallTolerance_) {
                    const auto [shadow, height] = cell->project(shell_, p);
                    const Vec3 lifted = shell_.lift({cell->face, shadow}, height);
                    agreement.add((lifted - p).norm(), 0.0);
                }
            }
        }
        agreement.expectBelow(tolerance_, heightTolerance_);
        expectMost(agreement);
    }

    const TestedShell tested_ = GetParam().make();
    const Shell& shell_ = tested_.shell;
    const ExtendedSurface& extended_ = *tested_.extended;
    const double rounding_ = roundingOf(shell_);
    const double tolerance_ = GetParam().tolerance > 0.0 ? GetParam().tolerance : rounding_;
    const double heightTolerance_ = std::max(tolerance_, rounding_);
    const double wallTolerance_ = std::max(1e-11, rounding_);  // stretched cells lose a digit
    const double walkTolerance_ = GetParam().walkTolerance > 0.0 ? GetParam().walkTolerance
                                                                 : rounding_;
    Random random_{11};
};

TEST_P(Projection, UndoesLifting) {
    expectLiftingUndone();
}

TEST_P(Projection, IsUndoneByLifting) {
    expectUndoneByLifting();
}

TEST_P(Projection, AgreesAcrossTheSidesOfEveryTetrahedron) {
    Agreement agreement;
    for (int tet = 0; tet < shell_.tetrahedronCount(); ++tet) {
        for (int k = 0; k < 4; ++k) {
            const int across = shell_.neighbour(tet, k);
            const int count = GetParam().pointsPerPrism / (4 * kTetrahedraPerPrism);
            for (int i = 0; across > tet && i < count; ++i) {
                ++agreement.tried;
                const Vec3 weights = random_.awkwardBarycentric();
                Vec3 p = Vec3::Zero();
                for (int j = 0; j < 3; ++j) {
                    p += weights[j] * shell_.position(tet, (k + 1 + j) % 4);
                }
                const auto here = ShellCell::find(shell_, tet, p);
                const auto there = ShellCell::find(shell_, across, p);
                if (here && there &&
                    std::min(here->insideness(p), there->insideness(p)) >= -wallTolerance_) {
                    const Projected first = projected(*here, p);
                    const Projected second = projected(*there, p);
                    agreement.add((first.foot - second.foot).norm(), first.height - second.height);
                }
            }
        }
    }
    agreement.expectBelow(tolerance_, heightTolerance_);
    expectMost(agreement);
}

// A walk may end in the cell before a wall that is nearer than its tolerance.
TEST_P(Projection, LetsWalksReachWhatIsLifted) {
    Agreement agreement;
    int straight = 0;
    for (int i = 0; i < GetParam().walks; ++i) {
        const Lifted lifted = randomLifted();
        const Vec3 p = shell_.lift(lifted.point, lifted.height);
        TraceState state{ShellCell(shell_, lifted.point)};
        if (walkStraight(shell_, extended_.position(lifted.point), p, state)) {
            ++straight;
        } else {
            ASSERT_TRUE(walkUp(shell_, extended_, lifted.point, lifted.height, state))
                << "point " << i;
        }
        ASSERT_GE(state.cell.insideness(p), -2.0 * kCellTolerance);
        compareWithLifted(state.cell, p, lifted, agreement);
    }
    agreement.expectBelow(walkTolerance_, walkTolerance_);
    EXPECT_GT(straight, GetParam().walks / 2);
}

// Short middle edges leave few faces to each prism, which all have to be searched.
ProjectionCase simplifiedCase(RandomKind kind, std::uint64_t seed, double tolerance) {
    const auto make = [kind, seed] {
        const SimplifiedShell built(
            randomMesh(kind, seed), {.targetThickness = 0.1, .targetEdgeLength = 0.1}
        );
        return TestedShell{built.sharedExtended, built.shell()};
    };
    return {
        "Simplified" + nameOf(kind),
        make,
        tolerance,
        kCellTolerance,
        caseCount(1000000, 5000),
        caseCount(100000, 2000),
        caseCount(500, 48)
    };
}

// Every form of shells. In simplified ones tetrahedra along creases are so thin that rounding costs
// a digit more there; over creases the maps of the cell before a wall say something else within its
// tolerance.
std::vector<ProjectionCase> projectionCases() {
    std::vector<ProjectionCase> cases;
    for (const NamedMesh& named : shellMeshes()) {
        const auto make = [mesh = named.mesh] {
            const BuiltShell built(mesh);
            return TestedShell{built.sharedExtended, built.shell()};
        };
        cases.push_back({named.name, make, 0.0, 0.0, 1000, caseCount(100000, 4000), 24});
    }
    for (const CoarseShellCase& named : coarseShellCases()) {
        const auto make = [named] {
            const CoarseShell coarse(named.fine, named.coarse, named.height);
            return TestedShell{coarse.extended, coarse.shell};
        };
        const double walkTolerance = named.name == "Box" ? kCellTolerance : 3e-12;
        cases.push_back({"Coarse" + named.name, make, 1e-12, walkTolerance, 1000, 20000, 24});
    }
    cases.push_back(simplifiedCase(RandomKind::NoisySphere, 1, 1e-12));
    cases.push_back(simplifiedCase(RandomKind::NoisyTorus, 2, 1e-12));
    cases.push_back(simplifiedCase(RandomKind::BumpyPlate, 3, 1e-12));
    cases.push_back(simplifiedCase(RandomKind::Block, 4, 1e-12));
    return cases;
}

INSTANTIATE_TEST_SUITE_P(Shells, Projection, testing::ValuesIn(projectionCases()), nameOfParam);

// At corners of blocks fibres see some faces nearly edge-on; by those, 1.7e-9 of the diagonal would
// be lost.
class ProjectionOfBlocks : public Projection {};

TEST_P(ProjectionOfBlocks, UndoesLifting) {
    expectLiftingUndone();
}

TEST_P(ProjectionOfBlocks, IsUndoneByLifting) {
    expectUndoneByLifting();
}

std::vector<ProjectionCase> blockCases() {
    std::vector<ProjectionCase> cases;
    for (const std::uint64_t seed : {8, 9, 11, 23, 26}) {
        cases.push_back(simplifiedCase(RandomKind::Block, seed, 1e-12));
        cases.back().name += std::to_string(seed);
    }
    return cases;
}

INSTANTIATE_TEST_SUITE_P(Shells, ProjectionOfBlocks, testing::ValuesIn(blockCases()), nameOfParam);

// By their forms up to 2e-12 would be lost, although points say where they came from. On the
// surface they do not: there, rounding moves what is lifted again.
class ProjectionOfStretchedTetrahedra : public Projection {};

TEST_P(ProjectionOfStretchedTetrahedra, UndoesLifting) {
    expectLiftingUndone();
}

INSTANTIATE_TEST_SUITE_P(
    Shells,
    ProjectionOfStretchedTetrahedra,
    testing::Values(simplifiedCase(RandomKind::Block, 5, 1e-12)),
    nameOfParam
);

// In tetrahedra of a small component that are thinner than 1e-6 of the diagonal, neighbours may
// each round a point into the other.
TEST(WalksInThinTetrahedra, ReachWhatIsLifted) {
    const SimplifiedShell simplified(
        randomMesh(RandomKind::SeveralPieces, 5), {.targetThickness = 0.1, .targetEdgeLength = 0.1}
    );
    Random random(5);
    for (int i = 0; i < caseCount(100000, 2000); ++i) {
        const int face = random.integer(0, simplified.surface.faceCount() - 1);
        const SurfacePoint point{face, random.awkwardBarycentric()};
        TraceState state;
        ASSERT_TRUE(
            walkUp(simplified.shell(), simplified.extended, point, random.uniform(-1.0, 1.0), state)
        ) << "point "
          << i;
    }
}

}  // namespace
}  // namespace bspline_curve
