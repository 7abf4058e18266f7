// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/polynomial_trace.h"

#include "built_shell.h"
#include "support/meshes.h"
#include "support/seeds.h"
#include "traces.h"

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
            const Vec3 slope = (curve.at(s + h) - curve.at(s - h)) / (2.0 * h);
            EXPECT_LT((slope - curve.derivativeAt(s)).norm(), 1e-8);
            const Vec3 bend = (curve.derivativeAt(s + h) - curve.derivativeAt(s - h)) / (2.0 * h);
            EXPECT_LT((bend - curve.secondDerivativeAt(s)).norm(), 1e-8);
        }
    }
}

// ---- Traces ----

Trace tracedInside(const Shell& shell, const PolynomialCurve& curve, double end, int firstTet) {
    const auto onCrossing = [&](const ShellCell& from, const ShellCell& to, double s, int k) {
        EXPECT_EQ(shell.neighbour(from.tet, k), to.tet);
        if (s > 0.0) {
            // On the face, if the walk did not just turn about an edge.
            EXPECT_LT(from.walls[k].at(curve.at(s)), 1e-9);
        }
    };
    return test_support::traced(shell, curve, end, ShellCell(shell, firstTet), onCrossing);
}

// The most crossings of a walk to a random point close by, from one in a face, on an edge or next
// to it.
int mostCrossings(const BuiltShell& built, int walks, std::uint64_t seed) {
    Random random(seed);
    int most = 0;
    for (int i = 0; i < walks; ++i) {
        const SurfacePoint start{
            random.integer(0, built.surface.faceCount() - 1), random.awkwardBarycentric()
        };
        if (built.shell().locate(start) < 0) {
            continue;
        }
        const Vec3 from = built.extended.position(start);
        const Vec3 to =
            from + std::pow(10.0, random.uniform(-14.0, -1.0)) * random.point(-1.0, 1.0);
        const PolynomialCurve line{.degree = 1, .coefficients = {from, to - from}};
        TraceState state{ShellCell(built.shell(), start)};
        int crossings = 0;
        const auto ignorePiece = [](const auto&...) {};
        tracePolynomial(built.shell(), line, 1.0, state, ignorePiece, [&](const auto&...) {
            ++crossings;
        });
        most = std::max(most, crossings);
    }
    return most;
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
    forEachSeed(150, [&](Random& random) {
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
        const Trace trace = tracedInside(shell, curve, 1.0, shell.locate(point));
        ASSERT_FALSE(trace.pieces.empty());
        if (trace.inside) {
            ++inside;
            return;
        }
        // Just after the end of the last piece no tetrahedron holds the curve.
        ++outside;
        const double exit = trace.pieces.back().to;
        EXPECT_LT(insidenessOfShell(cells, curve.at(exit)), 1e-12);
        const double step = 1e-7 / std::max(1e-3, curve.derivativeAt(exit).norm());
        EXPECT_LT(insidenessOfShell(cells, curve.at(exit + step)), 0.0);
    });
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
                const Trace trace = tracedInside(built_.shell(), line, 1.0, tet);
                EXPECT_TRUE(trace.inside) << "from tetrahedron " << tet << ", degree " << degree;
                const Vec3 end = to + lift;
                const ShellCell& last = trace.last;
                EXPECT_LT(
                    (built_.extended.position({last.face, last.shadow(end)}) - to).norm(), 1e-9
                );
                EXPECT_NEAR(last.height.at(end), last.height.gradient.z() * height, 1e-9);
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
    const int tet = built_.shell().locate({2 * (3 * kCells + 3), Vec3(1, 0, 0)});
    EXPECT_FALSE(tracedInside(built_.shell(), beyond, 1.0, tet).inside);
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
                    EXPECT_TRUE(tracedInside(built_.shell(), curve, 1.0, tet).inside);
                }
            }
        }
    }
}

// From a point of the surface along the line to its lift at height w, to `end` times as far.
Trace tracedUp(const Shell& shell, const SurfacePoint& point, double w, double end) {
    const Vec3 start = shell.lift(point, 0.0);
    const PolynomialCurve up{.degree = 1, .coefficients = {start, shell.lift(point, w) - start}};
    Trace trace = tracedInside(shell, up, end, shell.locate(point));
    if (trace.inside) {
        EXPECT_NEAR(trace.last.height.at(up.at(end)), w, 1e-9);
    }
    return trace;
}

// Walls of cells between sheets that almost touch are rounded by more than their tolerance: each of
// the cells round an edge may hand a point to the next one.
TEST(TraceBetweenSheets, TakesFewTurnsHoweverCloseTheyAre) {
    const int walks = 20000;
    EXPECT_LT(mostCrossings(BuiltShell(icosphere(2)), walks, 1), 20);
    for (const double gap : {1e-6, 1e-8, 1e-10, 1e-12}) {
        SCOPED_TRACE(gap);
        TriangleMesh upper = jitteredPlate(4, 4, 0.29, 1);
        for (Vec3& vertex : upper.vertices) {
            vertex.z() += gap;
        }
        const Eigen::Isometry3d motion = Random(5).isometry(1.0);
        const TriangleMesh both = joined(jitteredPlate(4, 4, 0.29, 2), upper);
        EXPECT_LT(mostCrossings(BuiltShell(transformed(both, motion)), walks, 2), 2000);
    }
}

TEST(TraceFromTheMiddle, StartsOnTheSurfaceToEitherSide) {
    const BuiltShell built(withNoise(icosphere(2), 0.05, 22));
    forEachSeed(300, [&](Random& random) {
        const int face = random.integer(0, built.surface.faceCount() - 1);
        for (const double w : {0.4, -0.4, 1.0, -1.0}) {
            EXPECT_TRUE(tracedUp(built.shell(), {face, Vec3(0.3, 0.3, 0.4)}, w, 1.0).inside);
        }
    });
}

TEST(TraceFromTheMiddle, EndsAtTopAndBottom) {
    const BuiltShell built(icosphere(2));
    for (int f = 0; f < built.surface.faceCount(); ++f) {
        for (const double w : {1.0, -1.0}) {
            const Trace trace = tracedUp(built.shell(), {f, Vec3(0.3, 0.3, 0.4)}, w, 1.5);
            EXPECT_FALSE(trace.inside);
            ASSERT_FALSE(trace.pieces.empty());
            EXPECT_NEAR(trace.pieces.back().to, 1.0, 1e-8);
        }
    }
}

}  // namespace
}  // namespace bspline_curve
