// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/span_distances.h"

#include "solver/curve_tracer.h"
#include "surface/closest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

// The distance of p to the surface near its shadow. In a simplified shell the fibres are oblique:
// the shadow is not the closest point, which lies in the same face or next to it.
double distanceAt(const CurveProblem& problem, const ShellCell& cell, const Vec3& p) {
    const ShellBase& base = *problem.base;
    const Triangle& face = base.faces[at(cell.face)];
    if (!problem.shell->isFullResolution() && !problem.shell->isGhost(cell.face)) {
        double closest = closestPointOnTriangle(base.vertices, face, p).squaredDistance;
        for (const int there : base.faceNeighbours[at(cell.face)]) {
            if (there >= 0 && !problem.shell->isGhost(there)) {
                closest = std::min(
                    closest,
                    closestPointOnTriangle(base.vertices, base.faces[at(there)], p).squaredDistance
                );
            }
        }
        return std::sqrt(closest);
    }
    const Vec3 shadow = cell.shadow(p);
    Vec3 onSurface = Vec3::Zero();
    for (int corner = 0; corner < 3; ++corner) {
        // A ghost vertex stands for the boundary vertex that it grew from.
        onSurface += shadow[corner] * base.vertices[at(base.surfaceVertex(face[at(corner)]))];
    }
    return (p - onSurface).norm();
}

}  // namespace

double SpanDistances::largest() const {
    return distance.empty() ? 0.0 : *std::max_element(distance.begin(), distance.end());
}

SpanDistances measureDistances(
    const CurveProblem& problem, const SplineSpace& space, const ControlPoints& controls
) {
    SpanDistances result;
    result.distance.assign(at(space.spanCount()), 0.0);
    const auto measureAt = [&](int span, const ShellCell& cell, const Vec3& p) {
        result.largestHeight = std::max(result.largestHeight, std::abs(cell.relativeHeight(p)));
        result.distance[at(span)] =
            std::max(result.distance[at(span)], distanceAt(problem, cell, p));
    };
    const int spans = traceCurve(
        problem,
        space,
        controls,
        [&](
            int span, const PolynomialCurve& curve, const ShellCell& cell, double tau0, double tau1
        ) {
            measureAt(span, cell, curve.at(tau0));
            measureAt(span, cell, curve.at(0.5 * (tau0 + tau1)));
        },
        [](int, const PolynomialCurve&, const ShellCell&, const ShellCell&, double, int) {}
    );
    for (int span = spans; span < space.spanCount(); ++span) {
        result.distance[at(span)] = std::numeric_limits<double>::infinity();
        result.largestHeight = 1.0;
    }
    return result;
}

}  // namespace bspline_curve
