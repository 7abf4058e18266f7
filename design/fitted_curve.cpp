// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/fitted_curve.h"

#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "design/curve_sections.h"
#include "design/curve_solver.h"
#include "design/fitted_path.h"
#include "design/line_points.h"
#include "design/path_spline.h"
#include "design/solved_curve.h"
#include "surface/segment_distance.h"
#include "surface/strict_line.h"
#include "text/error_messages.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>
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
    /// points that are off at random the farthest is three times as far; and a line that is off by
    /// a quarter is met better where less of its own shape is flattened with that.
    double spreadShare = 0.185;
    /// The same of a line along edges of the mesh, whose points are known better: see
    /// findLinePoints().
    double spreadShareOfEdges = 0.155;
    /// The first guess of the waves that are flattened, in deviations; of a line whose noise is not
    /// known, in mean distances of its points. Steps along mesh edges have waves of up to a dozen.
    double wavelength = 10.0, wavelengthOfPoints = 12.0;
    /// Longer pieces of the line, in deviations, count as several points; shorter ones than
    /// `wholePiece` count less, so that it hardly matters how densely a line is sampled.
    double longestPiece = 8.0, wholePiece = 0.5;
    /// The shortest waves that may be flattened: of a line that turns at far points, in deviations;
    /// else in mean distances of its points.
    double shortestWave = 4.0, shortestWaveOfPoints = 2.0;
    /// Of the deviation: points that are nearer to each other than this count as so far apart in
    /// what is said of points here.
    double leastStep = 0.125;
    /// Means of a line's vertices by which its length is measured are no farther apart, in
    /// deviations; and a line that has this share of its length along them does not tremble.
    double blockStep = 0.5, straightShare = 0.95;
    /// In mean distances of points: see FitTarget::cornerWave.
    double cornerWave = 12.0;
    /// In deviations: shorter waves are flattened whatever is left of the spread, unless the curve
    /// then comes too far from the line. Else a line that trembles by a third of the deviation,
    /// and is known by many points, would keep its trembling.
    double leastWave = 2.0;
    /// In average edge lengths: smaller deviations count as this one here. Splines are as far from
    /// the surface.
    double leastDeviation = 0.1;
    /// Of the length of the line: longer waves are not flattened.
    double longestWave = 2.0;
    /// How far the spline may be from the smooth path, at most: of the spread; and at least and at
    /// most, of the deviation. With a third of these it has half as many knots more, and is no
    /// nearer to what was meant.
    double wayOfSpread = 0.6, leastWay = 0.01, mostWay = 0.15;
    /// How far the spline may be from the surface, of the deviation, where that is more than the
    /// distance tolerance.
    double height = 0.1;
    /// Of that, how far the chords of the path may be.
    double chordShare = 0.2;
    /// No span is shorter, in deviations.
    double shortestSpan = 0.01;
    /// Where the curve is too far from the line, by which the spread shrinks; so many times.
    double shrinking = 0.6;
    int mostFits = 6;
    /// Of the deviation, on both sides of the place where a point of the curve was nearest to the
    /// line: the next one is looked for there.
    double lookAround = 6.0;
};

constexpr FitConstants kFit;

constexpr double kDegree = std::numbers::pi / 180.0;

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

// How many times longer a line is than along means of so many consecutive vertices as make it no
// shorter, or are `distance` apart: 1 where it does not tremble.
double tremblingOf(const InitialPath& path, double distance) {
    std::vector<Vec3> chain;
    for (const InitialPath::Point& point : path.points) {
        chain.push_back(point.position);
    }
    const auto lengthOfChain = [](const std::vector<Vec3>& points) {
        double length = 0.0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            length += (points[i] - points[i - 1]).norm();
        }
        return length;
    };
    const double whole = lengthOfChain(chain);
    double length = whole;
    while (length < distance * static_cast<double>(chain.size())) {
        std::vector<Vec3> coarser = {chain.front()};
        for (std::size_t i = 1; i + 2 < chain.size(); i += 2) {
            coarser.emplace_back(0.5 * (chain[i] + chain[i + 1]));
        }
        coarser.push_back(chain.back());
        const double shorter = lengthOfChain(coarser);
        if (shorter > kFit.straightShare * length || !(shorter > 0.0)) {
            break;
        }
        chain = std::move(coarser);
        length = shorter;
    }
    return length > 0.0 ? whole / length : 1.0;
}

class LineFitter {
public:
    LineFitter(const LocatedTask& task, const FitOptions& fit)
        : task_(task),
          fit_(fit),
          scale_(task.prepared.extended()->frame.scale),
          deviation_(isNoiseKnown() ? fit.deviation.in(edge()) : edge()),
          bound_(std::max(deviation_, kFit.leastDeviation * edge()) / scale_),
          line_{.path = {}, .closed = task.options.closed, .points = {}} {
        PickPath line = task.solver().quickPath();
        line_.path = std::move(line.path);
        trembling_ = tremblingOf(line_.path, kFit.blockStep * bound_);
        for (const InitialPath::Point& point : line_.path.points) {
            positions_.push_back(task.prepared.surface().position(point.point));
        }
        if (line_.closed) {
            positions_.pop_back();
        }
        const double alongEdges = findLinePoints(
            task.prepared.surface(),
            *task.prepared.extended(),
            line.picks,
            {kFit.longestPiece * bound_, kFit.wholePiece * bound_},
            line_
        );
        spreadShare_ = std::lerp(kFit.spreadShare, kFit.spreadShareOfEdges, alongEdges);
    }

    [[nodiscard]] Curve fit(const Progress& progress) {
        double spread = spreadShare_ * deviation_ / scale_;
        double share = 1.0;
        double nearest = std::numeric_limits<double>::infinity();
        for (int i = 0; i < kFit.mostFits; ++i) {
            const Progress step = stepOf(progress, i, kFit.mostFits);
            report(step, 0.0, "smoothing the line");
            if (const std::optional<FittedPath> fitted = pathWithin(spread, share)) {
                if (std::optional<Curve> drawn = drawAlong(*fitted, step)) {
                    const double farthest =
                        DistanceAlong(
                            positions_, line_.closed, kFit.lookAround * trembling_ * deviation_
                        )
                            .largest(drawn->polyline.points);
                    if (farthest <= deviation_) {
                        drawn->report.lineDistance = farthest;
                        return *std::move(drawn);
                    }
                    nearest = std::min(nearest, farthest);
                }
                spread = std::min(spread, fitted->spread);
            }
            spread *= kFit.shrinking;
            share *= kFit.shrinking;
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
    [[nodiscard]] bool isNoiseKnown() const { return fit_.deviation.value > 0.0; }

    [[nodiscard]] double normalShare() const {
        return task_.options.bending == Bending::Ambient ? 1.0 : task_.options.normalBendingWeight;
    }

    [[nodiscard]] double edge() const { return task_.prepared.surface().averageEdgeLength(); }

    // `share`: of the usual least wavelength.
    [[nodiscard]] std::optional<FittedPath> pathWithin(double spread, double share) const {
        const double length = line_.path.length();
        const double step = std::max(
            length / static_cast<double>(task_.picks.size()), kFit.leastStep * trembling_ * bound_
        );
        const double longest =
            isNoiseKnown() ? kFit.longestWave * length : kFit.wavelengthOfPoints * step;
        const double shortest = std::min(
            longest,
            std::max(
                kFit.leastWave * share * trembling_ * bound_,
                std::min(kFit.shortestWave * bound_, kFit.shortestWaveOfPoints * step)
            )
        );
        const double first = isNoiseKnown() ? kFit.wavelength * bound_ : longest;
        return fittedPath(
            *task_.prepared.extended(),
            &task_.prepared.patches(),
            line_,
            {.spread = spread,
             .wavelength = std::clamp(first, shortest, longest),
             .shortest = shortest,
             .longest = longest,
             .stiffness = {task_.options.tension, normalShare()},
             .cornerAngle = fit_.cornerAngle * kDegree,
             .cornerWave = kFit.cornerWave * step,
             .chordDistance = kFit.chordShare * kFit.height * bound_}
        );
    }

    // The spline and its polyline along a path; nothing where there is none on the surface.
    [[nodiscard]] std::optional<Curve> drawAlong(
        const FittedPath& fitted, const Progress& progress
    ) const {
        const std::size_t count = fitted.sections.size();
        const bool isWhole = count == 1 && fitted.turns.empty();
        std::vector<DrawnSection> drawn;
        int points = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const bool isRound = line_.closed && isWhole;
            std::optional<Curve> section =
                drawSection(fitted.sections[i], isRound, fitted.spread, stepOf(progress, i, count));
            if (!section) {
                return std::nullopt;
            }
            const auto own = static_cast<int>(section->polyline.picks.size());
            std::vector<int> indices(section->polyline.picks.size());
            std::iota(indices.begin(), indices.end(), points);
            points += own - 1;
            drawn.push_back({std::move(indices), *std::move(section)});
        }
        if (isWhole) {
            return std::move(drawn.front().curve);
        }
        if (line_.closed) {
            drawn.back().points.back() = 0;
        }
        Curve curve = joinedCurve(drawn, line_.closed);
        for (const double turn : fitted.turns) {
            curve.report.cornerTurns.push_back(turn / kDegree);
        }
        return curve;
    }

    [[nodiscard]] std::optional<Curve> drawSection(
        const InitialPath& path, bool isRound, double spread, const Progress& progress
    ) const {
        CurveProblem problem = problemAlong(path, isRound);
        problem.progress = progress;
        const double way =
            std::clamp(kFit.wayOfSpread * spread, kFit.leastWay * bound_, kFit.mostWay * bound_);
        std::optional<Solution> solution = splineAlong(task_.prepared, problem, path, way);
        if (!solution) {
            return std::nullopt;
        }
        problem.progress = {};
        problem.nearParameters = picksOf(solution->curve.space);
        const Surface& surface = task_.prepared.surface();
        Solved solved{std::move(problem), *std::move(solution)};
        Curve curve = curveOf(surface, solved, task_.sampling);
        curve.report.allowedDistance =
            solved.problem.distanceTolerance / solved.problem.averageEdgeLength;
        return isStrict(surface, curve.polyline) ? std::optional(std::move(curve)) : std::nullopt;
    }

    [[nodiscard]] CurveProblem problemAlong(const InitialPath& path, bool isRound) const {
        const auto pickAt = [](const InitialPath::Point& point) {
            return PickConstraint{
                .point = point.point, .position = point.position, .parameter = point.parameter
            };
        };
        std::vector<PickConstraint> ends = {pickAt(path.points.front())};
        if (!isRound) {
            ends.push_back(pickAt(path.points.back()));
        }
        SolverOptions options = task_.options;
        options.closed = isRound;
        const double length = path.length();
        options.minimumSpan = std::min(options.minimumSpan, kFit.shortestSpan * bound_ / length);
        CurveProblem problem = makeProblem(task_.prepared, options, std::move(ends));
        problem.chordLength = length;
        problem.distanceTolerance = std::max(problem.distanceTolerance, kFit.height * bound_);
        return problem;
    }

    // By which the curve is described: a spline on the same knots is known by its points at these,
    // and an open one by one more beside each end.
    [[nodiscard]] static std::vector<double> picksOf(const SplineSpace& space) {
        std::vector<double> parameters = space.breaks();
        if (space.closed()) {
            parameters.pop_back();
            return parameters;
        }
        const auto between = [&](std::size_t i) {
            return 0.5 * (parameters[i] + parameters[i + 1]);
        };
        const std::size_t count = parameters.size();
        const double second = between(0);
        const double last = between(count - 2);
        if (count == 2) {
            return {0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0};
        }
        parameters.insert(parameters.end() - 1, last);
        parameters.insert(parameters.begin() + 1, second);
        return parameters;
    }

    LocatedTask task_;
    const FitOptions& fit_;
    double scale_;
    double deviation_;  // user's unit
    double bound_;      // by which waves and pieces are measured, in the shell's frame
    MeasuredLine line_;
    double spreadShare_;           // of the deviation
    double trembling_ = 1.0;       // see tremblingOf()
    std::vector<Vec3> positions_;  // of the line, user's unit
};

}  // namespace

Curve fitLine(const LocatedTask& line, const FitOptions& fit, const Progress& progress) {
    return LineFitter(line, fit).fit(progress);
}

}  // namespace bspline_curve
