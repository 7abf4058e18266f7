// SPDX-License-Identifier: GPL-3.0-or-later
// The polyline method that curves are compared with is given its due: its derivatives are right,
// and it comes to rest where it should.
#include "benchmarks/polyline_relaxation.h"
#include "benchmarks/scene.h"
#include "design/curve_solver.h"
#include "design/prepared_surface.h"
#include "solver/sampled_solver.h"
#include "support/meshes.h"
#include "surface/picks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve::benchmarks {
namespace {

constexpr double kAlpha = 300.0;

// A problem and a initial path, made as for a spline.
struct Setting {
    Setting(const TriangleMesh& mesh, const std::vector<Vec3>& picks, const SolverOptions& options)
        : prepared(std::make_shared<const Surface>(mesh), {}),
          path(pathOf(picks, options)),
          problem(problemOf(options)) {}

    PreparedSurface prepared;
    PickPath path;
    CurveProblem problem;

private:
    [[nodiscard]] PickPath pathOf(
        const std::vector<Vec3>& picks, const SolverOptions& options
    ) const {
        return makePickPath(
            prepared.surface(),
            *prepared.extended(),
            locatePicks(prepared.surface(), prepared.tree(), picks, options.closed).points,
            options.closed,
            {.blockedFaces = {}, .patches = &prepared.patches()}
        );
    }

    [[nodiscard]] CurveProblem problemOf(const SolverOptions& options) const {
        return makeProblem(prepared, options, path.picks);
    }
};

struct Case {
    std::string name;
    bool closed;
    double tension;
};

class Polylines : public testing::TestWithParam<Case> {
protected:
    [[nodiscard]] static SolverOptions options() {
        SolverOptions options;
        options.closed = GetParam().closed;
        options.tension = GetParam().tension;
        return options;
    }

    // On a bumpy sphere.
    [[nodiscard]] static Setting bumpy() {
        const TriangleMesh mesh = bumpySphere(3);
        return {
            mesh,
            {mesh.vertices[3], mesh.vertices[140], mesh.vertices[301], mesh.vertices[520]},
            options()
        };
    }
};

// The step between two polylines as one vector.
FootedPolyline moved(const FootedPolyline& line, const Eigen::VectorXd& along, double length) {
    FootedPolyline result = line;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        result.points[i] += length * along.segment<3>(3 * static_cast<Eigen::Index>(i));
    }
    return result;
}

// Small, and different at every vertex.
Eigen::VectorXd someWay(int vertices) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    Eigen::VectorXd way(3 * Eigen::Index{vertices});
    for (double& entry : way) {
        entry = uniform(random);
    }
    return way;
}

TEST_P(Polylines, GradientIsThatOfTheEnergy) {
    const Setting setting = bumpy();
    const FibreProjector finder(*setting.prepared.extended());
    const PolylineEnergy energy(setting.problem, 60);
    const FootedPolyline initialPath = energy.along(setting.path.path, finder);
    const Eigen::VectorXd way = someWay(energy.count());
    FootedPolyline line = moved(initialPath, someWay(energy.count()).reverse(), 1e-4);
    energy.follow(finder, line);
    Eigen::VectorXd gradient;
    std::vector<PolylineEnergy::Blocks> hessian;
    energy.differentiate(line, kAlpha, 1.0, gradient, hessian);
    constexpr double kStep = 1e-8;
    const auto totalAt = [&](double length) {
        FootedPolyline there = moved(line, way, length);
        energy.follow(finder, there);
        return energy.terms(there, line.frames).total(kAlpha);
    };
    const double slope = (totalAt(kStep) - totalAt(-kStep)) / (2.0 * kStep);
    EXPECT_NEAR(gradient.dot(way), slope, 1e-6 * std::abs(slope));
}

// The change of the gradient along a way, by the blocks.
Eigen::VectorXd product(
    const PolylineEnergy& energy,
    const std::vector<PolylineEnergy::Blocks>& hessian,
    const Eigen::VectorXd& way
) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(way.size());
    for (int i = 0; i < energy.count(); ++i) {
        for (int steps = 0; steps < 3; ++steps) {
            const SymmetricMatrix& m = hessian[i][steps];
            Eigen::Matrix3d block;
            block << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
            const Eigen::Index row = 3 * Eigen::Index{i};
            const Eigen::Index column = 3 * Eigen::Index{energy.after(i, steps)};
            result.segment<3>(row) += block * way.segment<3>(column);
            if (steps > 0) {
                result.segment<3>(column) += block * way.segment<3>(row);
            }
        }
    }
    return result;
}

// Where nothing turns, on a plane, all of it is quadratic.
TEST_P(Polylines, HessianIsTheChangeOfTheGradient) {
    const Setting setting(
        test_support::plate(12, 12), {{0.2, 0.3, 0.0}, {0.5, 0.7, 0.0}, {0.8, 0.4, 0.0}}, options()
    );
    const FibreProjector finder(*setting.prepared.extended());
    const PolylineEnergy energy(setting.problem, 40);
    const FootedPolyline line = energy.along(setting.path.path, finder);
    const Eigen::VectorXd way = someWay(energy.count());
    FootedPolyline there = moved(line, way, 1e-3);
    energy.follow(finder, there);
    Eigen::VectorXd before;
    Eigen::VectorXd after;
    std::vector<PolylineEnergy::Blocks> hessian;
    energy.differentiate(there, kAlpha, 1.0, after, hessian);
    energy.differentiate(line, kAlpha, 1.0, before, hessian);
    const Eigen::VectorXd change = 1e-3 * product(energy, hessian, way);
    EXPECT_LT((after - before - change).norm(), 1e-9 * change.norm());
}

// Many vertices bend like the spline through the same picks, whatever they cost.
TEST_P(Polylines, ComeToRestWhereTheSplineDoes) {
    const Setting setting(
        test_support::plate(24, 24), {{0.2, 0.3, 0.0}, {0.5, 0.7, 0.0}, {0.8, 0.4, 0.0}}, options()
    );
    const std::optional<Solution> spline = solveSampled(setting.problem, setting.path.path);
    ASSERT_TRUE(spline.has_value());
    const RelaxedPolyline relaxed = relaxPolyline(setting.problem, setting.path.path, 400);
    EXPECT_TRUE(relaxed.isWithinTolerance);
    const double expected = spline->report.iterations.back().terms.internal;
    EXPECT_NEAR(relaxed.internalEnergy, expected, 0.02 * expected);
}

TEST_P(Polylines, LieNearTheSurfaceAndPassThePicks) {
    const Setting setting = bumpy();
    const RelaxedPolyline relaxed = relaxPolyline(setting.problem, setting.path.path, 300);
    EXPECT_TRUE(relaxed.isWithinTolerance);
    EXPECT_LT(relaxed.largestHeight, 1.0);
    for (const PickConstraint& pick : setting.problem.picks) {
        const auto isPick = [&](const Vec3& point) { return point == pick.position; };
        EXPECT_TRUE(std::ranges::any_of(relaxed.line.points, isPick));
    }
    const FibreProjector finder(*setting.prepared.extended());
    const PolylineEnergy energy(setting.problem, 300);
    const FootedPolyline initialPath = energy.along(setting.path.path, finder);
    EXPECT_LT(relaxed.internalEnergy, 0.5 * energy.terms(initialPath, initialPath.frames).internal);
}

INSTANTIATE_TEST_SUITE_P(
    All,
    Polylines,
    testing::Values(
        Case{"Open", false, 0.0},
        Case{"Closed", true, 0.0},
        Case{"OpenTense", false, 0.5},
        Case{"ClosedTense", true, 0.3}
    ),
    [](const auto& tested) { return tested.param.name; }
);

}  // namespace
}  // namespace bspline_curve::benchmarks
