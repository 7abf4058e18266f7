// SPDX-License-Identifier: GPL-3.0-or-later
#include "offset/fitted_line.h"

#include "bspline_curve/options.h"
#include "bspline_curve/progress.h"
#include "bspline_curve/spline.h"
#include "design/spline_data.h"
#include "design/strict_polyline.h"
#include "projection/fibre_tracer.h"
#include "projection/projected_curve.h"
#include "solver/curve_problem.h"
#include "solver/initial_curve.h"
#include "solver/spline_fit.h"
#include "surface/strict_line.h"
#include "surface/surface_point.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace bspline_curve {

namespace {

constexpr int kDegree = 3;
/// The first spans are about so many distances long.
constexpr double kFirstSpan = 2.0;
/// Closed splines need so many spans.
constexpr int kFewestSpans = kDegree + 1;
constexpr int kMostFirstSpans = 64;
/// No span is shorter than so many distances: it rounds a turn of 20 degrees to 1e-4.
constexpr double kShortestSpan = 2e-3;
/// More than any line needs: next to creases spans are halved one by one.
constexpr int kMostFits = 60;
/// No spline has more spans per vertex of its line, or per first span.
constexpr std::size_t kMostSpans = 2;
/// Vertices of the polyline are at most so many distances apart: arcs of that radius are then
/// within 1e-4 of their chords.
constexpr double kVertexStep = 0.025;
/// Where a chord cuts off too much of a bend, which the line has behind vertices of the mesh, so
/// many take its place.
constexpr int kChordParts = 8;

/// One line, and the splines that are tried for it.
class Fitting {
public:
    Fitting(
        const Surface& surface,
        const ExtendedSurface& extended,
        const DistanceBeams& beams,
        double distance,
        const SurfacePolyline& line
    )
        : surface_(surface), extended_(extended), beams_(beams), distance_(distance), line_(line) {
        const auto add = [&](double t, std::size_t i) {
            path_.points.push_back(
                {t, line.surfacePoints[i], extended.position(line.surfacePoints[i])}
            );
        };
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            add(line.parameters[i], i);
        }
        if (line.closed) {
            add(1.0, 0);
        }
        problem_.extended = &extended;
        problem_.options.closed = line.closed;
        problem_.options.degree = kDegree;
        problem_.averageEdgeLength = surface.averageEdgeLength() / extended.frame.scale;
        problem_.distanceTolerance =
            problem_.options.distanceTolerance * problem_.averageEdgeLength;
        problem_.picks.push_back(pickOf(path_.points.front(), 0.0));
        if (!line.closed) {
            problem_.picks.push_back(pickOf(path_.points.back(), 1.0));
        }
    }

    /// Nothing where no spline stays within the tolerance.
    std::optional<FittedLine> fit(double tolerance, const Progress& progress) {
        std::vector<double> breaks = firstBreaks();
        const std::size_t most =
            kMostSpans * std::max<std::size_t>(line_.points.size(), breaks.size());
        for (int attempt = 0; attempt < kMostFits && breaks.size() <= most; ++attempt) {
            report(progress, 1.0 - 1.0 / (1.0 + attempt), "fitting a spline");
            const SplineSpace space(kDegree, line_.closed, breaks);
            std::vector<SpanTarget> targets;
            for (int span = 0; span < space.spanCount(); ++span) {
                targets.emplace_back(path_, breaks[span], breaks[span + 1]);
            }
            const SplineCurve curve{space, fitSpline(problem_, space, targets)};
            isFar_.assign(space.spanCount(), 0);
            std::optional<SurfacePolyline> projected = project(curve, tolerance);
            if (projected) {
                markFar(space, *projected, tolerance);
            } else {
                markLoose(curve, targets);
            }
            if (projected && std::ranges::find(isFar_, 1) == isFar_.end()) {
                return result(curve, std::move(*projected));
            }
            if (!halveFar(breaks)) {
                break;
            }
        }
        return std::nullopt;
    }

    [[nodiscard]] double deviationOf(const SurfacePolyline& line) const {
        double worst = 0.0;
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            worst = std::max(worst, errorFrom(line, i));
        }
        return worst;
    }

private:
    [[nodiscard]] PickConstraint pickOf(const InitialPath::Point& point, double t) const {
        return {.point = point.point, .position = point.position, .parameter = t};
    }

    [[nodiscard]] double lengthOfLine() const {
        double length = 0.0;
        for (std::size_t i = 1; i < path_.points.size(); ++i) {
            length += (path_.points[i].position - path_.points[i - 1].position).norm();
        }
        return length * extended_.frame.scale;
    }

    [[nodiscard]] std::vector<double> firstBreaks() const {
        const double wanted = std::ceil(lengthOfLine() / (kFirstSpan * distance_));
        const int spans =
            static_cast<int>(std::clamp(wanted, 1.0 * kFewestSpans, 1.0 * kMostFirstSpans));
        std::vector<double> breaks;
        for (int i = 0; i <= spans; ++i) {
            breaks.push_back(static_cast<double>(i) / spans);
        }
        return breaks;
    }

    /// Nothing where the spline leaves the surface, whose span is then marked.
    std::optional<SurfacePolyline> project(const SplineCurve& curve, double tolerance) {
        const auto& [space, controls] = curve;
        CurveDistance distance = measureAlongFibres(
            {.extended = extended_,
             .picks = problem_.picks,
             .tolerance = problem_.distanceTolerance},
            space,
            controls
        );
        const TraceProgress& progress = progressOf(distance.trace);
        if (!progress.isWhole) {
            isFar_[std::min(progress.wholeSpans, space.spanCount() - 1)] = 1;
            return std::nullopt;
        }
        for (int span = 0; span < space.spanCount(); ++span) {
            if (!(distance.perSpan[span] < problem_.distanceTolerance)) {
                isFar_[span] = 1;
            }
        }
        if (!std::isfinite(distance.largest)) {
            return std::nullopt;
        }
        const ProjectedCurve shadow(extended_, nullptr, space, controls, std::move(distance.trace));
        const FairedShadow faired(problem_, shadow);
        SamplingOptions sampling;
        sampling.maxSegmentLength = kVertexStep * distance_;
        sampling.samples = 0;
        const SurfacePolyline projected = makeStrictPolyline(surface_, problem_, faired, sampling);
        if (!isStrict(surface_, projected)) {
            isFar_.assign(space.spanCount(), 1);
            return std::nullopt;
        }
        return withFineChords(faired, projected, tolerance);
    }

    /// With vertices of the spline's between those of segments whose chords alone are off.
    [[nodiscard]] SurfacePolyline withFineChords(
        const FairedShadow& shadow, const SurfacePolyline& line, double tolerance
    ) const {
        SurfacePolyline finer;
        finer.closed = line.closed;
        const auto add = [&](double t, const SurfacePoint& point) {
            finer.parameters.push_back(t);
            finer.surfacePoints.push_back(point);
            finer.points.push_back(surface_.position(point));
        };
        const std::size_t count = line.points.size();
        for (std::size_t i = 0; i < count; ++i) {
            add(line.parameters[i], line.surfacePoints[i]);
            if (i + 1 == count && !line.closed) {
                break;
            }
            const SurfacePoint& next = line.surfacePoints[(i + 1) % count];
            const double end = i + 1 == count ? 1.0 : line.parameters[i + 1];
            if (errorAt(line.surfacePoints[i]) > tolerance || errorAt(next) > tolerance ||
                errorAt(middleOf(line.surfacePoints[i], next)) <= tolerance) {
                continue;
            }
            for (int k = 1; k < kChordParts; ++k) {
                const double t = std::lerp(line.parameters[i], end, 1.0 * k / kChordParts);
                const SurfacePoint between = snapped(shadow.at(t), kSnapBarycentric);
                if (commonFace(surface_, finer.surfacePoints.back(), between) >= 0 &&
                    commonFace(surface_, between, next) >= 0) {
                    add(t, between);
                }
            }
        }
        return finer;
    }

    /// Marks spans with vertices or middles of segments that are off the distance.
    void markFar(const SplineSpace& space, const SurfacePolyline& projected, double tolerance) {
        for (std::size_t i = 0; i < projected.points.size(); ++i) {
            const int span = space.spanAt(std::clamp(projected.parameters[i], 0.0, 1.0));
            if (isFar_[span] == 0 && errorFrom(projected, i) > tolerance) {
                isFar_[span] = 1;
            }
        }
    }

    /// Marks spans that are far from the line in space, where no trace tells more.
    void markLoose(const SplineCurve& curve, const std::vector<SpanTarget>& targets) {
        for (int span = 0; span < curve.space.spanCount(); ++span) {
            const PolynomialCurve part = curve.space.polynomial(curve.controls, span);
            for (int i = 0; i < SpanTarget::kSamples; ++i) {
                const Vec3 gap = part.at(SpanTarget::tau(i)) - targets[span].positions[i];
                if (gap.norm() > problem_.distanceTolerance) {
                    isFar_[span] = 1;
                }
            }
        }
    }

    [[nodiscard]] bool halveFar(std::vector<double>& breaks) const {
        const double shortest = kShortestSpan * distance_ / lengthOfLine();
        std::vector<double> finer{breaks.front()};
        for (std::size_t span = 0; span + 1 < breaks.size(); ++span) {
            if (isFar_[span] != 0) {
                if (0.5 * (breaks[span + 1] - breaks[span]) < shortest) {
                    return false;
                }
                finer.push_back(0.5 * (breaks[span] + breaks[span + 1]));
            }
            finer.push_back(breaks[span + 1]);
        }
        breaks.swap(finer);
        return true;
    }

    [[nodiscard]] double errorAt(const SurfacePoint& point) const {
        return std::abs(beams_.at(point).distance - distance_) / distance_;
    }

    /// The larger of a vertex's and that of the middle of the segment from it.
    [[nodiscard]] double errorFrom(const SurfacePolyline& line, std::size_t i) const {
        const double atVertex = errorAt(line.surfacePoints[i]);
        const std::size_t count = line.points.size();
        if (i + 1 == count && !line.closed) {
            return atVertex;
        }
        const SurfacePoint& next = line.surfacePoints[(i + 1) % count];
        return std::max(atVertex, errorAt(middleOf(line.surfacePoints[i], next)));
    }

    /// Of two points that share a face.
    [[nodiscard]] SurfacePoint middleOf(const SurfacePoint& a, const SurfacePoint& b) const {
        const int face = commonFace(surface_, a, b);
        const Vec3 from = inFace(surface_, a, face).barycentric;
        const Vec3 to = inFace(surface_, b, face).barycentric;
        return {.face = face, .barycentric = 0.5 * (from + to)};
    }

    [[nodiscard]] FittedLine result(const SplineCurve& curve, SurfacePolyline projected) const {
        FittedLine fitted{
            .line = std::move(projected),
            .spline = splineDataOf(curve, extended_.frame, {}),
            .deviation = 0.0,
            .isFitted = true
        };
        fitted.line.picks.clear();
        fitted.deviation = deviationOf(fitted.line);
        return fitted;
    }

    const Surface& surface_;
    const ExtendedSurface& extended_;
    const DistanceBeams& beams_;
    double distance_;
    const SurfacePolyline& line_;
    InitialPath path_;
    CurveProblem problem_;
    std::vector<char> isFar_;  // of each span
};

}  // namespace

SplineData polygonSpline(const SurfacePolyline& line) {
    SplineData spline;
    spline.degree = 1;
    spline.closed = line.closed;
    spline.controlPoints = line.points;
    const std::vector<double>& t = line.parameters;
    spline.knots.push_back(line.closed ? t.back() - 1.0 : t.front());
    spline.knots.insert(spline.knots.end(), t.begin(), t.end());
    spline.knots.push_back(1.0);
    if (line.closed) {
        spline.controlPoints.push_back(line.points.front());
        spline.knots.push_back(1.0 + t[1]);
    }
    return spline;
}

FittedLine LineFitter::fitted(
    const SurfacePolyline& line, double tolerance, const Progress& progress
) const {
    Fitting fitting(surface_, extended_, beams_, distance_, line);
    std::optional<FittedLine> found = fitting.fit(tolerance, progress);
    return found ? std::move(*found) : unfitted(line);
}

FittedLine LineFitter::unfitted(const SurfacePolyline& line) const {
    const Fitting fitting(surface_, extended_, beams_, distance_, line);
    return {
        .line = line,
        .spline = polygonSpline(line),
        .deviation = fitting.deviationOf(line),
        .isFitted = false
    };
}

}  // namespace bspline_curve
