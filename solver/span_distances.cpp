// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/span_distances.h"

#include "solver/curve_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
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
        const Vec3 shadow = cell.shadow(p);
        const double height = cell.relativeHeight(p);
        Vec3 onSurface = Vec3::Zero();
        const Triangle& face = problem.base->faces[at(cell.face)];
        for (int corner = 0; corner < 3; ++corner) {
            // A ghost vertex stands for the boundary vertex that it grew from.
            onSurface += shadow[corner] *
                         problem.base->vertices[at(problem.base->surfaceVertex(face[at(corner)]))];
        }
        result.largestHeight = std::max(result.largestHeight, std::abs(height));
        result.distance[at(span)] = std::max(result.distance[at(span)], (p - onSurface).norm());
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
