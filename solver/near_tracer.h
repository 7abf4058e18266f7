// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/near_shell.h"
#include "solver/curve_distance.h"
#include "solver/faces_below.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace bspline_curve {

/// Traces curves in prisms over the faces below them alone, and about the places where one left
/// those: four of five curves leave them nowhere.
class NearTracer {
public:
    explicit NearTracer(const CurveProblem& problem) : problem_(problem) {}

    /// `feet`: some along the curve, by parameter. The curve leaves its prisms, so that distances
    /// are infinite, only through their top or bottom, or where widening them several times did not
    /// help. O(n log n) for n faces below the curve.
    [[nodiscard]] CurveDistance measure(
        const SplineSpace& space, const ControlPoints& controls, const std::vector<FootAt>& feet
    );

    /// The prisms of the last measurement.
    [[nodiscard]] const std::shared_ptr<const NearShell>& shell() const { return near_; }

private:
    // A curve, and a piece of it from foot to foot.
    struct Spline {
        const SplineSpace& space;
        const ControlPoints& controls;
    };

    using Stretch = std::span<const FootAt>;

    [[nodiscard]] NearShell shellOver(const std::vector<int>& faces) const;
    [[nodiscard]] CurveDistance measureOver(std::vector<int> faces, const Spline& spline);
    [[nodiscard]] bool widenWhereLeft(
        const ShadowTrace& trace, const Spline& spline, const std::vector<FootAt>& feet
    );
    void addMissing(const std::vector<int>& faces);
    void widenUnder(const Stretch& stretch, const Spline& spline);
    [[nodiscard]] static std::vector<Stretch> stretchesFrom(
        int firstSpan, const SplineSpace& space, const std::vector<FootAt>& feet
    );
    [[nodiscard]] static std::optional<int> placeLeft(
        const NearShell& near, const Stretch& stretch, const Spline& spline
    );
    [[nodiscard]] std::vector<int> ringAbout(int face) const;
    void addFacesAroundPicks(double begin, double end, std::vector<int>& faces) const;

    const CurveProblem& problem_;
    std::shared_ptr<const NearShell> near_;
    std::vector<int> widened_;  // faces about the places where curves left their prisms
};

}  // namespace bspline_curve
