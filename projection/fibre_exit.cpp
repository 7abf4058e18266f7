// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/fibre_exit.h"

#include "utility/infinity.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace bspline_curve {
namespace {

// A foot with a barycentric coordinate this small is on the edge: rounding, where edges are 1e-4 of
// the diagonal long, with a margin.
constexpr double kOnWall = 1e-11;
// And a wall between two parameters this near to each other is there.
constexpr double kSameParameter = 1e-14;
// Newton's method takes two or three steps to a wall; bisection alone would take 47.
constexpr int kMaxSteps = 60;
// Where it takes more than these, or comes to other walls, every step is looked at.
constexpr int kMaxQuickSteps = 5;
constexpr int kMaxQuickWalls = 3;
// It converges quadratically: steps this small, in barycentric coordinates, leave 1e-12.
constexpr double kLastQuickStep = 1e-6;

bool find(const FaceFibres& fibres, FibrePlace& place) {
    return fibres.find<FaceFibres::Search::Exact>(place.position, place.foot, place.frame) ==
           FaceFibres::Outcome::Found;
}

// Moves from a place to another parameter of the curve, the foot by its derivatives there. `to` may
// be the same; its frame stays as it is.
void moveTo(const PolynomialCurve& curve, double tau, const FibrePlace& from, FibrePlace& to) {
    const auto [position, along] = curve.withDerivativeAt(tau);
    to.foot = from.foot;
    FibreProjector::predict(position - from.position, from.frame, to.foot);
    to.position = position;
    to.along = along;
}

// How far a foot is from the walls of its face, and how fast that changes along the curve.
struct Walls {
    Vec3 coordinates, slopes;
    int outer = 0;  // of the least coordinate

    explicit Walls(const FibrePlace& place) : coordinates(place.foot.barycentric()) {
        const double u = place.frame.u.dot(place.along);
        const double v = place.frame.v.dot(place.along);
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

// Whether a foot stays inside between two places, if its coordinates are cubics with the values and
// slopes there.
bool staysInside(const Walls& from, const Walls& to, double length) {
    const double third = length / 3.0;
    return (from.coordinates + third * from.slopes).minCoeff() >= -kOnWall &&
           (to.coordinates - third * to.slopes).minCoeff() >= -kOnWall;
}

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

// By the derivatives of the coordinates where the face is entered.
double firstGuess(const PolynomialCurve& whole, double tau, const FibrePlace& here) {
    const PolynomialCurve curve = tau == 0.0 ? whole : whole.shifted(tau);
    const Vec3 barycentric = here.foot.barycentric();
    std::array<std::array<double, kMaxPolynomialDegree + 1>, 3> coordinates{};
    for (std::size_t j = 1; j <= static_cast<std::size_t>(curve.degree); ++j) {
        coordinates[1][j] = here.frame.u.dot(curve.coefficients[j]);
        coordinates[2][j] = here.frame.v.dot(curve.coefficients[j]);
        coordinates[0][j] = -coordinates[1][j] - coordinates[2][j];
    }
    double exit = 1.0 - tau;
    for (int k = 0; k < 3; ++k) {
        std::array<double, kMaxPolynomialDegree + 1>& one = coordinates[k];
        one[0] = barycentric[k];
        exit = std::min(exit, firstExit(one.data(), curve.degree, exit, 0.5 * kOnWall));
    }
    return exit == 1.0 - tau ? 1.0 : tau + exit;
}

// Newton's method on the coordinate of the nearest wall, kept between places known to be inside and
// outside.
std::optional<FibreExit> findCarefully(
    const FaceFibres& fibres,
    const PolynomialCurve& curve,
    double tau,
    const FibrePlace& here,
    FibrePlace& there
) {
    there = here;
    ExitSearch search{tau};
    double next = firstGuess(curve, tau, here);
    for (int step = 0; step < kMaxSteps; ++step) {
        moveTo(curve, next, there, there);
        if (!find(fibres, there)) {
            return std::nullopt;
        }
        const Walls walls(there);
        if (const std::optional<int> wall = search.wallAt(next, walls)) {
            return FibreExit{next, *wall};
        }
        next = search.after(next, walls);
    }
    return std::nullopt;
}

// A point of a curve on a wall.
struct WallMeeting {
    double tau;
    double along;  // the edge, from 0 to 1
    double height;

    // Newton's method for all three at once, from values near them. `slope`: of the coordinate that
    // is zero on the wall. Returns whether they are found.
    [[nodiscard]] bool find(
        const FaceFibres::Wall& wall, const PolynomialCurve& curve, double slope
    ) {
        for (int step = 0; step < kMaxQuickSteps; ++step) {
            const Vec3 direction = wall.direction + along * wall.turn;
            const auto [position, byTau] = curve.withDerivativeAt(tau);
            const Vec3 gap = position - wall.corner - along * wall.edge - height * direction;
            const Vec3 byAlong = wall.edge + height * wall.turn;
            const Vec3 across = direction.cross(byTau);
            const Vec3 turned = gap.cross(byAlong);
            const double inverse = 1.0 / byAlong.dot(across);
            const double moved = inverse * gap.dot(across);
            const double passed = -inverse * direction.dot(turned);
            along += moved;
            height -= inverse * byTau.dot(turned);
            tau += passed;
            if (std::abs(moved) + std::abs(slope * passed) < kLastQuickStep) {
                return true;
            }
        }
        return false;
    }
};

// The same without a look at every step, for a curve that is nearly straight over the face: it
// leaves where it meets the wall that its tangent meets first.
class QuickSearch {
public:
    QuickSearch(
        const FaceFibres& fibres,
        const PolynomialCurve& curve,
        double tau,
        const FibrePlace& here,
        FibrePlace& there
    )
        : fibres_(fibres), curve_(curve), tau_(tau), here_(here), there_(there), start_(here) {}

    // Nothing where every step must be looked at.
    [[nodiscard]] std::optional<FibreExit> run() {
        guess_ = {1.0, -1};
        for (int k = 0; k < 3; ++k) {
            const double meeting = start_.meeting(k, tau_);
            if (meeting < guess_.tau) {
                guess_ = {meeting, k};
            }
        }
        for (int attempt = 0; attempt < kMaxQuickWalls; ++attempt) {
            const Look look = guess_.wall < 0 ? lookAtEnd() : lookAtWall();
            if (look != Look::Elsewhere) {
                return look == Look::Found ? std::optional(guess_) : std::nullopt;
            }
        }
        return std::nullopt;
    }

private:
    enum class Look { Found, Elsewhere, Unclear };

    // At the end of the span; sets another guess where that lies outside.
    Look lookAtEnd() {
        moveTo(curve_, 1.0, here_, there_);
        if (!find(fibres_, there_)) {
            return Look::Unclear;
        }
        const Walls end(there_);
        if (end.areInside()) {
            return staysInside(start_, end, 1.0 - tau_) ? Look::Found : Look::Unclear;
        }
        return lookNext(end.outer, end.meeting(end.outer, 1.0));
    }

    // Where the curve meets a wall; sets another guess where that is beyond its ends.
    Look lookAtWall() {
        const int wall = guess_.wall;
        const int from = (wall + 1) % 3;
        const int to = (wall + 2) % 3;
        moveTo(curve_, guess_.tau, here_, there_);
        WallMeeting meeting{guess_.tau, there_.foot.barycentric()[to], there_.foot.height};
        if (!meeting.find(fibres_.wall(wall), curve_, start_.slopes[wall]) ||
            meeting.tau <= tau_ + kSameParameter) {
            return Look::Unclear;
        }
        if (meeting.tau > 1.0) {
            return lookNext(-1, 1.0);
        }
        if (std::max(-meeting.along, meeting.along - 1.0) > kOnWall) {
            const int other = meeting.along < 0.0 ? to : from;
            return lookNext(other, start_.meeting(other, tau_));
        }
        Vec3 barycentric;
        barycentric[wall] = 0.0;
        barycentric[from] = 1.0 - meeting.along;
        barycentric[to] = meeting.along;
        std::tie(there_.position, there_.along) = curve_.withDerivativeAt(meeting.tau);
        there_.foot = {here_.foot.face, barycentric[1], barycentric[2], meeting.height};
        if (!fibres_.frameAt(there_.foot, there_.frame)) {
            return Look::Unclear;
        }
        const Walls end(there_);
        guess_.tau = meeting.tau;
        return staysInside(start_, end, meeting.tau - tau_) ? Look::Found : Look::Unclear;
    }

    Look lookNext(int wall, double tau) {
        guess_ = {tau, wall};
        return Look::Elsewhere;
    }

    const FaceFibres& fibres_;
    const PolynomialCurve& curve_;
    double tau_;
    const FibrePlace& here_;
    FibrePlace& there_;
    Walls start_;
    FibreExit guess_{};
};

}  // namespace

std::optional<FibreExit> findExit(
    const FaceFibres& fibres,
    const PolynomialCurve& curve,
    double tau,
    const FibrePlace& here,
    FibrePlace& there
) {
    if (const std::optional<FibreExit> exit = QuickSearch(fibres, curve, tau, here, there).run()) {
        return exit;
    }
    return findCarefully(fibres, curve, tau, here, there);
}

}  // namespace bspline_curve
