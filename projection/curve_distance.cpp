// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/curve_distance.h"

#include "projection/projected_curve.h"
#include "surface/closest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bspline_curve {
namespace {

double distanceToShadow(const ExtendedSurface& extended, const ShellCell& cell, const Vec3& p) {
    const Triangle& face = extended.faces[cell.face];
    const Vec3 shadow = cell.shadow(p);
    Vec3 onSurface = Vec3::Zero();
    for (int corner = 0; corner < 3; ++corner) {
        // A ghost vertex stands for the boundary vertex that it grew from.
        onSurface += shadow[corner] * extended.vertices[extended.surfaceVertex(face[corner])];
    }
    return (p - onSurface).norm();
}

// The shadow along an oblique fibre is not the closest point, which lies in the same face or next
// to it.
double distanceToFaces(const ExtendedSurface& extended, int face, const Vec3& p) {
    const auto squaredDistanceTo = [&](int f) {
        return closestPointOnTriangle(extended.vertices, extended.faces[f], p).squaredDistance;
    };
    double closest = squaredDistanceTo(face);
    for (const int there : extended.faceNeighbours[face]) {
        if (there >= 0 && there < extended.surfaceFaceCount) {
            closest = std::min(closest, squaredDistanceTo(there));
        }
    }
    return std::sqrt(closest);
}

}  // namespace

CurveDistance measureDistance(
    const TraceStart& traced, const SplineSpace& space, const ControlPoints& controls
) {
    CurveDistance result;
    const bool isOblique = !traced.shell.isFullResolution();
    result.perSpan.assign(space.spanCount(), std::numeric_limits<double>::infinity());
    const auto measureAt = [&](int span, const ShellCell& cell, const Vec3& p) {
        result.largestHeight = std::max(result.largestHeight, std::abs(cell.relativeHeight(p)));
        double distance = distanceToShadow(traced.extended, cell, p);
        // The shadow bounds the distance from above, mostly below the largest so far.
        double& ofSpan = result.perSpan[span];
        if (distance > ofSpan && isOblique && !traced.shell.isGhost(cell.face)) {
            distance = distanceToFaces(traced.extended, cell.face, p);
        }
        ofSpan = std::max(ofSpan, distance);
    };
    int current = -1;
    CellTrace trace = traceCells(
        traced,
        space,
        controls,
        [&](
            int span, const PolynomialCurve& curve, const ShellCell& cell, double tau0, double tau1
        ) {
            if (span != current) {
                current = span;
                result.perSpan[span] = 0.0;
            }
            measureAt(span, cell, curve.at(tau0));
            measureAt(span, cell, curve.at(0.5 * (tau0 + tau1)));
        }
    );
    result.largest = std::ranges::max(result.perSpan);
    if (!trace.isWhole) {
        // Where it leaves is on the span that was begun.
        result.perSpan[trace.wholeSpans] = std::numeric_limits<double>::infinity();
        result.largest = std::numeric_limits<double>::infinity();
        result.largestHeight = 1.0;
    }
    result.trace = std::move(trace);
    return result;
}

std::vector<char> farSpans(const CurveDistance& distance, double tolerance) {
    const std::vector<double>& perSpan = distance.perSpan;
    std::vector<char> marked(perSpan.size(), 0);
    for (std::size_t span = 0; span < perSpan.size(); ++span) {
        const bool isKnown = span == 0 || std::isfinite(perSpan[span - 1]);
        marked[span] = perSpan[span] >= tolerance && isKnown ? 1 : 0;
    }
    return marked;
}

}  // namespace bspline_curve
