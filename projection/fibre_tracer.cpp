// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/fibre_tracer.h"

#include "projection/face_fibres.h"
#include "projection/fibre_exit.h"
#include "surface/surface_point.h"
#include "utility/infinity.h"
#include "utility/worker_thread.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace bspline_curve {
namespace {

// A walk that turns this often on so small a share of a span goes round in a circle. Where fibres
// cross, two faces may hand it back and forth, by 1e-14 of the span at a time.
constexpr int kMaxStalled = 128;
constexpr double kStalledShare = 1e-7;
// And one that crosses more faces of a span than this many times all that there are.
constexpr std::size_t kMaxRounds = 2;
// A curve passes a pick where it is so near to the surface, in diagonals: a hundred times the
// rounding of heights, and a thousandth of the thinnest plate whose sides are told apart.
constexpr double kAtPick = 1e-12;

// Whether a foot is that of a pick, not one on another sheet, such as the other side of a plate.
bool isAt(const ExtendedSurface& extended, const PickConstraint& pick, const FootPoint& foot) {
    return std::abs(foot.height) <= kAtPick &&
           std::ranges::any_of(extended.faces[foot.face], [&](int v) {
               return cornerOf(extended.faces[pick.point.face], extended.surfaceVertex(v)) >= 0;
           });
}

// Follows the foot of a spline from the start of a span on.
class FibreTracer {
public:
    // `start`: the foot there, or near it on the same face; sets the distances of spans passed.
    FibreTracer(
        const ExtendedSurface& extended,
        const SplineSpace& space,
        const ControlPoints& controls,
        int span,
        const FootPoint& start,
        std::vector<double>& distances
    )
        : extended_(extended),
          space_(space),
          controls_(controls),
          distances_(distances),
          fibres_(extended, start.face),
          firstFace_(start.face),
          span_(span) {
        here_.position = space.polynomial(controls, span).coefficients[0];
        here_.foot = start;
        isLost_ =
            fibres_.find<FaceFibres::Search::Exact>(here_.position, here_.foot, here_.frame) !=
            FaceFibres::Outcome::Found;
    }

    // On to the start of a later span, or where the fibres end.
    void passUntil(int end) {
        while (!isLost_ && span_ < end) {
            isLost_ = !passSpan(span_);
            if (isLost_) {
                distances_[span_] = kInfinity;
            } else {
                ++span_;
            }
        }
    }

    // Whether it stands where another one has begun: a point has one foot in a face.
    [[nodiscard]] bool isWhereBegan(const FibreTracer& other) const {
        return !isLost_ && here_.foot.face == other.firstFace_;
    }

    // Goes on as another one has that began here, to its end.
    void follow(const FibreTracer& other) {
        const auto append = [](auto& to, const auto& from) {
            to.insert(to.end(), from.begin(), from.end());
        };
        append(trace_.crossings, other.trace_.crossings);
        append(trace_.pieces, other.trace_.pieces);
        span_ = other.span_;
        isLost_ = other.isLost_;
    }

    [[nodiscard]] FibreTrace trace() && {
        trace_.wholeSpans = span_;
        trace_.isWhole = span_ == space_.spanCount();
        return std::move(trace_);
    }

private:
    // Takes the fibres of the face that is here now.
    bool enter() {
        fibres_ = FaceFibres(extended_, here_.foot.face);
        return fibres_.frameAt(here_.foot, here_.frame);
    }

    bool passSpan(int span) {
        const PolynomialCurve curve = space_.polynomial(controls_, span);
        double& farthest = distances_[span];
        farthest = 0.0;
        here_.along = curve.coefficients[1];
        double tau = 0.0;
        double advanced = 0.0;
        int stalled = 0;  // crossings since then
        const std::size_t before = trace_.crossings.size();
        while (trace_.crossings.size() - before <= kMaxRounds * extended_.faces.size()) {
            farthest = std::max(farthest, distanceOf(here_));
            const std::optional<FibreExit> exit = findExit(fibres_, curve, tau, here_, there_);
            if (!exit) {
                return false;
            }
            if (exit->tau > tau) {
                const FibrePlace middle = middleOf(curve, tau, exit->tau);
                farthest = std::max(farthest, distanceOf(middle));
                trace_.pieces.push_back({parameter(span, exit->tau), span, middle.foot});
            }
            if (exit->tau > advanced + kStalledShare) {
                advanced = exit->tau;
                stalled = 0;
            } else if (++stalled > kMaxStalled) {
                return false;
            }
            tau = exit->tau;
            std::swap(here_, there_);
            if (exit->wall < 0) {
                farthest = std::max(farthest, distanceOf(here_));
                return true;
            }
            const int next = extended_.faceNeighbours[here_.foot.face][exit->wall];
            if (next < 0) {
                return false;
            }
            Vec3 onWall = here_.foot.barycentric();
            onWall[exit->wall] = 0.0;
            trace_.crossings.push_back(
                {parameter(span, tau), onSurface(extended_, here_.foot.face, onWall)}
            );
            carryOver(extended_, exit->wall, next, here_.foot);
            if (!enter()) {
                return false;
            }
        }
        return false;
    }

    // Half way to there_ on this face, without a search: by values and derivatives at both ends.
    [[nodiscard]] FibrePlace middleOf(const PolynomialCurve& curve, double from, double to) const {
        const double bulge = 0.125 * (to - from);
        const auto between = [&](double a, double b, const Vec3& slopeA, const Vec3& slopeB) {
            return 0.5 * (a + b) + bulge * (slopeA.dot(here_.along) - slopeB.dot(there_.along));
        };
        FibrePlace middle;
        middle.position = curve.at(0.5 * (from + to));
        middle.foot = {
            here_.foot.face,
            between(here_.foot.u, there_.foot.u, here_.frame.u, there_.frame.u),
            between(here_.foot.v, there_.foot.v, here_.frame.v, there_.frame.v),
            between(here_.foot.height, there_.foot.height, here_.frame.height, there_.frame.height)
        };
        middle.frame.direction = fibres_.directionAt(middle.foot);
        return middle;
    }

    [[nodiscard]] double distanceOf(const FibrePlace& place) const {
        if (place.foot.face < extended_.surfaceFaceCount) {
            return std::abs(place.foot.height) * place.frame.direction.norm();
        }
        const Triangle& face = extended_.faces[place.foot.face];
        const Vec3 barycentric = place.foot.barycentric();
        Vec3 onBoundary = Vec3::Zero();
        for (int corner = 0; corner < 3; ++corner) {
            onBoundary +=
                barycentric[corner] * extended_.vertices[extended_.surfaceVertex(face[corner])];
        }
        return (place.position - onBoundary).norm();
    }

    [[nodiscard]] double parameter(int span, double tau) const {
        return space_.breaks()[span] + tau * space_.spanLength(span);
    }

    const ExtendedSurface& extended_;
    const SplineSpace& space_;
    const ControlPoints& controls_;
    std::vector<double>& distances_;  // by span
    FibrePlace here_, there_;
    FaceFibres fibres_;  // of the face that is here
    int firstFace_;      // where it began
    int span_;           // that comes next
    bool isLost_ = false;
    FibreTrace trace_;
};

}  // namespace

CurveDistance measureAlongFibres(
    const FibreTraceStart& traced,
    const SplineSpace& space,
    const ControlPoints& controls,
    const std::optional<FootOfSpan>& middle
) {
    const ExtendedSurface& extended = traced.extended;
    const int spans = space.spanCount();
    CurveDistance distance;
    distance.perSpan.assign(spans, kInfinity);
    const SurfacePoint& pick = traced.picks.front().point;
    FibreTracer walk(extended, space, controls, 0, FootPoint::at(pick), distance.perSpan);
    if (middle) {
        // Both halves at once.
        FibreTracer rest(extended, space, controls, middle->span, middle->foot, distance.perSpan);
        forEach(traced.side, 2, 1, [&](int half) {
            half == 0 ? walk.passUntil(middle->span) : rest.passUntil(spans);
        });
        if (walk.isWhereBegan(rest)) {
            walk.follow(rest);
        } else {
            std::fill(distance.perSpan.begin() + middle->span, distance.perSpan.end(), kInfinity);
        }
    }
    walk.passUntil(spans);
    FibreTrace trace = std::move(walk).trace();
    distance.largest = std::ranges::max(distance.perSpan);
    for (const PickConstraint& constraint : traced.picks) {
        if (trace.isWhole &&
            !isAt(
                extended, constraint, footAt(extended, trace, space, controls, constraint.parameter)
            )) {
            distance.perSpan[space.spanAt(constraint.parameter)] = kInfinity;
            distance.largest = kInfinity;
        }
    }
    distance.trace = std::move(trace);
    return distance;
}

FootPoint footAt(
    const ExtendedSurface& extended,
    const FibreTrace& trace,
    const SplineSpace& space,
    const ControlPoints& controls,
    double t
) {
    const auto found = std::ranges::lower_bound(trace.pieces, t, {}, &FibreTrace::Piece::end);
    const FibreTrace::Piece& piece = found == trace.pieces.end() ? trace.pieces.back() : *found;
    const double tau = (t - space.breaks()[piece.span]) / space.spanLength(piece.span);
    FootPoint foot = piece.foot;
    FootFrame frame;
    // The fibres do not cross on the piece, so this finds the foot.
    static_cast<void>(FaceFibres(extended, foot.face)
                          .find<FaceFibres::Search::Exact>(
                              space.polynomial(controls, piece.span).at(tau), foot, frame
                          ));
    return foot;
}

}  // namespace bspline_curve
