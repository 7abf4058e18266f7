// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/fibre_tracer.h"

#include "solver/face_fibres.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// A foot with a barycentric coordinate this small is on the edge: rounding, where edges are 1e-4 of
// the diagonal long, with a margin.
constexpr double kOnWall = 1e-11;
// And a wall between two parameters this near to each other is there.
constexpr double kSameParameter = 1e-14;
// Newton's method takes two or three steps to a wall; bisection alone would take 47.
constexpr int kMaxSteps = 60;
// A walk that turns this often at one parameter goes round in a circle.
constexpr int kMaxStalled = 128;
// A curve passes a pick where it is so near to the surface, in tolerances.
constexpr double kAtPick = 1e-3;

// A point of the curve and its foot on one face.
struct Place {
    Vec3 position = Vec3::Zero();
    FootPoint foot;
    FootFrame frame;

    void moveTo(const Vec3& p) {
        FootFinder::predict(p - position, frame, foot);
        position = p;
    }
};

// How far a foot is from the walls of its face, and how fast that changes along the curve.
struct Walls {
    Vec3 coordinates, slopes;
    int outer = 0;  // of the least coordinate

    Walls(const Place& place, const Vec3& along) : coordinates(place.foot.barycentric()) {
        const double u = place.frame.u.dot(along);
        const double v = place.frame.v.dot(along);
        slopes = {-u - v, u, v};
        coordinates.minCoeff(&outer);
    }

    [[nodiscard]] bool areInside() const { return coordinates[outer] >= -kOnWall; }

    // The wall on which the foot stands and which it is about to pass, in the rest of the span by
    // more than rounding; at a vertex that which it passes sooner.
    [[nodiscard]] std::optional<int> passed(double rest) const {
        std::optional<int> wall;
        for (int k = 0; k < 3; ++k) {
            const bool isPassed =
                coordinates[k] <= kOnWall && coordinates[k] + rest * slopes[k] < -kOnWall;
            if (isPassed && (!wall || slopes[k] < slopes[*wall])) {
                wall = k;
            }
        }
        return wall;
    }

    // Where a wall is, along the tangent from `tau`; infinite for one that comes no nearer.
    [[nodiscard]] double meeting(int k, double tau) const {
        return slopes[k] < 0.0 ? tau - coordinates[k] / slopes[k] : kInfinity;
    }
};

// Where a curve leaves a face: between a parameter at which its foot is inside and one at which it
// is not.
struct ExitSearch {
    double inside;
    double outside = kInfinity;

    // The wall by which it leaves at tau, -1 at the end of the span; nothing where neither is
    // there yet.
    [[nodiscard]] std::optional<int> wallAt(double tau, const Walls& walls) {
        if (!walls.areInside()) {
            outside = tau;
            return outside - inside <= kSameParameter ? std::optional(walls.outer) : std::nullopt;
        }
        inside = tau;
        return tau >= 1.0 ? std::optional(-1) : walls.passed(1.0 - tau);
    }

    // The parameter to look at next: from inside at the first wall in the way, from outside at
    // that which was passed; half way where that leads out of the bracket.
    [[nodiscard]] double after(double tau, const Walls& walls) const {
        const double farthest = std::min(outside, 1.0);
        double guess = farthest;
        for (int k = 0; k < 3; ++k) {
            const bool isInTheWay =
                walls.areInside() ? walls.coordinates[k] > kOnWall : k == walls.outer;
            if (isInTheWay) {
                guess = std::min(guess, walls.meeting(k, tau));
            }
        }
        return guess > inside && guess < outside ? guess : 0.5 * (inside + farthest);
    }
};

class FibreWalk {
public:
    FibreWalk(
        const ShellBase& base,
        const SplineSpace& space,
        const ControlPoints& controls,
        const SurfacePoint& start
    )
        : base_(base), space_(space), controls_(controls), fibres_(base, start.face) {
        distance_.perSpan.assign(at(space.spanCount()), kInfinity);
        here_.foot = {start.face, start.barycentric[1], start.barycentric[2], 0.0};
    }

    CurveDistance run() && {
        here_.position = space_.polynomial(controls_, 0).coefficients[0];
        bool goesOn = find(here_);
        for (int span = 0; goesOn && span < space_.spanCount(); ++span) {
            goesOn = passSpan(span);
            trace_.wholeSpans += goesOn ? 1 : 0;
        }
        trace_.isWhole = trace_.wholeSpans == space_.spanCount();
        if (!trace_.isWhole) {
            distance_.perSpan[at(trace_.wholeSpans)] = kInfinity;
        }
        distance_.largest = std::ranges::max(distance_.perSpan);
        distance_.trace = std::move(trace_);
        return std::move(distance_);
    }

private:
    // Where the curve leaves a face.
    struct Exit {
        double tau;
        int wall;  // opposite to this corner; -1: nowhere up to the end of the span
    };

    [[nodiscard]] bool find(Place& place) const {
        return fibres_.find<FaceFibres::Search::Exact>(place.position, place.foot, place.frame) ==
               FaceFibres::Outcome::Found;
    }

    // Takes the fibres of the face that is here now.
    bool enter() {
        fibres_ = FaceFibres(base_, here_.foot.face);
        return find(here_);
    }

    bool passSpan(int span) {
        const PolynomialCurve curve = space_.polynomial(controls_, span);
        double& farthest = distance_.perSpan[at(span)];
        farthest = 0.0;
        double tau = 0.0;
        while (true) {
            farthest = std::max(farthest, distanceOf(here_));
            Place place = here_;
            const std::optional<Exit> exit = findExit(curve, tau, place);
            if (!exit) {
                return false;
            }
            if (exit->tau > tau) {
                const Place middle = middleOf(curve, tau, exit->tau, place);
                farthest = std::max(farthest, distanceOf(middle));
                trace_.pieces.push_back({parameter(span, exit->tau), span, middle.foot});
                stalled_ = 0;
            } else if (++stalled_ > kMaxStalled) {
                return false;
            }
            tau = exit->tau;
            here_ = place;
            if (exit->wall < 0) {
                farthest = std::max(farthest, distanceOf(here_));
                return true;
            }
            const int next = base_.faceNeighbours[at(here_.foot.face)][at(exit->wall)];
            if (next < 0) {
                return false;
            }
            Vec3 onWall = here_.foot.barycentric();
            onWall[exit->wall] = 0.0;
            trace_.crossings.push_back(
                {parameter(span, tau), onSurface(base_, here_.foot.face, onWall)}
            );
            carryOver(base_, exit->wall, next, here_.foot);
            if (!enter()) {
                return false;
            }
        }
    }

    // Half way to `there` on this face, without a search: by values and derivatives at both ends.
    [[nodiscard]] Place middleOf(
        const PolynomialCurve& curve, double from, double to, const Place& there
    ) const {
        const double bulge = 0.125 * (to - from);
        const Vec3 before = curve.derivativeAt(from);
        const Vec3 after = curve.derivativeAt(to);
        const auto between = [&](double a, double b, const Vec3& slopeA, const Vec3& slopeB) {
            return 0.5 * (a + b) + bulge * (slopeA.dot(before) - slopeB.dot(after));
        };
        Place middle;
        middle.position = curve.at(0.5 * (from + to));
        const FootFrame& frame = there.frame;
        middle.foot = {
            here_.foot.face,
            between(here_.foot.u, there.foot.u, here_.frame.u, frame.u),
            between(here_.foot.v, there.foot.v, here_.frame.v, frame.v),
            between(here_.foot.height, there.foot.height, here_.frame.height, frame.height)
        };
        middle.frame.direction = fibres_.directionAt(middle.foot);
        return middle;
    }

    // The first place from tau on where the foot leaves its face, with what is there in `place`;
    // nothing where fibres cross. Newton's method on the coordinate of the nearest wall, kept
    // between places known to be inside and outside.
    [[nodiscard]] std::optional<Exit> findExit(
        const PolynomialCurve& curve, double tau, Place& place
    ) const {
        ExitSearch search{tau};
        double next = firstGuess(curve, tau);
        for (int step = 0; step < kMaxSteps; ++step) {
            place.moveTo(curve.at(next));
            if (!find(place)) {
                return std::nullopt;
            }
            const Walls walls(place, curve.derivativeAt(next));
            if (const std::optional<int> wall = search.wallAt(next, walls)) {
                return Exit{next, *wall};
            }
            next = search.after(next, walls);
        }
        return std::nullopt;
    }

    // By the derivatives of the coordinates where the face is entered.
    [[nodiscard]] double firstGuess(const PolynomialCurve& whole, double tau) const {
        const PolynomialCurve curve = tau == 0.0 ? whole : whole.shifted(tau);
        const Vec3 barycentric = here_.foot.barycentric();
        std::array<std::array<double, kMaxPolynomialDegree + 1>, 3> coordinates{};
        for (std::size_t j = 1; j <= at(curve.degree); ++j) {
            coordinates[1][j] = here_.frame.u.dot(curve.coefficients[j]);
            coordinates[2][j] = here_.frame.v.dot(curve.coefficients[j]);
            coordinates[0][j] = -coordinates[1][j] - coordinates[2][j];
        }
        double exit = 1.0 - tau;
        for (int k = 0; k < 3; ++k) {
            coordinates[at(k)][0] = barycentric[k];
            exit = std::min(
                exit, firstExit(coordinates[at(k)].data(), curve.degree, exit, 0.5 * kOnWall)
            );
        }
        return exit == 1.0 - tau ? 1.0 : tau + exit;
    }

    [[nodiscard]] double distanceOf(const Place& place) const {
        if (place.foot.face < base_.surfaceFaceCount) {
            return std::abs(place.foot.height) * place.frame.direction.norm();
        }
        const Triangle& face = base_.faces[at(place.foot.face)];
        const Vec3 barycentric = place.foot.barycentric();
        Vec3 onBoundary = Vec3::Zero();
        for (int corner = 0; corner < 3; ++corner) {
            onBoundary +=
                barycentric[corner] * base_.vertices[at(base_.surfaceVertex(face[at(corner)]))];
        }
        return (place.position - onBoundary).norm();
    }

    [[nodiscard]] double parameter(int span, double tau) const {
        return space_.breaks()[at(span)] + tau * space_.spanLength(span);
    }

    const ShellBase& base_;
    const SplineSpace& space_;
    const ControlPoints& controls_;
    Place here_;
    FaceFibres fibres_;  // of the face that is here
    int stalled_ = 0;    // crossings since the last piece of some length
    FibreTrace trace_;
    CurveDistance distance_;
};

}  // namespace

CurveDistance measureAlongFibres(
    const CurveProblem& problem, const SplineSpace& space, const ControlPoints& controls
) {
    CurveDistance distance =
        FibreWalk(*problem.base, space, controls, problem.picks.front().point).run();
    const FibreTrace& trace = std::get<FibreTrace>(distance.trace);
    for (const PickConstraint& pick : problem.picks) {
        if (trace.isWhole &&
            std::abs(footAt(*problem.base, trace, space, controls, pick.parameter).height) >
                kAtPick * problem.distanceTolerance) {
            distance.perSpan[at(space.spanAt(pick.parameter))] = kInfinity;
            distance.largest = kInfinity;
        }
    }
    return distance;
}

FootPoint footAt(
    const ShellBase& base,
    const FibreTrace& trace,
    const SplineSpace& space,
    const ControlPoints& controls,
    double t
) {
    const auto found = std::ranges::lower_bound(trace.pieces, t, {}, &FibreTrace::Piece::end);
    const FibreTrace::Piece& piece = found == trace.pieces.end() ? trace.pieces.back() : *found;
    const double tau = (t - space.breaks()[at(piece.span)]) / space.spanLength(piece.span);
    FootPoint foot = piece.foot;
    FootFrame frame;
    // The fibres do not cross on the piece, so this finds the foot.
    static_cast<void>(FaceFibres(base, foot.face)
                          .find<FaceFibres::Search::Exact>(
                              space.polynomial(controls, piece.span).at(tau), foot, frame
                          ));
    return foot;
}

}  // namespace bspline_curve
