// SPDX-License-Identifier: GPL-3.0-or-later
// Cells and traces where prisms hold many faces, against a projection that intersects whole fibres
// with all faces.
#include "built_shell.h"
#include "lifted_walk.h"
#include "shell/polynomial_trace.h"
#include "support/coarse_shell.h"
#include "support/meshes.h"
#include "support/random.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

// ---- The same by brute force, from pillars, prisms and faces alone ----

Eigen::Vector4d barycentricsIn(const Shell& shell, int tet, const Vec3& p) {
    Eigen::Matrix4d corners;
    for (int k = 0; k < 4; ++k) {
        corners.col(k) << shell.position(tet, k), 1.0;
    }
    return corners.fullPivLu().solve(Eigen::Vector4d(p.x(), p.y(), p.z(), 1.0));
}

// Coordinates of a point in a prism: barycentrics by slot, and f.
struct PrismPoint {
    int prism = -1;
    Vec3 beta = Vec3::Zero();
    double height = 0.0;
};

PrismPoint inPrism(const Shell& shell, int tet, const Vec3& p) {
    const Eigen::Vector4d lambda = barycentricsIn(shell, tet, p);
    PrismPoint result{tet / kTetrahedraPerPrism};
    for (int k = 0; k < 4; ++k) {
        const SplitVertex corner = kSlabSplit[tet % 3][k];
        result.beta[corner.slot] += lambda[k];
        if (corner.outer) {
            result.height += tet % kTetrahedraPerPrism < 3 ? lambda[k] : -lambda[k];
        }
    }
    return result;
}

// The tetrahedron that p lies in deepest.
int deepestTet(const Shell& shell, const Vec3& p) {
    int best = -1;
    double deepest = -std::numeric_limits<double>::infinity();
    for (int tet = 0; tet < shell.tetrahedronCount(); ++tet) {
        const double depth = barycentricsIn(shell, tet, p).minCoeff();
        if (depth > deepest) {
            deepest = depth;
            best = tet;
        }
    }
    return best;
}

Vec3 onFibre(const Shell& shell, int prism, const Vec3& beta, double w) {
    double rest = std::abs(w);
    Vec3 result = Vec3::Zero();
    for (int slot = 2; slot >= 0; --slot) {
        const Pillar& pillar = shell.pillars()[shell.prisms()[prism].pillars[slot]];
        const double outer = std::clamp(rest, 0.0, beta[slot]);
        rest -= outer;
        result +=
            (beta[slot] - outer) * pillar.middle + outer * (w > 0.0 ? pillar.top : pillar.bottom);
    }
    return result;
}

struct Foot {
    Vec3 position;
    double height;
};

// Where the fibre through a point meets the surface, nothing where it misses. Faces that it meets
// in their edges are allowed for.
std::optional<Foot> footByBruteForce(
    const Shell& shell, const ExtendedSurface& extended, const PrismPoint& point
) {
    constexpr double kMargin = 1e-9;
    const Vec3& beta = point.beta;
    const std::array<double, 7> heights = {
        -1.0, -beta[2] - beta[1], -beta[2], 0.0, beta[2], beta[2] + beta[1], 1.0
    };
    std::optional<Foot> found;
    double best = -kMargin;
    for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
        const Vec3 from = onFibre(shell, point.prism, beta, heights[i]);
        const Vec3 to = onFibre(shell, point.prism, beta, heights[i + 1]);
        if ((to - from).norm() < 1e-12) {
            continue;
        }
        for (const Triangle& face : extended.faces) {
            const Vec3& a = extended.vertices[face[0]];
            const Vec3& b = extended.vertices[face[1]];
            const Vec3& c = extended.vertices[face[2]];
            Eigen::Matrix3d system;
            system << from - to, b - a, c - a;
            if (std::abs(system.determinant()) < 1e-18) {
                continue;
            }
            const Vec3 x = system.fullPivLu().solve(from - a);
            const double inside = std::min({x[0], 1.0 - x[0], x[1], x[2], 1.0 - x[1] - x[2]});
            if (inside > best) {
                best = inside;
                const double height = heights[i] + x[0] * (heights[i + 1] - heights[i]);
                const Vec3 position = from + x[0] * (to - from);
                found = {position, height};
                if (inside > kMargin) {
                    return found;
                }
            }
        }
    }
    return found;
}

// Expects that the cell holds p and says of it what brute force does.
void expectExact(const CoarseShell& coarse, const ShellCell& cell, const Vec3& p) {
    const Shell& shell = coarse.shell;
    ASSERT_GE(cell.insideness(p), -1e-9);
    const PrismPoint point = inPrism(shell, cell.tet, p);
    const std::optional<Foot> foot = footByBruteForce(shell, *coarse.extended, point);
    ASSERT_TRUE(foot.has_value());
    EXPECT_NEAR(cell.height.at(p), point.height, 1e-11);
    EXPECT_NEAR(cell.surfaceHeight.at(p), foot->height, 1e-8);
    const Vec3 shadow = coarse.extended->position({cell.face, cell.shadow(p)});
    EXPECT_LT((shadow - foot->position).norm(), 1e-9);
    EXPECT_EQ(cell.prism, cell.foot / kTetrahedraPerPrism);
}

class CoarseShells : public testing::TestWithParam<CoarseShellCase> {
protected:
    CoarseShells()
        : coarse_(GetParam().fine, GetParam().coarse, GetParam().height),
          shell_(coarse_.shell),
          extended_(*coarse_.extended) {}

    CoarseShell coarse_;
    const Shell& shell_;
    const ExtendedSurface& extended_;
};

INSTANTIATE_TEST_SUITE_P(
    Meshes, CoarseShells, testing::ValuesIn(coarseShellCases()), [](const auto& instance) {
        return instance.param.name;
    }
);

TEST_P(CoarseShells, LocatePointsOfTheSurface) {
    Random random(41);
    for (int i = 0; i < 300; ++i) {
        SCOPED_TRACE("point " + std::to_string(i));
        const SurfacePoint point{
            random.integer(0, coarse_.surface.faceCount() - 1), random.awkwardBarycentric()
        };
        const Vec3 p = extended_.position(point);
        const ShellCell cell(shell_, point);
        EXPECT_EQ(cell.face, point.face);
        expectExact(coarse_, cell, p);
        EXPECT_LT((cell.shadow(p) - point.barycentric).norm(), 1e-11);
        EXPECT_NEAR(cell.height.at(p), cell.surfaceHeight.at(p), 1e-12);
        EXPECT_NEAR(cell.relativeHeight(p), 0.0, 1e-12);
        EXPECT_LT((shell_.lift(point, cell.height.at(p)) - p).norm(), 1e-14);
    }
}

TEST_P(CoarseShells, ProjectWhatTheyLift) {
    Random random(42);
    double worst = 0.0;
    double worstHeight = 0.0;
    for (int i = 0; i < 20000; ++i) {
        SCOPED_TRACE("point " + std::to_string(i));
        const SurfacePoint point{
            random.integer(0, coarse_.surface.faceCount() - 1), random.awkwardBarycentric()
        };
        const double w = random.uniform(-1.0, 1.0);
        TraceState state;
        ASSERT_TRUE(walkUp(shell_, extended_, point, w, state));
        const Vec3 lifted = shell_.lift(point, w);
        EXPECT_GE(state.cell.insideness(lifted), -2.0 * kCellTolerance);
        const Vec3 shadow = extended_.position({state.cell.face, state.cell.shadow(lifted)});
        worst = std::max(worst, (shadow - extended_.position(point)).norm());
        worstHeight = std::max(worstHeight, std::abs(state.cell.height.at(lifted) - w));
    }
    // Over creases the maps of the cell before the wall say something else within its tolerance.
    const double tolerance = GetParam().name == "Box" ? kCellTolerance : 3e-12;
    EXPECT_LT(worst, tolerance);
    EXPECT_LT(worstHeight, tolerance);
}

TEST_P(CoarseShells, FindTheFaceUnderAPoint) {
    Random random(43);
    for (int i = 0; i < 60; ++i) {
        SCOPED_TRACE("point " + std::to_string(i));
        const SurfacePoint point{
            random.integer(0, coarse_.surface.faceCount() - 1), random.awkwardBarycentric()
        };
        const Vec3 p = shell_.lift(point, random.uniform(-0.99, 0.99));
        const std::optional<ShellCell> cell = ShellCell::find(shell_, deepestTet(shell_, p), p);
        ASSERT_TRUE(cell.has_value());
        EXPECT_GE(cell->insideness(p), -1e-10);
        const Vec3 shadow = extended_.position({cell->face, cell->shadow(p)});
        EXPECT_LT((shadow - extended_.position(point)).norm(), 1e-12);
    }
}

// A prism may list faces that miss it, also such that its fibres would meet beyond top or bottom.
TEST(FacesBeyondTheTop, HaveNoPartInAPrism) {
    const double height = 0.1;
    const TriangleMesh sheets = parallelPlates(6, 2.5 * height);
    const CoarseShell lower(plate(6, 6), plate(2, 2), height);
    const auto extended = std::make_shared<ExtendedSurface>(extendSurface(Surface(sheets), 3));
    SurfaceTracks tracks{{0}, {}};
    std::vector<Pillar> pillars;
    for (const Pillar& pillar : lower.shell.pillars()) {
        const auto moved = [&](const Vec3& p) {
            return extended->frame.toUnit(lower.extended->frame.toUser(p));
        };
        pillars.push_back({moved(pillar.bottom), moved(pillar.middle), moved(pillar.top)});
    }
    for (std::size_t i = 0; i < lower.shell.prisms().size(); ++i) {
        for (int face = 0; face < extended->surfaceFaceCount; ++face) {
            tracks.faces.push_back(face);
        }
        tracks.offsets.push_back(static_cast<int>(tracks.faces.size()));
    }
    const Shell shell(pillars, lower.shell.prisms(), tracks, extended);
    Random random(45);
    for (int tet = 0; tet < shell.tetrahedronCount(); ++tet) {
        for (int i = 0; i < 20; ++i) {
            const Vec3 weights = random.barycentric();
            const Vec3 p = weights[0] * shell.position(tet, 0) +
                           weights[1] * shell.position(tet, 1) +
                           0.5 * weights[2] * (shell.position(tet, 2) + shell.position(tet, 3));
            const std::optional<ShellCell> cell = ShellCell::find(shell, tet, p);
            ASSERT_TRUE(cell.has_value());
            EXPECT_NEAR(cell->surfaceHeight.at(p), 0.0, 1e-12) << "tetrahedron " << tet;
        }
    }
}

struct Piece {
    ShellCell cell;
    double from, to;
};

TEST_P(CoarseShells, AreTracedExactly) {
    int crossings = 0;
    int inside = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const SurfacePoint point{
            random.integer(0, coarse_.surface.faceCount() - 1), random.barycentric()
        };
        const Vec3 normal = coarse_.surface.faceNormal(point.face);
        PolynomialCurve curve{.degree = 3, .coefficients = {extended_.position(point)}};
        for (int j = 1; j <= 3; ++j) {
            Vec3& c = curve.coefficients[j];
            c = 0.1 * random.point(-1.0, 1.0);
            c -= random.uniform(0.7, 1.0) * c.dot(normal) * normal;
        }
        TraceState state{ShellCell(shell_, point)};
        std::vector<Piece> pieces;
        double now = 0.0;
        const bool stays = tracePolynomial(
            shell_,
            curve,
            1.0,
            state,
            [&](const ShellCell& cell, double from, double to) {
                EXPECT_EQ(from, now);
                EXPECT_LT(from, to);
                now = to;
                pieces.push_back({cell, from, to});
            },
            [&](const ShellCell& from, const ShellCell& to, double s, int wall) {
                // Every map is continuous across every wall.
                ++crossings;
                EXPECT_EQ(s, now);
                const Vec3 p = curve.at(s);
                EXPECT_NEAR(from.walls[wall].at(p), 0.0, 2e-9);
                EXPECT_NEAR(from.height.at(p), to.height.at(p), 1e-9);
                EXPECT_NEAR(from.surfaceHeight.at(p), to.surfaceHeight.at(p), 1e-8);
                EXPECT_LT(
                    (extended_.position({from.face, from.shadow(p)}) -
                     extended_.position({to.face, to.shadow(p)}))
                        .norm(),
                    1e-9
                );
            }
        );
        ASSERT_FALSE(pieces.empty());
        for (const Piece& piece : pieces) {
            expectExact(coarse_, piece.cell, curve.at(0.5 * (piece.from + piece.to)));
            EXPECT_GE(piece.cell.insideness(curve.at(piece.from)), -1e-9);
            EXPECT_GE(piece.cell.insideness(curve.at(piece.to)), -1e-9);
        }
        if (stays) {
            ++inside;
            EXPECT_EQ(now, 1.0);
            continue;
        }
        // Just behind the end no fibre meets the surface.
        const Vec3 beyond = curve.at(now + 1e-6);
        const int tet = deepestTet(shell_, beyond);
        if (barycentricsIn(shell_, tet, beyond).minCoeff() > 0.0) {
            EXPECT_FALSE(
                footByBruteForce(shell_, extended_, inPrism(shell_, tet, beyond)).has_value()
            );
        }
    }
    EXPECT_GT(inside, 20);
    EXPECT_GT(crossings, 300);
}

// The worst of ties: from vertices of the surface to others in a straight line, in which faces,
// walls of prisms and pillars may lie.
TEST_P(CoarseShells, LetLinesPassThroughVertices) {
    int passed = 0;
    const int stride = std::max(1, coarse_.surface.faceCount() / 120);
    for (int f = 0; f < coarse_.surface.faceCount(); f += stride) {
        const SurfacePoint start{f, Vec3::Unit(f % 3)};
        const Vec3 from = extended_.position(start);
        const Triangle& face = extended_.faces[f];
        const Vec3 along = extended_.vertices[face[(f + 1) % 3]] - from;
        for (const double times : {1.0, 2.0, 3.0}) {
            // To where the edge leads, as far as its end is below the surface of the shell.
            const Vec3 to = from + times * along;
            const int tet = deepestTet(shell_, to);
            if (barycentricsIn(shell_, tet, to).minCoeff() < -1e-14 ||
                !footByBruteForce(shell_, extended_, inPrism(shell_, tet, to))) {
                continue;
            }
            TraceState state{ShellCell(shell_, start)};
            if (walkStraight(shell_, from, to, state)) {
                ++passed;
                expectExact(coarse_, state.cell, to);
            } else {
                // Somewhere on the way it must be outside.
                double least = 1.0;
                for (int i = 1; i < 50; ++i) {
                    const Vec3 p = from + (to - from) * i / 50.0;
                    const int there = deepestTet(shell_, p);
                    least = std::min(least, barycentricsIn(shell_, there, p).minCoeff());
                }
                EXPECT_LT(least, 0.0) << "face " << f << ", " << times << " edges";
            }
        }
    }
    EXPECT_GT(passed, 20);
}

// ---- Both forms of one shell ----

TEST(BothForms, AgreeOnTheSameShell) {
    for (const NamedMesh& mesh : shellMeshes()) {
        SCOPED_TRACE(mesh.name);
        const BuiltShell built(mesh.mesh);
        const auto extended = std::make_shared<ExtendedSurface>(built.extended);
        const Shell& thin = built.shell();
        const Shell other = asSimplified(thin, extended);
        Random random(44);
        for (int i = 0; i < 300; ++i) {
            const SurfacePoint point{
                random.integer(0, built.surface.faceCount() - 1), random.barycentric()
            };
            const Vec3 from = extended->position(point);
            const Vec3 reach = 0.1 * random.point(-1.0, 1.0);
            TraceState a{ShellCell(thin, point)};
            TraceState b{ShellCell(other, point)};
            double endA = 0.0;
            double endB = 0.0;
            const PolynomialCurve line{.degree = 1, .coefficients = {from, reach}};
            const auto ignore = [](const auto&...) {};
            const bool insideA = tracePolynomial(
                thin, line, 1.0, a, [&](const ShellCell&, double, double to) { endA = to; }, ignore
            );
            const bool insideB = tracePolynomial(
                other, line, 1.0, b, [&](const ShellCell&, double, double to) { endB = to; }, ignore
            );
            ASSERT_EQ(insideA, insideB) << "line " << i;
            ASSERT_NEAR(endA, endB, 1e-6) << "line " << i;
            const Vec3 end = line.at(endA);
            EXPECT_NEAR(a.cell.height.at(end), b.cell.height.at(end), 1e-7);
            EXPECT_NEAR(b.cell.surfaceHeight.at(end), 0.0, 1e-7);
            EXPECT_NEAR(a.cell.relativeHeight(end), b.cell.relativeHeight(end), 1e-7);
            EXPECT_LT(
                (extended->position({a.cell.face, a.cell.shadow(end)}) -
                 extended->position({b.cell.face, b.cell.shadow(end)}))
                    .norm(),
                1e-8
            );
        }
    }
}

TEST(BlockedFaces, HaveNoPrism) {
    const CoarseShell coarse(icosphere(2), icosphere(1), 0.3);
    EXPECT_TRUE(coarse.shell.blockedFaces().empty());
    SurfaceTracks tracks{{0}, {}};
    for (std::size_t i = 0; i < coarse.shell.prisms().size(); ++i) {
        for (const int face : coarse.shell.facesOf(static_cast<int>(i))) {
            if (face != 7) {
                tracks.faces.push_back(face);
            }
        }
        tracks.offsets.push_back(static_cast<int>(tracks.faces.size()));
    }
    const Shell shell(coarse.shell.pillars(), coarse.shell.prisms(), tracks, coarse.extended);
    EXPECT_EQ(shell.blockedFaces(), std::vector<int>{7});
    EXPECT_TRUE(shell.isBlocked(7));
    EXPECT_EQ(shell.locate({7, Vec3::Constant(1.0 / 3.0)}), -1);
    // Curves do not pass it.
    const int next = coarse.extended->faceNeighbours[7][0];
    const SurfacePoint start{next, Vec3::Constant(1.0 / 3.0)};
    TraceState state{ShellCell(shell, start)};
    const Vec3 to = coarse.extended->position({7, Vec3::Constant(1.0 / 3.0)});
    EXPECT_FALSE(walkStraight(shell, coarse.extended->position(start), to, state));
}

}  // namespace
}  // namespace bspline_curve
