// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/polynomial_trace.h"

#include "built_shell.h"
#include "support/meshes.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

TEST(PolynomialCurve, ShiftsWithoutMoving) {
    Random random(3);
    for (int degree = 1; degree <= kMaxPolynomialDegree; ++degree) {
        PolynomialCurve curve{.degree = degree, .coefficients = {}};
        for (int j = 0; j <= degree; ++j) {
            curve.coefficients[j] = random.point(-1.0, 1.0);
        }
        const PolynomialCurve shifted = curve.shifted(0.7);
        const double h = 1e-5;
        for (const double s : {-0.7, 0.0, 0.4}) {
            EXPECT_LT((shifted.at(s) - curve.at(s + 0.7)).norm(), 1e-14);
            EXPECT_LT((shifted.derivativeAt(s) - curve.derivativeAt(s + 0.7)).norm(), 1e-13);
            EXPECT_LT(
                (shifted.secondDerivativeAt(s) - curve.secondDerivativeAt(s + 0.7)).norm(), 1e-13
            );
            EXPECT_LT(
                ((curve.at(s + h) - curve.at(s - h)) / (2.0 * h) - curve.derivativeAt(s)).norm(),
                1e-8
            );
            EXPECT_LT(
                ((curve.derivativeAt(s + h) - curve.derivativeAt(s - h)) / (2.0 * h) -
                 curve.secondDerivativeAt(s))
                    .norm(),
                1e-8
            );
        }
    }
}

// ---- Traces ----

struct Piece {
    ShellCell cell;
    double from, to;
};

struct Trace {
    bool inside = false;
    std::vector<Piece> pieces;
    ShellCell last;
};

// Traces a curve and checks what holds for each: pieces follow each other without gaps, are cut at
// the faces between their cells, and lie in them.
Trace traced(const Shell& shell, const PolynomialCurve& curve, double end, int firstTet) {
    Trace trace;
    TraceState state{ShellCell(shell, firstTet)};
    double now = 0.0;
    trace.inside = tracePolynomial(
        shell,
        curve,
        end,
        state,
        [&](const ShellCell& cell, double from, double to) {
            EXPECT_EQ(from, now);
            EXPECT_LT(from, to);
            now = to;
            trace.pieces.push_back({cell, from, to});
        },
        [&](const ShellCell& from, const ShellCell& to, double s, int k) {
            EXPECT_EQ(s, now);
            EXPECT_EQ(shell.neighbour(from.tet, k), to.tet);
            if (s > 0.0) {
                // On the face, if the walk did not just turn about an edge.
                EXPECT_LT(from.walls[k].at(curve.at(s)), 1e-9);
            }
        }
    );
    trace.last = state.cell;
    if (trace.inside) {
        EXPECT_EQ(now, end);
        EXPECT_GE(trace.last.insideness(curve.at(end)), -1e-9);
    }
    for (const Piece& piece : trace.pieces) {
        for (int i = 0; i <= 16; ++i) {
            const double s = piece.from + (piece.to - piece.from) * i / 16.0;
            EXPECT_GE(piece.cell.insideness(curve.at(s)), -1e-9);
        }
    }
    return trace;
}

// Largest insideness of any tetrahedron of the shell: >= 0 inside, < 0 outside.
double insidenessOfShell(const std::vector<ShellCell>& cells, const Vec3& p) {
    double largest = -std::numeric_limits<double>::infinity();
    for (const ShellCell& cell : cells) {
        largest = std::max(largest, cell.insideness(p));
    }
    return largest;
}

std::vector<ShellCell> allCells(const Shell& shell) {
    std::vector<ShellCell> cells;
    for (int tet = 0; tet < shell.tetrahedronCount(); ++tet) {
        if (shell.prisms()[tet / kTetrahedraPerPrism].orientation != 0) {
            cells.emplace_back(shell, tet);
        }
    }
    return cells;
}

// A curve from a random point of the shell's middle, about `reach` long.
PolynomialCurve randomCurve(const Vec3& start, int degree, double reach, Random& random) {
    PolynomialCurve curve{.degree = degree, .coefficients = {start}};
    for (int j = 1; j <= degree; ++j) {
        curve.coefficients[j] = reach * random.point(-1.0, 1.0);
    }
    return curve;
}

struct TraceCase {
    NamedMesh mesh;
    int degree;
};

std::ostream& operator<<(std::ostream& stream, const TraceCase& c) {
    return stream << c.mesh << " degree " << c.degree;
}

class TracePolynomial : public testing::TestWithParam<TraceCase> {};

TEST_P(TracePolynomial, AgreesWithBruteForce) {
    const int degree = GetParam().degree;
    const BuiltShell built(GetParam().mesh.mesh);
    const Shell& shell = built.shell();
    const std::vector<ShellCell> cells = allCells(shell);
    int inside = 0;
    int outside = 0;
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const SurfacePoint point{
            random.integer(0, built.surface.faceCount() - 1), Vec3(0.2, 0.5, 0.3)
        };
        // Curves close to the surface stay inside more often.
        PolynomialCurve curve =
            randomCurve(shell.lift(point, 0.0), degree, random.uniform(0.01, 0.5), random);
        const Vec3 normal = built.surface.faceNormal(point.face);
        for (int j = 1; j <= degree; ++j) {
            Vec3& c = curve.coefficients[j];
            c -= random.uniform(0.5, 1.0) * c.dot(normal) * normal;
        }
        const Trace trace = traced(shell, curve, 1.0, shell.locate(point));
        ASSERT_FALSE(trace.pieces.empty());
        if (trace.inside) {
            ++inside;
            continue;
        }
        // Just after the end of the last piece no tetrahedron holds the curve.
        ++outside;
        const double exit = trace.pieces.back().to;
        EXPECT_LT(insidenessOfShell(cells, curve.at(exit)), 1e-12);
        const double step = 1e-7 / std::max(1e-3, curve.derivativeAt(exit).norm());
        EXPECT_LT(insidenessOfShell(cells, curve.at(exit + step)), 0.0);
    }
    EXPECT_GT(inside, 10);
    EXPECT_GT(outside, 10);
}

std::vector<TraceCase> traceCases() {
    std::vector<TraceCase> cases;
    for (int degree = 1; degree <= kMaxPolynomialDegree; ++degree) {
        cases.push_back({{"Plate", plate(6, 5)}, degree});
        cases.push_back({{"NoisySphere", withNoise(icosphere(2), 0.05, 21)}, degree});
        cases.push_back({{"Torus", torus(16, 8)}, degree});
        cases.push_back({{"OpenCylinder", openCylinder(12, 4)}, degree});
        cases.push_back({{"Box", box(3)}, degree});
    }
    return cases;
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, TracePolynomial, testing::ValuesIn(traceCases()), [](const auto& instance) {
        return instance.param.mesh.name + "Degree" + std::to_string(instance.param.degree);
    }
);

// Straight lines on and above a plate that run along edges of the grid and through its vertices,
// with pillars that stand upright: the worst of ties.
class TraceOnPlate : public testing::Test {
protected:
    static constexpr int kCells = 6;

    [[nodiscard]] Vec3 grid(double i, double j) const {
        return built_.extended.frame.toUnit(Vec3(i / kCells, j / kCells, 0.0));
    }

    // Traces a line at every height from every face that holds its start.
    void expectTraced(const Vec3& from, const Vec3& to, double height) const {
        const Vec3 lift(0.0, 0.0, height);
        // As fast as it goes, and slowing down, so that no degree is spared.
        for (int degree = 1; degree <= kMaxPolynomialDegree; ++degree) {
            PolynomialCurve line{.degree = degree, .coefficients = {from + lift}};
            for (int j = 1; j <= degree; ++j) {
                line.coefficients[j] = (to - from) / degree;
            }
            int starts = 0;
            for (int tet = 0; tet < built_.shell().tetrahedronCount(); ++tet) {
                if (ShellCell(built_.shell(), tet).insideness(from + lift) < -1e-12) {
                    continue;
                }
                ++starts;
                const Trace trace = traced(built_.shell(), line, 1.0, tet);
                EXPECT_TRUE(trace.inside) << "from tetrahedron " << tet << ", degree " << degree;
                const Vec3 end = to + lift;
                EXPECT_NEAR(
                    (built_.extended.position({trace.last.face, trace.last.shadow(end)}) - to)
                        .norm(),
                    0.0,
                    1e-9
                );
                EXPECT_NEAR(
                    trace.last.height.at(end), trace.last.height.gradient.z() * height, 1e-9
                );
            }
            EXPECT_GT(starts, 0);
        }
    }

    BuiltShell built_{plate(kCells, kCells)};
};

TEST_F(TraceOnPlate, FollowsEdgesOfTheGrid) {
    for (const double height : {0.0, 1e-3, -1e-3, 0.02}) {
        for (const int row : {1, 3, 5}) {
            expectTraced(grid(0.5, row), grid(5.5, row), height);
            expectTraced(grid(row, 5.5), grid(row, 0.5), height);
        }
    }
}

TEST_F(TraceOnPlate, PassesThroughVertices) {
    for (const double height : {0.0, 1e-3, -0.02}) {
        expectTraced(grid(0.5, 0.5), grid(5.5, 5.5), height);  // along diagonals and across them
        expectTraced(grid(0.5, 1.5), grid(4.5, 5.5), height);
        expectTraced(grid(5.5, 0.5), grid(0.5, 5.5), height);
        expectTraced(grid(0.5, 0.75), grid(5.5, 3.25), height);
    }
}

TEST_F(TraceOnPlate, StartsAndEndsInVertices) {
    for (const double height : {0.0, 1e-3}) {
        expectTraced(grid(1, 1), grid(5, 5), height);
        expectTraced(grid(1, 1), grid(5, 1), height);
        expectTraced(grid(2, 3), grid(4, 4), height);
    }
}

TEST_F(TraceOnPlate, ReachesTheBoundaryAndTheGhostsBeyond) {
    expectTraced(grid(0, 0), grid(6, 0), 0.0);
    expectTraced(grid(0, 3), grid(6, 3), 0.0);
    expectTraced(grid(0, 0), grid(6, 6), 0.0);
    expectTraced(grid(3, 3), grid(6.25, 3.1), 0.0);
    // And no farther.
    const PolynomialCurve beyond{
        .degree = 1, .coefficients = {grid(3, 3), grid(5, 0) - grid(0, 0)}
    };
    const Trace trace = traced(
        built_.shell(),
        beyond,
        1.0,
        0 + built_.shell().locate({2 * (3 * kCells + 3), Vec3(1, 0, 0)})
    );
    EXPECT_FALSE(trace.inside);
}

TEST_F(TraceOnPlate, GrazesWallsAndTheMiddleSurface) {
    // Touches the wall over the grid line y = 3, or the middle surface, at s = 1/2 from one side.
    const double depth = 0.02;
    for (const Vec3& side : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
        for (const double miss : {0.0, 1e-12, -1e-12, 1e-9, -1e-9, 1e-6, -1e-6}) {
            const Vec3 from = grid(1.25, 3) + (depth + miss) * side;
            const PolynomialCurve curve{
                .degree = 2,
                .coefficients = {
                    from, grid(4.75, 3) - grid(1.25, 3) - 4.0 * depth * side, 4.0 * depth * side
                }
            };
            for (int tet = 0; tet < built_.shell().tetrahedronCount(); ++tet) {
                if (ShellCell(built_.shell(), tet).insideness(from) > 0.0) {
                    EXPECT_TRUE(traced(built_.shell(), curve, 1.0, tet).inside);
                }
            }
        }
    }
}

TEST(TraceFromTheMiddle, StartsOnTheSurfaceToEitherSide) {
    const BuiltShell built(withNoise(icosphere(2), 0.05, 22));
    const Shell& shell = built.shell();
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const SurfacePoint point{
            random.integer(0, built.surface.faceCount() - 1), Vec3(0.3, 0.3, 0.4)
        };
        for (const double w : {0.4, -0.4, 1.0, -1.0}) {
            const Vec3 start = shell.lift(point, 0.0);
            const PolynomialCurve up{
                .degree = 1, .coefficients = {start, shell.lift(point, w) - start}
            };
            const Trace trace = traced(shell, up, 1.0, shell.locate(point));
            EXPECT_TRUE(trace.inside);
            EXPECT_NEAR(trace.last.height.at(up.at(1.0)), w, 1e-9);
        }
    }
}

TEST(TraceFromTheMiddle, EndsAtTopAndBottom) {
    const BuiltShell built(icosphere(2));
    const Shell& shell = built.shell();
    for (int f = 0; f < built.surface.faceCount(); ++f) {
        const SurfacePoint point{f, Vec3(0.3, 0.3, 0.4)};
        for (const double w : {1.0, -1.0}) {
            const Vec3 start = shell.lift(point, 0.0);
            const PolynomialCurve out{
                .degree = 1, .coefficients = {start, shell.lift(point, w) - start}
            };
            const Trace trace = traced(shell, out, 1.5, shell.locate(point));
            EXPECT_FALSE(trace.inside);
            ASSERT_FALSE(trace.pieces.empty());
            EXPECT_NEAR(trace.pieces.back().to, 1.0, 1e-8);
        }
    }
}

}  // namespace
}  // namespace bspline_curve
