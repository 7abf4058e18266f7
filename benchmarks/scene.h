// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "design/initial_path.h"
#include "design/prepared_surface.h"
#include "solver/curve_problem.h"
#include "solver/initial_curve.h"
#include "solver/sampled_integrals.h"
#include "solver/solution.h"

#include <vector>

namespace bspline_curve::benchmarks {

/// A bumpy, noisy sphere of 20 * 4^subdivisions faces; the same on every machine but for rounding.
[[nodiscard]] TriangleMesh bumpySphere(int subdivisions);

/// A closed curve through six picks on a bumpy sphere, and what each step of drawing it starts
/// from, made the way CurveDesigner does.
struct Scene {
    explicit Scene(int subdivisions);
    Scene(const Scene&) = delete;  // parts of it refer to others
    Scene& operator=(const Scene&) = delete;

    TriangleMesh mesh;
    std::vector<Vec3> picks;  ///< vertices of the mesh
    SolverOptions options;
    PreparedSurface prepared;
    std::vector<SurfacePoint> located;  ///< the picks
    PickPath path;
    CurveProblem problem;
    double heightUnit;         ///< of SampledIntegrals
    SplineCurve first;         ///< along the path, as in solveSampled()
    FootedSpline firstFooted;  ///< the same with the feet of SampledIntegrals's samples
    Solution solution;

    /// Paths from pick to pick, as at first.
    [[nodiscard]] PickPath makePath() const;
    [[nodiscard]] FootedSpline footed(const SplineCurve& curve) const;

    /// The vertex whose distance from a pick is nearest to so many mean edges.
    [[nodiscard]] Vec3 vertexNear(int pick, double edges) const;
};

}  // namespace bspline_curve::benchmarks
