// SPDX-License-Identifier: GPL-3.0-or-later
// The solver in shells whose prisms hold many faces.
#include "bspline_curve/curve.h"
#include "design/curve_checks.h"
#include "design/strict_polyline.h"
#include "problem_fixture.h"
#include "projection/projected_curve.h"
#include "shell/polynomial_trace.h"
#include "shell/shell_boundary.h"
#include "solver/cell_integrand.h"
#include "solver/cellwise_solver.h"
#include "solver/problem_traces.h"
#include "support/meshes.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>

namespace bspline_curve {
namespace {

using namespace test_support;

// Cells that a few straight lines pass, with a point of each.
struct CellPoint {
    ShellCell cell;
    Vec3 position;
};

std::vector<CellPoint> cellsAlongLines(const CoarseShell& coarse, std::uint64_t seed) {
    Random random(seed);
    std::vector<CellPoint> cells;
    for (int i = 0; i < 20; ++i) {
        const SurfacePoint point{
            random.integer(0, coarse.surface.faceCount() - 1), Vec3(0.2, 0.5, 0.3)
        };
        const PolynomialCurve line{
            .degree = 1,
            .coefficients = {coarse.extended->position(point), 0.15 * random.point(-1.0, 1.0)}
        };
        TraceState state{ShellCell(coarse.shell, point)};
        (void)tracePolynomial(
            coarse.shell,
            line,
            1.0,
            state,
            [&](const ShellCell& cell, double from, double to) {
                cells.push_back({cell, line.at(0.5 * (from + to))});
            },
            [](const auto&...) {}
        );
    }
    return cells;
}

double valueAt(const CellIntegrand& integrand, const Vec3& p, double alpha) {
    EnergyTerms terms;
    return integrand.add(p, 1.0, terms) ? alpha * terms.distance + terms.external
                                        : std::numeric_limits<double>::quiet_NaN();
}

PointDerivatives derivativesAt(const CellIntegrand& integrand, const Vec3& p) {
    EnergyTerms terms;
    PointDerivatives derivatives;
    EXPECT_TRUE(integrand.add(p, 1.0, terms, derivatives));
    return derivatives;
}

Eigen::Matrix3d dense(const SymmetricMatrix& m) {
    Eigen::Matrix3d matrix;
    matrix << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
    return matrix;
}

class IntegrandOfACell : public testing::TestWithParam<RelativeHeight> {};

TEST_P(IntegrandOfACell, HasTheDerivativesOfItsDifferences) {
    for (const CoarseShellCase& mesh : coarseShellCases()) {
        SCOPED_TRACE(mesh.name);
        const CoarseShell coarse(mesh.fine, mesh.coarse, mesh.height);
        CurveProblem problem;
        problem.shell = &coarse.shell;
        problem.extended = coarse.extended.get();
        problem.options.fieldWeight = 1.0;
        problem.options.fieldCost = FieldCost::Square;
        problem.options.relativeHeight = GetParam();
        std::vector<double> field;
        for (const Vec3& v : coarse.extended->vertices) {
            field.push_back(std::sin(3.0 * v.x()) + v.y() * v.z());
        }
        problem.field = field;
        const EnergyWeights weights{20.0, 5.0, 1.0};
        for (const CellPoint& point : cellsAlongLines(coarse, 51)) {
            const double height = point.cell.relativeHeight(point.position);
            const Vec3 shadow = point.cell.shadow(point.position);
            if (std::abs(height) > 0.95 || std::abs(height) < 1e-4 || shadow.minCoeff() < 1e-3) {
                continue;
            }
            for (const double scale : {1.0, 0.99}) {
                const CellIntegrand integrand(problem, weights, point.cell, scale);
                const PointDerivatives exact = derivativesAt(integrand, point.position);
                const Eigen::Matrix3d exactHessian = dense(exact.second);
                EXPECT_LT(
                    (integrand.gradient(point.position) - exact.force).norm(),
                    1e-12 * exact.force.norm()
                );
                const double h = 1e-6;
                Vec3 gradient;
                Eigen::Matrix3d hessian;
                for (int axis = 0; axis < 3; ++axis) {
                    const Vec3 up = point.position + h * Vec3::Unit(axis);
                    const Vec3 down = point.position - h * Vec3::Unit(axis);
                    gradient[axis] = (valueAt(integrand, up, weights.alpha) -
                                      valueAt(integrand, down, weights.alpha)) /
                                     (2.0 * h);
                    hessian.col(axis) =
                        (integrand.gradient(up) - integrand.gradient(down)) / (2.0 * h);
                }
                EXPECT_LT((gradient - exact.force).norm(), 1e-6 * exactHessian.norm());
                // Gauss-Newton for the field: no second derivative of an affine function.
                EXPECT_LT((hessian - exactHessian).norm(), 1e-5 * exactHessian.norm());
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Heights, IntegrandOfACell, testing::Values(RelativeHeight::Smooth, RelativeHeight::Linear)
);

// (10): 0 on the surface, 1 at top and bottom, linear between.
TEST(LinearHeight, IsLinearFromTheSurfaceToTopAndBottom) {
    for (const CoarseShellCase& mesh : coarseShellCases()) {
        SCOPED_TRACE(mesh.name);
        const CoarseShell coarse(mesh.fine, mesh.coarse, mesh.height);
        for (const CellPoint& point : cellsAlongLines(coarse, 52)) {
            const double w = point.cell.height.at(point.position);
            const double v = point.cell.surfaceHeight.at(point.position);
            const double d = point.cell.linearHeight(point.position);
            EXPECT_GE(d, 0.0);
            // The share of the way from the surface to top or bottom.
            EXPECT_NEAR(v + d * ((w >= v ? 1.0 : -1.0) - v), w, 1e-12);
        }
    }
}

// ---- Whole curves ----

struct Drawn {
    Solution solution;
    SurfacePolyline line;
};

Drawn draw(const ProblemFixture& fixture, const std::vector<Vec3>& picks) {
    Solution solution = solved(fixture);
    const auto& [space, controls] = solution.curve;
    const ProjectedCurve shadow(
        *fixture.problem().extended,
        fixture.problem().shell,
        space,
        controls,
        traceCells(traceStartOf(fixture.problem()), space, controls)
    );
    SurfacePolyline line = makeStrictPolyline(
        fixture.surface(),
        fixture.problem(),
        FairedShadow(fixture.problem(), shadow),
        SamplingOptions()
    );
    EXPECT_TRUE(solution.report.usable);
    expectStrict(fixture.surface(), line);
    EXPECT_EQ(line.picks.size(), picks.size());
    for (std::size_t i = 0; i < picks.size(); ++i) {
        EXPECT_LT((line.points[line.picks[i]] - picks[i]).norm(), 0.02);
    }
    return {std::move(solution), std::move(line)};
}

class CurvesInCoarseShells : public testing::TestWithParam<CoarseShellCase> {};

std::vector<Vec3> picksOn(const TriangleMesh& mesh, std::uint64_t seed, int count) {
    Random random(seed);
    std::vector<Vec3> picks;
    for (int i = 0; i < count; ++i) {
        const Triangle& face =
            mesh.faces[random.integer(0, static_cast<int>(mesh.faces.size()) - 1)];
        picks.emplace_back(
            0.5 * mesh.vertices[face[0]] + 0.3 * mesh.vertices[face[1]] +
            0.2 * mesh.vertices[face[2]]
        );
    }
    return picks;
}

TEST_P(CurvesInCoarseShells, AreThoseOfTheThinShell) {
    const CoarseShellCase& mesh = GetParam();
    for (const bool closed : {false, true}) {
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed) + (closed ? " closed" : " open"));
            SolverOptions options;
            options.closed = closed;
            const std::vector<Vec3> picks = picksOn(mesh.fine, seed, 4);
            const ProblemFixture coarse(mesh, picks, options);
            const ProblemFixture thin(mesh.fine, picks, options);
            const Drawn inCoarse = draw(coarse, picks);
            const Drawn inThin = draw(thin, picks);
            // Where noise leaves several minima, shells may lead to different ones; over sharp
            // edges curves that keep their tolerance may still cut the edge at different places.
            const bool isSmooth = mesh.name != "NoisySphere" && mesh.name != "WavyPlate" &&
                                  mesh.name != "Torus" && mesh.name != "Box";
            if (isSmooth) {
                EXPECT_LT(
                    largestDistance(inCoarse.line, inThin.line),
                    0.25 * coarse.surface().averageEdgeLength()
                );
            }
            for (const RoundReport& round : inCoarse.solution.report.rounds) {
                EXPECT_NE(round.status, MinimiseStatus::NotPositive);
                EXPECT_NE(round.status, MinimiseStatus::Outside);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, CurvesInCoarseShells, testing::ValuesIn(coarseShellCases()), [](const auto& instance) {
        return instance.param.name;
    }
);

// By symmetry a smooth curve through points of one great circle is that circle, whatever the
// triangles of the shell.
TEST(CoarseShellOfASphere, DrawsGreatCircles) {
    SolverOptions options;
    options.closed = true;
    const Eigen::Quaterniond turn(Random(3).isometry(0.0).rotation());
    std::vector<Vec3> picks;
    for (const double angle : {0.1, 1.3, 2.9, 4.0, 5.2}) {
        picks.emplace_back(turn * Vec3(std::cos(angle), std::sin(angle), 0.0));
    }
    const ProblemFixture sphere({"Sphere", icosphere(4), icosphere(1), 0.3}, picks, options);
    const Drawn circle = draw(sphere, picks);
    EXPECT_EQ(circle.solution.report.status, SolveStatus::Converged);
    const Vec3 axis = turn * Vec3::UnitZ();
    for (const Vec3& p : circle.line.points) {
        EXPECT_LT(std::abs(p.dot(axis)), 0.1 * sphere.surface().averageEdgeLength());
    }
    EXPECT_NEAR(length(circle.line), 2.0 * std::numbers::pi, 0.01);
}

// The paper's settings: samples that may lie outside and come back by the nearest boundary point,
// and control polygons that touch top and bottom.
TEST(CoarseShellOfASphere, BearsSamplesAndControlPolygons) {
    const CoarseShellCase mesh{"Sphere", withNoise(icosphere(3), 0.01, 8), icosphere(1), 0.3};
    for (const Quadrature quadrature : {Quadrature::Cells, Quadrature::Samples}) {
        for (const InitialCurve initial :
             {InitialCurve::GeodesicFit, InitialCurve::ControlPolygon}) {
            SolverOptions options;
            options.quadrature = quadrature;
            options.initialCurve = initial;
            const std::vector<Vec3> picks = picksOn(mesh.fine, 4, 4);
            ProblemFixture fixture(mesh, picks, options);
            const ShellBoundary boundary(*fixture.problem().shell);
            fixture.problem().boundary = &boundary;
            (void)draw(fixture, picks);
        }
    }
}

// Every point outside belongs to the cell of its nearest point of the boundary.
TEST(CoarseShellBoundary, HasACellForEveryPoint) {
    for (const CoarseShellCase& mesh : coarseShellCases()) {
        SCOPED_TRACE(mesh.name);
        const CoarseShell coarse(mesh.fine, mesh.coarse, mesh.height);
        const ShellBoundary boundary(coarse.shell);
        Random random(52);
        for (int i = 0; i < 100; ++i) {
            const ShellBoundary::Nearest nearest = boundary.nearest(random.point(-0.6, 0.6));
            const std::optional<ShellCell> cell =
                ShellCell::find(coarse.shell, nearest.tet, nearest.position);
            if (!coarse.extended->ghostSource.empty()) {
                continue;  // beyond the rim no fibre needs to meet the surface
            }
            ASSERT_TRUE(cell.has_value());
            EXPECT_GE(cell->insideness(nearest.position), -1e-9);
            EXPECT_NEAR(std::abs(cell->relativeHeight(nearest.position)), 1.0, 1e-9);
        }
    }
}

}  // namespace
}  // namespace bspline_curve
