// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/fitted_curve.h"

#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "design/curve_solver.h"
#include "design/fitted_path.h"
#include "design/solved_curve.h"
#include "surface/error_messages.h"
#include "surface/segment_distance.h"
#include "surface/strict_line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

struct FitConstants {
    /// Of the deviation: the root of the mean square distance that is aimed at. Of some hundred
    /// points that are off at random the farthest is three times as far.
    double spreadShare = 0.23;
    /// The first guess of the waves that are flattened, in deviations; of a line whose noise is not
    /// known, in mean distances of its points. Steps along mesh edges have waves of up to a dozen.
    double wavelength = 10.0, wavelengthOfPoints = 12.0;
    /// Longer pieces of the line, in deviations, count as several points; shorter ones than
    /// `wholePiece` count less, so that it hardly matters how densely a line is sampled.
    double longestPiece = 8.0, wholePiece = 0.5;
    /// The shortest waves that may be flattened: of a line that turns at far points, in deviations;
    /// else in mean distances of its points.
    double shortestWave = 4.0, shortestWaveOfPoints = 2.0;
    /// In average edge lengths: smaller deviations count as this one here. Splines are as far from
    /// the surface.
    double leastDeviation = 0.1;
    /// Of the length of the line: longer waves are not flattened.
    double longestWave = 2.0;
    /// Picks of a wavelength.
    double picksOfWave = 3.0;
    int leastPicks = 4;
    /// The solver's time grows with the third power of these.
    int mostPicks = 200;
    /// Where the curve is too far from the line, by which the spread shrinks; so many times.
    double shrinking = 0.6;
    int mostFits = 6;
    /// Of the deviation, on both sides of the place where a point of the curve was nearest to the
    /// line: the next one is looked for there.
    double lookAround = 6.0;
};

constexpr FitConstants kFit;

/// How far the points of a polyline are from a line, each from the part of it that is near to
/// where the one before was nearest; that is the distance, or above it.
class DistanceAlong {
public:
    DistanceAlong(std::span<const Vec3> line, bool closed, double reach)
        : line_(line), closed_(closed), reach_(reach) {}

    [[nodiscard]] double largest(std::span<const Vec3> points) {
        place_ = nearestOf(points.front(), 0, count() - 1).segment;
        double largest = 0.0;
        for (const Vec3& point : points) {
            const Nearest nearest = nearestOf(point, back(), ahead());
            place_ = nearest.segment;
            largest = std::max(largest, nearest.distance);
        }
        return largest;
    }

private:
    struct Nearest {
        double distance;
        std::ptrdiff_t segment;
    };

    [[nodiscard]] std::ptrdiff_t count() const { return std::ssize(line_) - (closed_ ? 0 : 1); }

    [[nodiscard]] const Vec3& at(std::ptrdiff_t i) const {
        const std::ptrdiff_t size = std::ssize(line_);
        return line_[static_cast<std::size_t>(((i % size) + size) % size)];
    }

    // The segments that are as far from the place as is looked at.
    [[nodiscard]] std::ptrdiff_t back() const {
        std::ptrdiff_t segment = place_;
        double way = 0.0;
        while (way < reach_ && (closed_ ? place_ - segment + 1 < count() : segment > 0)) {
            --segment;
            way += (at(segment + 1) - at(segment)).norm();
        }
        return segment;
    }

    [[nodiscard]] std::ptrdiff_t ahead() const {
        std::ptrdiff_t segment = place_;
        double way = 0.0;
        while (way < reach_ && segment - place_ + 1 < count() &&
               (closed_ || segment + 1 < count())) {
            ++segment;
            way += (at(segment + 1) - at(segment)).norm();
        }
        return segment;
    }

    [[nodiscard]] Nearest nearestOf(
        const Vec3& point, std::ptrdiff_t first, std::ptrdiff_t last
    ) const {
        Nearest best{std::numeric_limits<double>::infinity(), first};
        for (std::ptrdiff_t i = first; i <= last; ++i) {
            const double distance = distanceToSegment(point, at(i), at(i + 1));
            if (distance < best.distance) {
                best = {distance, i};
            }
        }
        best.segment = closed_ ? ((best.segment % count()) + count()) % count() : best.segment;
        return best;
    }

    std::span<const Vec3> line_;
    bool closed_;
    double reach_;
    std::ptrdiff_t place_ = 0;
};

class LineFitter {
public:
    LineFitter(const LocatedTask& task, double deviation, bool isNoiseKnown)
        : task_(task),
          scale_(task.prepared.extended()->frame.scale),
          deviation_(deviation),
          bound_(
              std::max(
                  deviation, kFit.leastDeviation * task.prepared.surface().averageEdgeLength()
              ) /
              scale_
          ),
          isNoiseKnown_(isNoiseKnown),
          line_{.path = {}, .closed = task.options.closed, .points = {}} {
        PickPath line = task.solver().quickPath();
        line_.path = std::move(line.path);
        for (const InitialPath::Point& point : line_.path.points) {
            positions_.push_back(task.prepared.surface().position(point.point));
        }
        if (line_.closed) {
            positions_.pop_back();
        }
        measure(line.picks);
    }

    [[nodiscard]] NearCurve fit(const Progress& progress) {
        double spread = kFit.spreadShare * deviation_ / scale_;
        double nearest = std::numeric_limits<double>::infinity();
        for (int i = 0; i < kFit.mostFits; ++i) {
            report(progress, static_cast<double>(i) / kFit.mostFits, "smoothing the line");
            if (const std::optional<FittedPath> fitted = pathWithin(spread)) {
                std::optional<NearCurve> drawn =
                    drawAlong(*fitted, stepOf(progress, i, kFit.mostFits));
                if (drawn && drawn->curve.report.usable) {
                    const double farthest =
                        DistanceAlong(
                            positions_, task_.options.closed, kFit.lookAround * deviation_
                        )
                            .largest(drawn->curve.polyline.points);
                    if (farthest <= deviation_) {
                        drawn->curve.report.lineDistance = farthest;
                        return *std::move(drawn);
                    }
                    nearest = std::min(nearest, farthest);
                }
                spread = std::min(spread, fitted->spread);
            }
            spread *= kFit.shrinking;
        }
        const std::string found = std::isfinite(nearest)
                                      ? "; one within " + describeLength(nearest) + " was"
                                      : std::string();
        throw InputError(
            InputErrorCode::NoPath,
            "no smooth curve was found within " + describeLength(deviation_) + " of the line" +
                found + ": allow a larger deviation"
        );
    }

private:
    // The points that the line is known by: the middles of its pieces, which steps from one side to
    // the other disturb less than its vertices.
    void measure(const std::vector<PickConstraint>& vertices) {
        const bool closed = line_.closed;
        const double length = line_.path.length();
        const std::size_t legs = vertices.size() - (closed ? 0 : 1);
        for (std::size_t i = 0; i < legs; ++i) {
            const double from = vertices[i].parameter;
            const double to = i + 1 < vertices.size() ? vertices[i + 1].parameter : 1.0;
            const double piece = (to - from) * length;
            const auto pieces =
                std::max(1, static_cast<int>(std::ceil(piece / (kFit.longestPiece * bound_))));
            const double weight = std::min(1.0, piece / (kFit.wholePiece * bound_));
            for (int k = 0; k < pieces; ++k) {
                const double parameter = std::lerp(from, to, (k + 0.5) / pieces);
                line_.points.push_back({parameter, line_.path.positionAt(parameter), weight});
            }
        }
    }

    [[nodiscard]] std::optional<FittedPath> pathWithin(double spread) const {
        const double length = line_.path.length();
        const double step = length / static_cast<double>(task_.picks.size());
        const double longest =
            isNoiseKnown_ ? kFit.longestWave * length : kFit.wavelengthOfPoints * step;
        const double shortest =
            std::min({longest, kFit.shortestWave * bound_, kFit.shortestWaveOfPoints * step});
        const double first = isNoiseKnown_ ? kFit.wavelength * bound_ : longest;
        return fittedPath(
            *task_.prepared.extended(),
            &task_.prepared.patches(),
            line_,
            {spread, std::clamp(first, shortest, longest), shortest, longest}
        );
    }

    // The spline and its polyline along a path, through points of it.
    [[nodiscard]] std::optional<NearCurve> drawAlong(
        const FittedPath& fitted, const Progress& progress
    ) const {
        const PickPath path = withPicks(fitted);
        std::vector<SurfacePoint> points;
        for (const PickConstraint& pick : path.picks) {
            points.push_back(pick.point);
        }
        const LocatedTask same = {
            task_.prepared, points, task_.options, task_.sampling, task_.context, task_.side
        };
        std::vector<int> all(path.picks.size());
        std::iota(all.begin(), all.end(), 0);
        std::optional<Solved> solved = same.solver().solveAlong(path, all, progress);
        if (!solved) {
            return std::nullopt;
        }
        NearCurve drawn{{}, *std::move(solved)};
        drawn.curve = curveOf(task_.prepared.surface(), drawn.solved, task_.sampling);
        return isStrict(task_.prepared.surface(), drawn.curve.polyline)
                   ? std::optional(std::move(drawn))
                   : std::nullopt;
    }

    // Evenly among the nodes of the path, which are evenly spaced.
    [[nodiscard]] PickPath withPicks(const FittedPath& fitted) const {
        PickPath path{fitted.path, {}};
        const auto& points = path.path.points;
        const auto segments = static_cast<int>(points.size()) - 1;
        const double waves = path.path.length() / fitted.wavelength;
        const int count = std::clamp(
            static_cast<int>(std::lround(kFit.picksOfWave * waves)),
            kFit.leastPicks,
            std::min(segments, kFit.mostPicks)
        );
        for (int i = 0; i < count + (task_.options.closed ? 0 : 1); ++i) {
            const auto& node = points[static_cast<std::size_t>(i) * segments / count];
            path.picks.push_back({node.point, node.position, node.parameter});
        }
        return path;
    }

    LocatedTask task_;
    double scale_;
    double deviation_;  // user's unit
    double bound_;      // by which waves and pieces are measured, in the shell's frame
    bool isNoiseKnown_;
    MeasuredLine line_;
    std::vector<Vec3> positions_;  // of the line, user's unit
};

}  // namespace

NearCurve fitLine(
    const LocatedTask& line, double deviation, bool isNoiseKnown, const Progress& progress
) {
    return LineFitter(line, deviation, isNoiseKnown).fit(progress);
}

}  // namespace bspline_curve
