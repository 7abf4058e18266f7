// SPDX-License-Identifier: GPL-3.0-or-later
// Thin prisms near a curve: upright, connected, and named as in the whole surface.
#include "shell/near_shell.h"

#include "shell/polynomial_trace.h"
#include "shell/shell_builder.h"
#include "support/meshes.h"
#include "surface/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

const Vec3 kCentroid = Vec3::Constant(1.0 / 3.0);

// A surface in its shell, and the faces that a straight line between two points of it passes.
class Line {
public:
    Line(TriangleMesh mesh, const SurfacePoint& from, const SurfacePoint& to)
        : surface(std::move(mesh)), base(makeShellBase(surface, 3)) {
        const Shell shell = buildShell(base, {}).shell;
        PolynomialCurve line{.degree = 1, .coefficients = {}};
        line.coefficients[0] = base.position(from);
        line.coefficients[1] = base.position(to) - base.position(from);
        TraceState state{ShellCell(shell, from)};
        EXPECT_TRUE(tracePolynomial(
            shell,
            line,
            1.0,
            state,
            [&](const ShellCell& cell, double, double) { passed.push_back(cell.face); },
            [](const ShellCell&, const ShellCell&, double, int) {}
        ));
    }

    [[nodiscard]] NearShell near(double least) const {
        return {surface, base, passed, {.least = least}};
    }

    Surface surface;
    ShellBase base;
    std::vector<int> passed;
};

// Across the middle of a plate of 10 x 10 cells, and along its lower edge.
Line acrossPlate() {
    return {plate(10, 10), {2 * 48, kCentroid}, {2 * 52, kCentroid}};
}

Line alongBoundary() {
    return {plate(10, 10), {2 * 3, kCentroid}, {2 * 5, kCentroid}};
}

double lengthOf(const Pillar& pillar) {
    return (pillar.top - pillar.bottom).norm();
}

bool isUpright(const Shell& shell, int prism) {
    for (int tet = prism * kTetrahedraPerPrism; tet < (prism + 1) * kTetrahedraPerPrism; ++tet) {
        const int side = tet % kTetrahedraPerPrism < 3 ? 1 : -1;
        const int sign = orientationSign(
            shell.position(tet, 0),
            shell.position(tet, 1),
            shell.position(tet, 2),
            shell.position(tet, 3)
        );
        if (sign != side * shell.prisms()[at(prism)].orientation) {
            return false;
        }
    }
    return true;
}

// The same corners and neighbours as the face of the whole base that it is called.
void expectSameFace(const NearShell& near, const ShellBase& whole, int here) {
    const int name = near.faces[at(here)];
    EXPECT_EQ(near.indexOf(name), here);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(
            near.base.vertices[at(near.base.faces[at(here)][k])],
            whole.vertices[at(whole.faces[at(name)][k])]
        );
        EXPECT_EQ(
            near.base.faceNeighbours[at(here)][k], near.indexOf(whole.faceNeighbours[at(name)][k])
        );
    }
}

TEST(NearShell, KnowsTheFacesOfTheWholeByName) {
    const Line line = acrossPlate();
    const NearShell near = line.near(1e-3);
    const int count = static_cast<int>(line.base.faces.size());
    ASSERT_EQ(near.faces.size(), near.base.faces.size());
    EXPECT_LT(near.faces.size(), line.base.faces.size());
    for (int here = 0; here < static_cast<int>(near.faces.size()); ++here) {
        expectSameFace(near, line.base, here);
    }
    int known = 0;
    for (int f = -1; f <= count; ++f) {
        known += static_cast<int>(near.indexOf(f) >= 0);
    }
    EXPECT_EQ(known, static_cast<int>(near.faces.size()));
}

std::vector<int> withRing(const Surface& surface, const std::vector<int>& faces) {
    std::vector<int> result;
    for (const int face : faces) {
        for (const int v : surface.faces()[at(face)]) {
            const Surface::FaceRange around = surface.facesAround(v);
            result.insert(result.end(), around.begin(), around.end());
        }
    }
    return result;
}

TEST(NearShell, HoldsTwoRingsAboutTheCurve) {
    const Line line = acrossPlate();
    const NearShell near = line.near(1e-3);
    const std::vector<int> passed = line.passed;
    EXPECT_GE(passed.size(), 8U);
    for (const int face : withRing(line.surface, withRing(line.surface, passed))) {
        EXPECT_GE(near.indexOf(face), 0) << "face " << face;
    }
}

TEST(NearShell, HoldsAsManyRingsAsAsked) {
    const Line line(icosphere(3), {0, kCentroid}, {3, kCentroid});
    std::size_t before = 0;
    for (int rings = 0; rings <= 3; ++rings) {
        const NearShell near(line.surface, line.base, line.passed, {.rings = rings});
        std::vector<int> expected = line.passed;
        for (int ring = 0; ring < rings; ++ring) {
            expected = withRing(line.surface, expected);
        }
        std::ranges::sort(expected);
        expected.erase(std::ranges::unique(expected).begin(), expected.end());
        EXPECT_EQ(near.faces, expected);
        EXPECT_GT(near.faces.size(), before);
        before = near.faces.size();
    }
}

// Where nothing is in their way, prisms are those of the whole shell.
TEST(NearShell, HasThePrismsOfTheWholeShell) {
    const Line line(icosphere(3), {0, kCentroid}, {3, kCentroid});
    const ShellOptions options;
    const NearShell near(
        line.surface, line.base, line.passed, {.rings = 1, .thickness = options.thickness}
    );
    const Shell whole = buildShell(line.base, options).shell;
    for (int here = 0; here < static_cast<int>(near.faces.size()); ++here) {
        const int there = near.faces[at(here)];
        for (int k = 0; k < kTetrahedraPerPrism; ++k) {
            for (int corner = 0; corner < 4; ++corner) {
                EXPECT_EQ(
                    near.shell.position(here * kTetrahedraPerPrism + k, corner),
                    whole.position(there * kTetrahedraPerPrism + k, corner)
                );
            }
        }
    }
}

TEST(NearShell, ConnectsPrismsAsTheirFaces) {
    const NearShell near = acrossPlate().near(1e-3);
    const std::vector<Prism>& prisms = near.shell.prisms();
    for (std::size_t f = 0; f < prisms.size(); ++f) {
        for (std::size_t slot = 0; slot < 3; ++slot) {
            const int there = prisms[f].neighbours[slot];
            EXPECT_EQ(there, near.base.faceNeighbours[f][at(prisms[f].faceCorner[slot])]);
            if (there >= 0) {
                const std::size_t wall = at(prisms[f].neighbourWalls[slot]);
                EXPECT_EQ(prisms[at(there)].neighbours[wall], static_cast<int>(f));
            }
        }
    }
}

// The face of the surface that a ghost leads to; -1 where it is missing.
int faceBehind(const ShellBase& base, int ghost) {
    int face = ghost;
    while (face >= base.surfaceFaceCount) {
        face = base.faceNeighbours[at(face)][2];
    }
    return face;
}

// Ghosts collapse onto the face behind them, which has to be there.
TEST(NearShell, HoldsTheFaceBehindEveryGhost) {
    const Line line = alongBoundary();
    const NearShell near = line.near(1e-3);
    const ShellBase& base = near.base;
    const int count = static_cast<int>(near.faces.size());
    EXPECT_GT(count, base.surfaceFaceCount);
    for (int ghost = base.surfaceFaceCount; ghost < count; ++ghost) {
        EXPECT_TRUE(near.shell.isGhost(ghost));
        const int behind = faceBehind(base, ghost);
        ASSERT_GE(behind, 0) << "face " << near.faces[at(ghost)];
        EXPECT_TRUE(
            std::ranges::all_of(
                base.faces[at(ghost)],
                [&](int v) {
                    return std::ranges::count(base.faces[at(behind)], base.surfaceVertex(v)) == 1;
                }
            )
        ) << "face "
          << near.faces[at(ghost)];
    }
}

TEST(NearShell, MakesPillarsAsHighAsAsked) {
    const Line line = acrossPlate();
    const NearShell low = line.near(1e-6);
    const double least = lengthOf(low.shell.pillars().front());
    const double half = 0.125;
    const NearShell near = line.near(half);
    for (const Pillar& pillar : near.shell.pillars()) {
        EXPECT_GT(lengthOf(pillar), least);
        EXPECT_NEAR(lengthOf(pillar), 2.0 * half, 1e-12);
    }
}

// A surface so curved that prisms of that height would turn over.
TEST(NearShell, ShrinksPillarsUntilPrismsAreUpright) {
    const Line line(withNoise(icosphere(2), 0.04, 3), {0, kCentroid}, {3, kCentroid});
    const double half = 0.5;
    const NearShell near = line.near(half);
    const Shell& shell = near.shell;
    double shortest = 1.0;
    for (const Pillar& pillar : shell.pillars()) {
        shortest = std::min(shortest, lengthOf(pillar));
    }
    EXPECT_LT(shortest, 1.6 * half);
    EXPECT_GT(shortest, 0.0);
    for (int prism = 0; prism < static_cast<int>(shell.prisms().size()); ++prism) {
        EXPECT_NE(shell.prisms()[at(prism)].orientation, 0) << "prism " << prism;
        EXPECT_TRUE(isUpright(shell, prism)) << "prism " << prism;
    }
}

TEST(NearShell, LeavesOutPrismsThatNeverAreUpright) {
    const Line line = acrossPlate();
    ShellBase turned = line.base;
    const int vertex = 5 * 11 + 5;  // the middle
    turned.directions[at(vertex)] *= -1.0;
    const NearShell near(line.surface, turned, line.passed, {});
    const Shell& shell = near.shell;
    const auto isLeftOut = [&](int prism) {
        return prism >= 0 &&
               std::ranges::count(line.base.faces[at(near.faces[at(prism)])], vertex) > 0;
    };
    int leftOut = 0;
    for (int prism = 0; prism < static_cast<int>(shell.prisms().size()); ++prism) {
        EXPECT_EQ(shell.isBlocked(prism), isLeftOut(prism)) << "prism " << prism;
        leftOut += static_cast<int>(isLeftOut(prism));
        EXPECT_TRUE(std::ranges::none_of(shell.prisms()[at(prism)].neighbours, isLeftOut));
    }
    EXPECT_GE(leftOut, 4);
}

}  // namespace
}  // namespace bspline_curve
