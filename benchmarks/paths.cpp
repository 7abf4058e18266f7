// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/paths.h"

#include "design/curve_designer.h"
#include "projection/fibre_tracer.h"
#include "shell/shell_simplifier.h"
#include "solver/newton.h"
#include "solver/problem_traces.h"
#include "solver/sampled_energy.h"
#include "solver/sampled_solver.h"
#include "surface/patch_levels.h"
#include "surface/self_intersection.h"
#include "surface/surface.h"
#include "surface/triangle_tree.h"

#include <cstddef>
#include <memory>
#include <utility>

namespace bspline_curve::benchmarks {
namespace {

// Weight of the distance, that of usual first rounds.
constexpr double kAlpha = 100.0;
// Simplification takes 60 us per face: on a small mesh, whatever the scene's.
constexpr int kSimplifiedSubdivisions = 3;
// By how much a pick is moved for a curve that starts from the one before.
constexpr double kMovedEdges = 2.0;

int countOf(std::size_t size) {
    return static_cast<int>(size);
}

// ---- Once per mesh ----

void addMeshPaths(const Scene& scene, std::vector<MeasuredPath>& paths) {
    const Surface& surface = scene.prepared.surface();
    const int faces = surface.faceCount();
    paths.push_back({"validate", "face", faces, [&scene] { const Surface made(scene.mesh); }});
    paths.push_back({"tree", "face", faces, [&surface] {
                         const TriangleTree made(surface.vertices(), surface.faces());
                     }});
    paths.push_back({"patches", "face", faces, [&surface] { const PatchLevels made(surface); }});
    paths.push_back({"extended_surface", "face", faces, [&scene, &surface] {
                         static_cast<void>(extendSurface(
                             surface,
                             makeRoughBase(surface),
                             scene.prepared.options().smoothingPasses,
                             scene.prepared.patches()
                         ));
                     }});
    paths.push_back(
        {"self_intersections", "face", faces, [&surface] {
             static_cast<void>(findSelfIntersections(surface.vertices(), surface.faces()));
         }}
    );
    const Surface small(bumpySphere(kSimplifiedSubdivisions));
    const auto extended = std::make_shared<const ExtendedSurface>(extendSurface(small, 3));
    paths.push_back({"simplify_shell", "face", small.faceCount(), [extended] {
                         ShellOptions options;
                         options.kind = ShellKind::Simplified;
                         static_cast<void>(buildSimplifiedShell(extended, options));
                     }});
}

// ---- Once per curve ----

// The points of the first path, a little off the surface.
std::vector<Vec3> queriesNear(const Scene& scene) {
    std::vector<Vec3> queries;
    for (const InitialPath::Point& point : scene.path.path.points) {
        queries.emplace_back(1.001 * scene.prepared.extended()->frame.toUser(point.position));
    }
    return queries;
}

void addCurvePaths(const Scene& scene, std::vector<MeasuredPath>& paths) {
    const std::vector<Vec3> queries = queriesNear(scene);
    paths.push_back({"locate_pick", "point", countOf(queries.size()), [&scene, queries] {
                         for (const Vec3& query : queries) {
                             static_cast<void>(scene.prepared.tree().closestPoint(query));
                         }
                     }});
    paths.push_back({"first_path", "pick", countOf(scene.picks.size()), [&scene] {
                         static_cast<void>(scene.makePath());
                     }});
    paths.push_back({"trace", "face passed", countOf(facesPassed(scene.solution).size()), [&scene] {
                         const SplineCurve& curve = scene.solution.curve;
                         static_cast<void>(measureAlongFibres(
                             fibreStartOf(scene.problem), curve.space, curve.controls
                         ));
                     }});
}

// ---- In every Newton step ----

// Feet walk from where the first curve has them to those of a curve moved by an edge along each
// axis, and back.
void addFootPath(const Scene& scene, std::vector<MeasuredPath>& paths) {
    const auto energy = std::make_shared<const SampledIntegrals>(
        scene.problem, scene.first.space, scene.heightUnit
    );
    const int samples = energy->sampleCount();
    const Vec3 shift = Vec3::Constant(scene.problem.averageEdgeLength);
    std::vector<Vec3> here;
    for (int sample = 0; sample < samples; ++sample) {
        here.push_back(scene.first.space.evaluate(scene.first.controls, energy->parameter(sample)));
    }
    paths.push_back({"foot_point", "move", 2 * samples, [&scene, here, shift] {
                         const FibreProjector finder(*scene.prepared.extended());
                         for (std::size_t i = 0; i < here.size(); ++i) {
                             FootPoint foot = scene.firstFooted.feet[i];
                             FootFrame frame;
                             finder.move(here[i] + shift, foot, frame);
                             finder.move(here[i], foot, frame);
                         }
                     }});
    paths.push_back({"energy_derivatives", "sample", samples, [&scene, energy] {
                         Eigen::VectorXd gradient;
                         std::vector<SpanBlocks> hessian;
                         energy->differentiate(
                             scene.firstFooted, {.alpha = kAlpha}, 1.0, gradient, hessian
                         );
                     }});
}

void addNewtonPath(const Scene& scene, std::vector<MeasuredPath>& paths) {
    const auto energy = std::make_shared<SampledEnergy>(
        scene.problem,
        scene.first,
        scene.path.path,
        scene.heightUnit,
        SampledIntegrals::kUsualSegments
    );
    paths.push_back({"newton_step", "span", scene.first.space.spanCount(), [&scene, energy] {
                         energy->setFooted(scene.firstFooted);
                         EnergyWeights weights;
                         weights.alpha = kAlpha;
                         NewtonGoal oneStep = sampledPolicy(scene.problem).round;
                         oneStep.mostIterations = 1;
                         static_cast<void>(minimise(
                             *energy,
                             weights,
                             Interpolation::Constraint,
                             sampledPolicy(scene.problem).newton,
                             oneStep
                         ));
                     }});
}

// ---- Whole curves ----

void addDesigns(const Scene& scene, std::vector<MeasuredPath>& paths) {
    const auto designer = std::make_shared<const CurveDesigner>(scene.mesh);
    paths.push_back({"design_warm", "curve", 1, [&scene, designer] {
                         static_cast<void>(designer->design(scene.picks, scene.options));
                     }});
    std::vector<Vec3> moved = scene.picks;
    moved.front() = scene.vertexNear(0, kMovedEdges);
    const auto before = std::make_shared<const Curve>(designer->design(scene.picks, scene.options));
    paths.push_back({"design_moved", "curve", 1, [&scene, designer, moved, before] {
                         static_cast<void>(designer->design(
                             moved, scene.options, {}, {.start = before.get(), .isPreview = true}
                         ));
                     }});
    // As all curves were drawn before there were foot points, and as some still are.
    const auto whole = std::make_shared<const CurveDesigner>(
        scene.mesh, ShellOptions{.kind = ShellKind::FullResolution}
    );
    paths.push_back({"design_warm_by_cells", "curve", 1, [&scene, whole] {
                         SolverOptions options = scene.options;
                         options.quadrature = Quadrature::Cells;
                         static_cast<void>(whole->design(scene.picks, options));
                     }});
    paths.push_back({"design_cold", "curve", 1, [&scene] {
                         const CurveDesigner made(scene.mesh);
                         static_cast<void>(made.design(scene.picks, scene.options));
                     }});
}

}  // namespace

std::vector<MeasuredPath> measuredPaths(const Scene& scene) {
    std::vector<MeasuredPath> paths;
    addFootPath(scene, paths);
    addNewtonPath(scene, paths);
    addCurvePaths(scene, paths);
    addMeshPaths(scene, paths);
    addDesigns(scene, paths);
    return paths;
}

}  // namespace bspline_curve::benchmarks
