// SPDX-License-Identifier: GPL-3.0-or-later
// Curves turned round and cut.
#include "bspline_curve/error.h"
#include "bspline_curve/pieces.h"
#include "bspline_curve/spline.h"
#include "surface/strict_line.h"
#include "surface/surface_point.h"
#include "text/error_messages.h"
#include "workpiece/workpiece_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

/// Parameters that differ by less are one.
constexpr double kOneParameter = 1e-12;
/// A part between parameters that differ by less has no length.
constexpr double kLeastPart = 1e-9;

/// The vertices of a curve by their parameters; a closed one goes round twice.
class RolledLine {
public:
    RolledLine(const Surface& surface, const SurfacePolyline& line)
        : surface_(surface), line_(line), count_(line.points.size()) {}

    [[nodiscard]] std::size_t size() const { return line_.closed ? 2 * count_ + 1 : count_; }

    [[nodiscard]] std::size_t vertex(std::size_t i) const { return i % count_; }

    [[nodiscard]] double parameter(std::size_t i) const {
        const std::size_t round = i / count_;
        return line_.parameters[i % count_] + static_cast<double>(round);
    }

    /// The first vertex that is not before a parameter.
    [[nodiscard]] std::size_t notBefore(double t) const {
        std::size_t i = 0;
        while (i + 1 < size() && parameter(i) < t) {
            ++i;
        }
        return i;
    }

    void append(SurfacePolyline& part, std::size_t i, double t) const {
        part.surfacePoints.push_back(line_.surfacePoints[vertex(i)]);
        part.points.push_back(line_.points[vertex(i)]);
        part.parameters.push_back(t);
    }

    /// The point at a parameter, as that with the parameter `as`.
    void appendAt(SurfacePolyline& part, double t, double as) const {
        const std::size_t after = notBefore(t);
        for (const std::size_t near : {after, after - std::min<std::size_t>(after, 1)}) {
            if (std::abs(parameter(near) - t) <= kOneParameter) {
                append(part, near, as);
                return;
            }
        }
        const double low = parameter(after - 1);
        const double share = (t - low) / (parameter(after) - low);
        SurfacePolyline segment;
        append(segment, after - 1, 0.0);
        append(segment, after, 1.0);
        segment = strictLine(surface_, std::move(segment), "the curve");
        const SurfacePoint& from = segment.surfacePoints.front();
        const SurfacePoint& to = segment.surfacePoints.back();
        const int face = commonFace(surface_, from, to);
        const SurfacePoint between{
            .face = face,
            .barycentric = (1.0 - share) * inFace(surface_, from, face).barycentric +
                           share * inFace(surface_, to, face).barycentric
        };
        part.surfacePoints.push_back(surface_.provenance().toInput(between));
        part.points.push_back(surface_.position(between));
        part.parameters.push_back(as);
    }

private:
    const Surface& surface_;
    const SurfacePolyline& line_;
    std::size_t count_;
};

void requireParameter(double t) {
    const bool isOnCurve = t >= 0.0 && t <= 1.0;
    if (!isOnCurve) {
        throw InputError(
            InputErrorCode::BadOption,
            "a parameter is " + describeNumber(t) + ", but those of a curve are in [0, 1]"
        );
    }
}

/// The picks between two parameters, and which vertices of the part they are. Returns which picks
/// of the whole they are.
std::vector<int> keepPicks(Curve& part, const Curve& curve, double from, double to) {
    const std::vector<double>& at = curve.spline.pickParameters;
    const bool hasVertices = curve.polyline.picks.size() == at.size();
    std::vector<double> kept;
    std::vector<int> ids;
    for (const double turn : {0.0, 1.0}) {
        for (std::size_t i = 0; i < at.size(); ++i) {
            const double on = at[i] + turn;
            const bool isIn = on >= from - kOneParameter && on <= to + kOneParameter;
            if (isIn && (turn == 0.0 || curve.polyline.closed)) {
                kept.push_back(std::clamp((on - from) / (to - from), 0.0, 1.0));
                ids.push_back(static_cast<int>(i));
            }
        }
    }
    part.spline.pickParameters = kept;
    const std::vector<double>& vertices = part.polyline.parameters;
    for (std::size_t i = 0; hasVertices && i < kept.size(); ++i) {
        const auto near =
            std::ranges::min_element(vertices, {}, [&](double t) { return std::abs(t - kept[i]); });
        part.polyline.picks.push_back(static_cast<int>(near - vertices.begin()));
    }
    return ids;
}

struct Part {
    Curve curve;
    std::vector<int> picks;  ///< which of the whole they are
};

Part partBetween(const Workpiece& workpiece, const Curve& curve, double from, double to) {
    const RolledLine rolled(surfaceOf(workpiece), curve.polyline);
    Curve part;
    part.report.usable = curve.report.usable;
    part.report.maxDistance = curve.report.maxDistance;
    part.spline = partOfSpline(curve.spline, from, to);
    rolled.appendAt(part.polyline, from, 0.0);
    for (std::size_t i = rolled.notBefore(from + kOneParameter);
         i < rolled.size() && rolled.parameter(i) < to - kOneParameter;
         ++i) {
        if (rolled.parameter(i) > from + kOneParameter) {
            rolled.append(part.polyline, i, (rolled.parameter(i) - from) / (to - from));
        }
    }
    rolled.appendAt(part.polyline, to, 1.0);
    std::vector<int> picks = keepPicks(part, curve, from, to);
    return {std::move(part), std::move(picks)};
}

/// Which picks of a curve are those of the one that goes the other way, in its order.
std::vector<int> reversedPicks(const SplineData& spline) {
    const std::vector<double>& at = spline.pickParameters;
    std::vector<int> picks(at.size());
    std::iota(picks.rbegin(), picks.rend(), 0);
    // That at the start of a closed curve stays the first.
    std::ranges::stable_sort(picks, [&](int a, int b) {
        const auto behind = [&](int pick) {
            return spline.closed && at[pick] == 0.0 ? 1.0 : at[pick];
        };
        return behind(a) > behind(b);
    });
    return picks;
}

}  // namespace

Curve reversedCurve(const Curve& curve, std::vector<int>* picks) {
    if (picks != nullptr) {
        *picks = reversedPicks(curve.spline);
    }
    Curve result;
    // By these a curve that starts from this one goes on.
    result.report.isSampled = curve.report.isSampled;
    result.report.rounds = curve.report.rounds;
    result.report.usable = curve.report.usable;
    result.report.maxDistance = curve.report.maxDistance;
    result.spline = reversedSpline(curve.spline);
    SurfacePolyline& line = result.polyline;
    line = curve.polyline;
    const auto stays = line.closed ? 1 : 0;
    std::reverse(line.surfacePoints.begin() + stays, line.surfacePoints.end());
    std::reverse(line.points.begin() + stays, line.points.end());
    std::reverse(line.parameters.begin() + stays, line.parameters.end());
    std::for_each(line.parameters.begin() + stays, line.parameters.end(), [](double& t) {
        t = 1.0 - t;
    });
    const auto count = static_cast<int>(line.points.size());
    for (int& pick : line.picks) {
        pick = line.closed ? (count - pick) % count : count - 1 - pick;
    }
    std::ranges::sort(line.picks);
    return result;
}

Curve partOfCurve(
    const Workpiece& workpiece, const Curve& curve, double from, double to, std::vector<int>* picks
) {
    requireParameter(from);
    requireParameter(to);
    const double end = curve.polyline.closed && to < from ? to + 1.0 : to;
    if (!(end - from > kLeastPart)) {
        throw InputError(
            InputErrorCode::BadOption,
            "the part from " + describeNumber(from) + " to " + describeNumber(to) +
                " has no length; its start must be before its end"
        );
    }
    Part part = partBetween(workpiece, curve, from, end);
    if (picks != nullptr) {
        *picks = std::move(part.picks);
    }
    return std::move(part.curve);
}

std::vector<Curve> partsOfCurve(
    const Workpiece& workpiece,
    const Curve& curve,
    std::span<const double> at,
    std::vector<std::vector<int>>* picks
) {
    if (picks != nullptr) {
        picks->clear();
    }
    const bool closed = curve.polyline.closed;
    std::vector<double> cuts;
    for (const double t : at) {
        requireParameter(t);
        cuts.push_back(closed && t == 1.0 ? 0.0 : t);
    }
    if (cuts.empty()) {
        throw InputError(InputErrorCode::BadOption, "there is no parameter to cut the curve at");
    }
    if (!closed) {
        cuts.insert(cuts.end(), {0.0, 1.0});
    }
    std::ranges::sort(cuts);
    if (closed) {
        cuts.push_back(cuts.front() + 1.0);
    }
    std::vector<Curve> parts;
    double from = cuts.front();
    for (const double to : cuts) {
        if (to - from > kLeastPart) {
            Part part = partBetween(workpiece, curve, from, to);
            parts.push_back(std::move(part.curve));
            if (picks != nullptr) {
                picks->push_back(std::move(part.picks));
            }
            from = to;
        }
    }
    return parts;
}

}  // namespace bspline_curve
