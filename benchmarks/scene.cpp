// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/scene.h"

#include "design/curve_solver.h"
#include "solver/sampled_solver.h"
#include "support/meshes.h"
#include "surface/picks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <utility>

namespace bspline_curve::benchmarks {
namespace {

constexpr double kBumps = 0.1;      // height, of the radius
constexpr double kFrequency = 4.0;  // of the bumps, along each axis
constexpr double kNoise = 0.05;     // of an edge, along each axis
constexpr double kEdge = 1.1;       // of an icosahedron in the unit sphere; halves with each split
constexpr std::uint64_t kSeed = 7;

Vec3 vertexTowards(const TriangleMesh& mesh, const Vec3& direction) {
    return *std::ranges::max_element(mesh.vertices, {}, [&](const Vec3& v) {
        return v.normalized().dot(direction);
    });
}

std::vector<Vec3> picksOn(const TriangleMesh& mesh) {
    std::vector<Vec3> picks = {
        {1.0, 0.0, 0.3},
        {0.5, 0.9, -0.2},
        {-0.5, 0.9, 0.4},
        {-1.0, 0.0, -0.3},
        {-0.5, -0.9, 0.2},
        {0.5, -0.9, -0.4}
    };
    for (Vec3& pick : picks) {
        pick = vertexTowards(mesh, pick);
    }
    return picks;
}

SolverOptions closedCurve() {
    SolverOptions options;
    options.closed = true;
    return options;
}

Solution relaxed(const CurveProblem& problem, const InitialPath& initialPath) {
    std::optional<Solution> solution = solveSampled(problem, initialPath);
    if (!solution) {
        throw std::logic_error("the curve to measure by does not come to rest");
    }
    return std::move(*solution);
}

}  // namespace

TriangleMesh bumpySphere(int subdivisions) {
    TriangleMesh mesh = test_support::icosphere(subdivisions);
    for (Vec3& v : mesh.vertices) {
        const Vec3 phase = kFrequency * v + Vec3(0.0, 1.0, 2.0);
        v *= 1.0 + kBumps * std::sin(phase[0]) * std::sin(phase[1]) * std::sin(phase[2]);
    }
    const double edge = kEdge * std::pow(0.5, subdivisions);
    return test_support::withNoise(std::move(mesh), kNoise * edge, kSeed);
}

Scene::Scene(int subdivisions)
    : mesh(bumpySphere(subdivisions)),
      picks(picksOn(mesh)),
      options(closedCurve()),
      prepared(std::make_shared<const Surface>(mesh), {}),
      located(locatePicks(prepared.surface(), prepared.tree(), picks, options.closed).points),
      path(makePath()),
      problem(makeProblem(prepared, options, path.picks)),
      heightUnit(heightUnitOf(problem)),
      first(looseFit(problem, path.path)),
      firstFooted(footed(first)),
      solution(relaxed(problem, path.path)) {}

PickPath Scene::makePath() const {
    return makePickPath(
        prepared.surface(),
        *prepared.extended(),
        located,
        options.closed,
        {.blockedFaces = {}, .patches = &prepared.patches()}
    );
}

FootedSpline Scene::footed(const SplineCurve& curve) const {
    const SampledIntegrals energy(problem, curve.space, heightUnit);
    const TriangleTree tree(prepared.extended()->vertices, prepared.extended()->faces);
    FootedSpline result;
    result.controls = curve.controls;
    for (int sample = 0; sample < energy.sampleCount(); ++sample) {
        const SurfacePoint foot =
            tree.closestPoint(curve.space.evaluate(curve.controls, energy.parameter(sample))).point;
        result.feet.push_back({foot.face, foot.barycentric[1], foot.barycentric[2], 0.0});
    }
    result.frames.resize(result.feet.size());
    energy.follow(FibreProjector(*prepared.extended()), result);
    return result;
}

Vec3 Scene::vertexNear(int pick, double edges) const {
    const Vec3& from = picks[pick];
    const double asked = edges * prepared.surface().averageEdgeLength();
    return *std::ranges::min_element(mesh.vertices, {}, [&](const Vec3& v) {
        return std::abs((v - from).norm() - asked);
    });
}

}  // namespace bspline_curve::benchmarks
