// SPDX-License-Identifier: GPL-3.0-or-later
#include "workpiece/curve_chain.h"

#include "bspline_curve/spline.h"
#include "spline/spline_sections.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace bspline_curve {

namespace {

/// Moves a spline's ends to where they are to be, those between in proportion. Two control points
/// at either end move alike, so that directions stay, and come to the given ones where these are
/// meant.
void meetEnds(SplineData& spline, const DrawnBetween& asked) {
    std::vector<Vec3>& points = spline.controlPoints;
    const std::size_t last = points.size() - 1;
    const Vec3 atStart =
        asked.from ? Vec3(asked.from->ofSpline - points.front()) : Vec3(Vec3::Zero());
    const Vec3 atEnd = asked.to ? Vec3(asked.to->ofSpline - points.back()) : Vec3(Vec3::Zero());
    for (std::size_t i = 0; i <= last; ++i) {
        const double share =
            last > 2
                ? std::clamp(
                      (static_cast<double>(i) - 1.0) / (static_cast<double>(last) - 2.0), 0.0, 1.0
                  )
                : static_cast<double>(i) / static_cast<double>(last);
        points[i] += (1.0 - share) * atStart + share * atEnd;
    }
    if (asked.from && !asked.first.isZero(0.0)) {
        points[1] = points[0] + (points[1] - points[0]).norm() * asked.from->direction;
    }
    if (asked.to && !asked.last.isZero(0.0)) {
        points[last - 1] =
            points[last] - (points[last] - points[last - 1]).norm() * asked.to->direction;
    }
}

/// A spline over [from, to].
SplineSection sectionOver(const SplineData& spline, double from, double to) {
    SplineSection section{.from = from, .to = to, .spline = spline};
    section.spline.pickParameters.clear();
    for (double& knot : section.spline.knots) {
        knot = knot == 1.0 ? to : from + knot * (to - from);
    }
    return section;
}

void appendLine(SurfacePolyline& line, const SurfacePolyline& next, double from, double to) {
    const std::size_t known = line.points.empty() ? 0 : 1;
    for (std::size_t i = known; i < next.points.size(); ++i) {
        line.surfacePoints.push_back(next.surfacePoints[i]);
        line.points.push_back(next.points[i]);
        const double t = next.parameters[i];
        line.parameters.push_back(i + 1 == next.points.size() ? to : from + t * (to - from));
    }
}

/// The picks of curves that follow each other. Where two meet is at most one.
class ChainedPicks {
public:
    explicit ChainedPicks(bool isSmooth) : isSmooth_(isSmooth) {}

    /// Of a curve over [from, to] whose first vertex is this one of all.
    void append(const Curve& curve, std::ptrdiff_t firstVertex, double from, double to) {
        const std::vector<double>& at = curve.spline.pickParameters;
        const std::vector<int>& vertices = curve.polyline.picks;
        haveVertices_ = haveVertices_ && vertices.size() == at.size();
        for (std::size_t i = 0; i < at.size(); ++i) {
            const double t = at[i] == 1.0 ? to : from + at[i] * (to - from);
            const bool isMeeting = (t == from && from > 0.0) || (t == to && to < 1.0);
            const bool isKnown = !parameters_.empty() && parameters_.back() == t;
            if (isMeeting && (isSmooth_ || isKnown)) {
                continue;
            }
            parameters_.push_back(t);
            if (haveVertices_) {
                vertices_.push_back(static_cast<int>(firstVertex) + vertices[i]);
            }
        }
    }

    void giveTo(Curve& chain) const {
        chain.spline.pickParameters = parameters_;
        if (haveVertices_) {
            chain.polyline.picks = vertices_;
        }
    }

private:
    bool isSmooth_;
    bool haveVertices_ = true;
    std::vector<double> parameters_;
    std::vector<int> vertices_;
};

}  // namespace

CurveEnd startOf(const Curve& curve) {
    return {
        curve.polyline.points.front(),
        curve.spline.controlPoints.front(),
        derivativeOf(curve.spline, 0.0).normalized()
    };
}

CurveEnd endOf(const Curve& curve) {
    return {
        curve.polyline.points.back(),
        curve.spline.controlPoints.back(),
        derivativeOf(curve.spline, 1.0).normalized()
    };
}

Curve drawnBetween(
    const Workpiece& workpiece, const DrawnBetween& asked, const Progress& progress
) {
    SolverOptions options;
    options.degree = asked.degree == 1 ? 3 : asked.degree;
    std::vector<PickTangent> tangents(asked.picks.size());
    tangents.front() = PickTangent::along(asked.first);
    tangents.back() = PickTangent::along(asked.last);
    CurveInputs inputs;
    inputs.tangents = tangents;
    Curve curve = workpiece.draw(asked.picks, options, {}, inputs, progress).curve;
    if (asked.degree == 1) {
        curve.spline = polygonSpline(curve.polyline);
    } else {
        meetEnds(curve.spline, asked);
    }
    return curve;
}

Curve chained(std::span<const Curve> curves, bool isSmooth) {
    double length = 0.0;
    for (const Curve& curve : curves) {
        length += lengthOf(curve.polyline);
    }
    Curve chain;
    chain.report.usable = true;
    std::vector<SplineSection> sections;
    ChainedPicks picks(isSmooth);
    double from = 0.0;
    for (const Curve& curve : curves) {
        const bool isLast = &curve == &curves.back();
        const double to = isLast ? 1.0 : from + lengthOf(curve.polyline) / length;
        sections.push_back(sectionOver(curve.spline, from, to));
        const std::vector<Vec3>& before = chain.polyline.points;
        picks.append(curve, before.empty() ? 0 : std::ssize(before) - 1, from, to);
        appendLine(chain.polyline, curve.polyline, from, to);
        chain.report.usable = chain.report.usable && curve.report.usable;
        chain.report.maxDistance = std::max(chain.report.maxDistance, curve.report.maxDistance);
        from = to;
    }
    chain.spline = joinedSpline(sections, false);
    picks.giveTo(chain);
    return chain;
}

}  // namespace bspline_curve
