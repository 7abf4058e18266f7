// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/pieces.h"
#include "text/error_messages.h"
#include "workpiece/curve_chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace bspline_curve {

namespace {

/// Ends that are nearer, relative to the diagonal, are one point.
constexpr double kOnePointRelative = 1e-9;
/// Directions that differ by less are one, in radians.
constexpr double kOneDirection = 1e-6;

void requireLength(const MeshLength& length, const char* name) {
    if (!(length.value >= 0.0) || !std::isfinite(length.value)) {
        throw InputError(
            InputErrorCode::BadOption,
            std::string(name) + " is " + describe(length) + ", but must be at least 0"
        );
    }
}

void requireJoinable(const Curve& first, const Curve& second) {
    if (first.polyline.closed || second.polyline.closed) {
        throw InputError(InputErrorCode::BadOption, "a closed curve has no ends to be joined");
    }
    if (first.spline.degree != second.spline.degree) {
        throw InputError(
            InputErrorCode::BadOption,
            "the splines have the degrees " + std::to_string(first.spline.degree) + " and " +
                std::to_string(second.spline.degree) + "; curves of one degree can be joined"
        );
    }
}

/// Two curves that follow each other, the ends that are nearest in the middle.
struct Meeting {
    Curve before, after;
    double gap = 0.0;
};

Meeting meetingOf(const Curve& first, const Curve& second) {
    const auto apart = [&](bool atEnd, bool ofEnd) {
        const std::vector<Vec3>& a = first.polyline.points;
        const std::vector<Vec3>& b = second.polyline.points;
        return ((atEnd ? a.back() : a.front()) - (ofEnd ? b.back() : b.front())).norm();
    };
    // Where several are as near as each other, the end of the first and the start of the second.
    const std::array<double, 4> gaps{
        apart(true, false), apart(true, true), apart(false, true), apart(false, false)
    };
    const auto best = std::ranges::min_element(gaps) - gaps.begin();
    const bool turns = best % 2 == 1;
    const Curve other = turns ? reversedCurve(second) : second;
    Meeting meeting{.before = first, .after = other, .gap = gaps[best]};
    if (best >= 2) {
        std::swap(meeting.before, meeting.after);
    }
    return meeting;
}

double angleOfDirections(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The parameter at a distance along a polyline, at most a third of it, from its start.
double parameterAfter(const SurfacePolyline& line, double distance) {
    double left = std::min(distance, lengthOf(line) / 3.0);
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        const double step = (line.points[i] - line.points[i - 1]).norm();
        if (left <= step && step > 0.0) {
            const double share = left / step;
            return (1.0 - share) * line.parameters[i - 1] + share * line.parameters[i];
        }
        left -= step;
    }
    return 1.0;
}

Curve bridge(
    const Workpiece& workpiece, const Meeting& meeting, bool isSmooth, const Progress& progress
) {
    const CurveEnd from = endOf(meeting.before);
    const CurveEnd to = startOf(meeting.after);
    const Vec3 none = Vec3::Zero();
    return drawnBetween(
        workpiece,
        {.picks = {from.onMesh, to.onMesh},
         .degree = meeting.before.spline.degree,
         .from = from,
         .to = to,
         .first = isSmooth ? from.direction : none,
         .last = isSmooth ? to.direction : none},
        progress
    );
}

}  // namespace

void JoinOptions::validate() const {
    requireLength(gap, "gap");
    requireLength(blend, "blend");
}

Curve joinedCurves(
    const Workpiece& workpiece,
    const Curve& first,
    const Curve& second,
    const JoinOptions& options,
    const Progress& progress
) {
    options.validate();
    requireJoinable(first, second);
    Meeting meeting = meetingOf(first, second);
    const double edge = workpiece.meanEdgeLength();
    const bool meet = meeting.gap <= kOnePointRelative * workpiece.diagonal();
    if (!meet && meeting.gap > options.gap.in(edge)) {
        throw InputError(
            InputErrorCode::BadOption,
            "the ends of the curves are " + describeNumber(meeting.gap) +
                " apart, more than the gap that is allowed, " + describeNumber(options.gap.in(edge))
        );
    }
    const double angle =
        angleOfDirections(endOf(meeting.before).direction, startOf(meeting.after).direction);
    if (meet && (!options.isSmooth || angle <= kOneDirection)) {
        const bool isSmooth = angle <= kOneDirection;
        return chained(std::array{meeting.before, meeting.after}, isSmooth);
    }
    if (options.isSmooth) {
        const double blend = options.blend.in(edge);
        if (meet && !(blend > 0.0)) {
            throw InputError(
                InputErrorCode::BadOption,
                "blend is 0, but curves that meet at an angle need room to become smooth"
            );
        }
        const Curve turned = reversedCurve(meeting.before);
        meeting.before = partOfCurve(
            workpiece, meeting.before, 0.0, 1.0 - parameterAfter(turned.polyline, blend)
        );
        meeting.after = partOfCurve(
            workpiece, meeting.after, parameterAfter(meeting.after.polyline, blend), 1.0
        );
    }
    const Curve between = bridge(workpiece, meeting, options.isSmooth, progress);
    return chained(std::array{meeting.before, between, meeting.after}, options.isSmooth);
}

}  // namespace bspline_curve
