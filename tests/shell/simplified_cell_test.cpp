// SPDX-License-Identifier: GPL-3.0-or-later
// Cells and traces where prisms hold many faces, against a projection that intersects whole fibres
// with all faces.
#include "built_shell.h"
#include "shell/polynomial_trace.h"
#include "support/coarse_shell.h"
#include "support/meshes.h"
#include "support/seeds.h"
#include "traces.h"

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

    [[nodiscard]] Vec3 shadowOf(const ShellCell& cell, const Vec3& p) const {
        return extended_.position({cell.face, cell.shadow(p)});
    }

    CoarseShell coarse_;
    const Shell& shell_;
    const ExtendedSurface& extended_;
};

INSTANTIATE_TEST_SUITE_P(Meshes, CoarseShells, testing::ValuesIn(coarseShellCases()), nameOfParam);

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

TEST_P(CoarseShells, AreTracedExactly) {
    int crossings = 0;
    int inside = 0;
    forEachSeed(60, [&](Random& random) {
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
        const Trace trace = traced(
            shell_,
            curve,
            1.0,
            ShellCell(shell_, point),
            [&](const ShellCell& from, const ShellCell& to, double s, int wall) {
                // Every map is continuous across every wall.
                ++crossings;
                const Vec3 p = curve.at(s);
                EXPECT_NEAR(from.walls[wall].at(p), 0.0, 2e-9);
                EXPECT_NEAR(from.height.at(p), to.height.at(p), 1e-9);
                EXPECT_NEAR(from.surfaceHeight.at(p), to.surfaceHeight.at(p), 1e-8);
                EXPECT_LT((shadowOf(from, p) - shadowOf(to, p)).norm(), 1e-9);
            }
        );
        ASSERT_FALSE(trace.pieces.empty());
        for (const Piece& piece : trace.pieces) {
            expectExact(coarse_, piece.cell, curve.at(0.5 * (piece.from + piece.to)));
        }
        if (trace.inside) {
            ++inside;
            return;
        }
        // Just behind the end no fibre meets the surface.
        const Vec3 beyond = curve.at(trace.pieces.back().to + 1e-6);
        const int tet = deepestTet(shell_, beyond);
        if (barycentricsIn(shell_, tet, beyond).minCoeff() > 0.0) {
            EXPECT_FALSE(
                footByBruteForce(shell_, extended_, inPrism(shell_, tet, beyond)).has_value()
            );
        }
    });
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
        const ExtendedSurface& extended = built.extended;
        const Shell& thin = built.shell();
        const Shell other = asSimplified(thin, built.sharedExtended);
        Random random(44);
        for (int i = 0; i < 300; ++i) {
            const SurfacePoint point{
                random.integer(0, built.surface.faceCount() - 1), random.barycentric()
            };
            const Vec3 from = extended.position(point);
            const Vec3 reach = 0.1 * random.point(-1.0, 1.0);
            const PolynomialCurve line{.degree = 1, .coefficients = {from, reach}};
            const auto ignore = [](const auto&...) {};
            const Trace inThin = traced(thin, line, 1.0, ShellCell(thin, point), ignore);
            const Trace inOther = traced(other, line, 1.0, ShellCell(other, point), ignore);
            ASSERT_EQ(inThin.inside, inOther.inside) << "line " << i;
            ASSERT_FALSE(inThin.pieces.empty() || inOther.pieces.empty());
            ASSERT_NEAR(inThin.pieces.back().to, inOther.pieces.back().to, 1e-6) << "line " << i;
            const ShellCell& a = inThin.last;
            const ShellCell& b = inOther.last;
            const Vec3 end = line.at(inThin.pieces.back().to);
            EXPECT_NEAR(a.height.at(end), b.height.at(end), 1e-7);
            EXPECT_NEAR(b.surfaceHeight.at(end), 0.0, 1e-7);
            EXPECT_NEAR(a.relativeHeight(end), b.relativeHeight(end), 1e-7);
            EXPECT_LT(
                (extended.position({a.face, a.shadow(end)}) -
                 extended.position({b.face, b.shadow(end)}))
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
