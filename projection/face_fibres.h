// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "projection/fibre_projector.h"
#include "shell/extended_surface.h"
#include "surface/surface_point.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace bspline_curve {

/// The fibres q(u, v) + height n(u, v) over one face: q and n are linear in the face, and beyond
/// its edges. The walls between the fibres of two faces are the same seen from either.
class FaceFibres {
public:
    FaceFibres(const ExtendedSurface& extended, int face)
        : FaceFibres(extended, extended.faces[face]) {}

    /// A foot with a coordinate below this lies in another face for certain.
    static constexpr double kFarOutside = -0.3;

    [[nodiscard]] static bool isFarOutside(const FootPoint& foot) {
        return isFarOutside(Eigen::Array2d(foot.u, foot.v));
    }

    enum class Outcome {
        Found,
        FarOutside,  ///< of the face, on the way to it
        Crossed      ///< fibres cross on the way to it
    };

    /// How exactly feet are found.
    enum class Search {
        OnTheWay,  ///< to 1e-9 of the face, unless they lie far outside
        Exact      ///< to rounding, wherever they lie
    };

    /// Newton's method from the foot given: that of p, on this face and beyond its edges, and its
    /// frame, but for `turnU`, `turnV` and the direction's length. About 100 instructions per step,
    /// of one to four.
    template <Search search>
    [[nodiscard]] Outcome find(const Vec3& p, FootPoint& foot, FootFrame& frame) const;

    /// The same frame of a foot that has been found. False where fibres cross on the way to it.
    [[nodiscard]] bool frameAt(const FootPoint& foot, FootFrame& frame) const {
        Linearisation there;
        if (!linearise({foot.u, foot.v}, foot.height, there)) {
            return false;
        }
        there.setFrame(frame);
        return true;
    }

    /// The fibres over the edge opposite to a corner: corner + s edge + height (direction + s
    /// turn), from the end at s = 0 to that at s = 1.
    struct Wall {
        Vec3 corner, edge, direction, turn;
    };

    /// `corner`: 0, 1, 2; the wall begins over the corner after it.
    [[nodiscard]] Wall wall(int corner) const {
        switch (corner) {
            case 0:
                return {
                    corner_ + edges_.u(),
                    edges_.v() - edges_.u(),
                    direction_ + turns_.u(),
                    turns_.v() - turns_.u()
                };
            case 1:
                return {corner_ + edges_.v(), -edges_.v(), direction_ + turns_.v(), -turns_.v()};
            default:
                return {corner_, edges_.u(), direction_, turns_.u()};
        }
    }

    /// Completes the frame of a foot.
    void complete(FootFrame& frame) const {
        frame.direction.normalize();
        frame.turnU = turns_.u();
        frame.turnV = turns_.v();
    }

    [[nodiscard]] Vec3 directionAt(const FootPoint& foot) const {
        return direction_ + turns_.times({foot.u, foot.v});
    }

    [[nodiscard]] Vec3 edgeU() const { return edges_.u(); }

    [[nodiscard]] Vec3 edgeV() const { return edges_.v(); }

private:
    // Two vectors side by side, by u and by v, so that both are computed at once.
    struct PairOfVectors {
        Eigen::Array2d x, y, z;

        static PairOfVectors of(const Vec3& u, const Vec3& v) {
            return {{u.x(), v.x()}, {u.y(), v.y()}, {u.z(), v.z()}};
        }

        [[nodiscard]] Vec3 u() const { return {x[0], y[0], z[0]}; }

        [[nodiscard]] Vec3 v() const { return {x[1], y[1], z[1]}; }

        [[nodiscard]] Vec3 times(const Eigen::Array2d& uv) const {
            return {(x * uv).sum(), (y * uv).sum(), (z * uv).sum()};
        }

        [[nodiscard]] PairOfVectors plus(double scale, const PairOfVectors& other) const {
            return {x + scale * other.x, y + scale * other.y, z + scale * other.z};
        }

        [[nodiscard]] PairOfVectors crossedFromLeftBy(const Vec3& a) const {
            return {a.y() * z - a.z() * y, a.z() * x - a.x() * z, a.x() * y - a.y() * x};
        }

        [[nodiscard]] Eigen::Array2d dot(const Vec3& a) const {
            return a.x() * x + a.y() * y + a.z() * z;
        }
    };

    // The method converges quadratically: steps this small, in barycentric coordinates, leave 1e-9
    // at most, or nothing but rounding.
    static constexpr double kLastStep = 1e-5;
    static constexpr double kLastExactStep = 1e-8;
    static constexpr int kMaxSteps = 6;
    // The fibres of a face narrow with the height; where the area that they leave is less than this
    // share, feet would run away.
    static constexpr double kLeastArea = 0.05;

    FaceFibres(const ExtendedSurface& extended, const Triangle& corners)
        : corner_(extended.vertices[corners[0]]),
          direction_(extended.directions[corners[0]]),
          edges_(
              PairOfVectors::of(
                  extended.vertices[corners[1]] - corner_, extended.vertices[corners[2]] - corner_
              )
          ),
          turns_(
              PairOfVectors::of(
                  extended.directions[corners[1]] - direction_,
                  extended.directions[corners[2]] - direction_
              )
          ),
          leastDeterminant_(kLeastArea * direction_.dot(edges_.u().cross(edges_.v()))) {}

    // How a foot moves with the point over it.
    struct Linearisation {
        Vec3 direction, area;
        PairOfVectors across;
        double inverse;

        void setFrame(FootFrame& frame) const {
            frame.height = inverse * area;
            frame.u = -inverse * across.v();
            frame.v = inverse * across.u();
            frame.direction = direction;
        }
    };

    // False where fibres cross.
    [[nodiscard]] bool linearise(const Eigen::Array2d& uv, double height, Linearisation& at) const {
        const PairOfVectors by = edges_.plus(height, turns_);
        at.direction = direction_ + turns_.times(uv);
        at.area = by.u().cross(by.v());
        const double determinant = at.direction.dot(at.area);
        at.across = by.crossedFromLeftBy(at.direction);
        at.inverse = 1.0 / determinant;
        return determinant > leastDeterminant_;
    }

    [[nodiscard]] static bool isFarOutside(const Eigen::Array2d& uv) {
        return std::min(uv.minCoeff(), 1.0 - uv.sum()) < kFarOutside;
    }

    // The corner 0 of a face with the edges from there, and the same of the directions.
    Vec3 corner_, direction_;
    PairOfVectors edges_, turns_;
    double leastDeterminant_;
};

/// The same point seen from the face across the edge opposite to corner k, moved onto that edge.
inline void carryOver(const ExtendedSurface& extended, int k, int across, FootPoint& foot) {
    const Triangle& from = extended.faces[foot.face];
    const Triangle& to = extended.faces[across];
    const Vec3 before = foot.barycentric();
    Vec3 after = Vec3::Zero();
    for (int corner = 0; corner < 3; ++corner) {
        const int slot = corner == k ? -1 : cornerOf(to, from[corner]);
        if (slot >= 0) {
            after[slot] = std::clamp(before[corner], 0.0, 1.0);
        }
    }
    const double sum = after.sum();
    if (sum > 0.0) {
        after /= sum;
    }
    foot = {across, after[1], after[2], foot.height};
}

template <FaceFibres::Search search>
FaceFibres::Outcome FaceFibres::find(const Vec3& p, FootPoint& foot, FootFrame& frame) const {
    constexpr bool kIsExact = search == Search::Exact;
    constexpr double kEnd = kIsExact ? kLastExactStep : kLastStep;
    Eigen::Array2d uv(foot.u, foot.v);
    bool isFar = !kIsExact && isFarOutside(uv);
    for (int step = 0; step < kMaxSteps && !isFar; ++step) {
        Linearisation now;
        if (!linearise(uv, foot.height, now)) {
            return Outcome::Crossed;
        }
        const Vec3 gap = p - corner_ - edges_.times(uv) - foot.height * now.direction;
        const Eigen::Array2d turned = now.inverse * now.across.dot(gap);
        const Eigen::Array2d move(-turned[1], turned[0]);
        uv += move;
        foot.height += now.inverse * now.area.dot(gap);
        isFar = !kIsExact && isFarOutside(uv);
        if (move.abs().sum() < kEnd || step + 1 == kMaxSteps) {
            now.setFrame(frame);
            break;
        }
    }
    foot.u = uv[0];
    foot.v = uv[1];
    return isFar ? Outcome::FarOutside : Outcome::Found;
}

}  // namespace bspline_curve
