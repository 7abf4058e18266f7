// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/initial_curve.h"
#include "spline/band_cholesky.h"
#include "spline/pick_constraint.h"
#include "spline/spline_system.h"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace bspline_curve {

/// A spline at one parameter, and the surface beneath.
struct SeenSample {
    double parameter = 0.0;  ///< ascending in (0, 1)
    double weight = 0.0;     ///< of integrals over [0, 1]
    Vec3 position = Vec3::Zero();
    Vec3 second = Vec3::Zero();  ///< P''
    Vec3 normal = Vec3::Zero();  ///< unit, of the surface
    double height = 0.0;         ///< over the surface, along the normal
};

/// What a spline with fewer knots must keep to, at samples. Its bending is the length times the
/// integral of the squared geodesic curvature, without unit.
struct RemovalLimits {
    double height = 0.0;  ///< from the surface, in the unit of positions
    double way = 0.0;     ///< from where the spline was, likewise
    /// The bending may grow by this share of itself and of the floor.
    double bendingShare = 0.0, bendingFloor = 0.0;
};

/// Takes out of a spline the knots that it does not need. What is left passes the same picks, is
/// near to the spline and within limits; its breaks are some of those before, 0 and 1 among them.
///
/// Knots are taken out in batches, cheapest first, no two neighbours at once, and the spline is
/// fitted anew to its samples: least squares of positions and second derivatives under the picks.
/// What a knot costs by itself is foreseen with the matrix of the fit, near to the knot; one that
/// costs too much stays for good. Usually five fits, and not many in turn that take out nothing;
/// O(n) each for n samples.
class KnotRemoval {
public:
    /// `curve` and `picks` must outlive it. At least one sample per span.
    KnotRemoval(
        const SplineCurve& curve,
        const std::vector<PickConstraint>& picks,
        std::vector<SeenSample> samples,
        const RemovalLimits& limits
    );

    /// The spline with the fewest knots found. Where all are needed, the spline itself.
    [[nodiscard]] SplineCurve run();

    /// The same with all knots again inside the marked spans of what was returned last, which are
    /// out of the limits after all.
    [[nodiscard]] SplineCurve withKnotsBack(const std::vector<char>& spans);

private:
    // A sample's basis functions and their derivatives by t.
    struct Row {
        SplineSpace::BasisValues basis, first, second;
    };

    // Sums over the samples of a span, for the fit: by positions, and by second derivatives.
    struct SpanSums {
        SplineSpace::BasisMatrix near, bent;  // products of basis functions, lower triangle
        std::array<Vec3, kMaxBasis> nearRight, bentRight;
    };

    struct Fit {
        std::vector<int> kept;  // breaks, as indices into those before
        SplineSpace space;
        BandCholesky<1> factor;
        ControlPoints controls;
        std::vector<SpanSums> sums;  // by span
        // By sample:
        std::vector<Row> rows;
        std::vector<Vec3> firsts, seconds;  // P', P''
        std::vector<Vec3> ways;             // from where the spline was
        std::vector<double> bends;          // squared geodesic curvature times the speed
        double length = 0.0, bending = 0.0;
    };

    // What it would cost to take one knot out.
    struct Cost {
        double farthest;  // largest height or way there would be, 1 at the limit
        double bending;   // more than now; not all of it where the knot is needed
    };

    struct Candidate {
        int index;    // into Fit::kept
        int atBreak;  // of the spline before
        double cost;  // 1 at a limit
        double bending;
    };

    [[nodiscard]] SplineCurve curveOf(const Fit& fit) const;
    [[nodiscard]] std::optional<Fit> fitOn(std::vector<int> kept, const Fit* like) const;
    [[nodiscard]] double farness(const SeenSample& sample, const Vec3& way) const;
    [[nodiscard]] bool isWithin(const Fit& fit) const;
    [[nodiscard]] std::pair<int, int> samplesOf(const Fit& fit, int span) const;
    void sumSamples(Fit& fit, const Fit* like) const;
    template <int kBasis>
    void sumSpan(Fit& fit, int span) const;
    void addSums(Fit& fit, ControlPoints& right) const;
    template <int kBasis>
    void measure(Fit& fit) const;
    [[nodiscard]] std::vector<Candidate> nextBatch(const Fit& fit);
    [[nodiscard]] Vec3 moveWithout(const Fit& fit, int index);
    [[nodiscard]] Cost costOf(const Fit& fit, int index);
    template <int kBasis>
    void addCost(const Fit& fit, int span, const Vec3& step, Cost& cost) const;
    void shorten(const Fit* trial, std::vector<Candidate>& batch);

    const SplineCurve& curve_;
    const std::vector<PickConstraint>& picks_;
    std::vector<SeenSample> samples_;
    RemovalLimits limits_;
    double mostBending_ = 0.0;
    std::vector<int> firstSamples_;  // by span of the spline before, and of all
    std::vector<char> isLocked_;     // by break of the spline before: stays for good
    Eigen::VectorXd answer_;         // of moveWithout(): by control point
    std::vector<int> kept_;          // breaks of what run() has returned, as indices
};

}  // namespace bspline_curve
