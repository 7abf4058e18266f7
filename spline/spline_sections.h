// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"

#include <cstddef>
#include <span>
#include <vector>

namespace bspline_curve {

// A spline with corners is a chain of smooth splines, its sections. They meet at knots whose
// multiplicity is the degree, where it is continuous and no more.

/// An open spline that is clamped on [from, to].
struct SplineSection {
    double from = 0.0, to = 1.0;
    SplineData spline;  ///< without parameters of picks
};

/// Sections as one spline. Each begins where the one before ends, at the same parameter; all have
/// one degree. An open spline is over [0, 1]. A closed one is over [a, a + 1] with a in (-1, 0];
/// where a < 0 its first section passes t = 0, where the result gets a knot. Where two sections
/// meet, the curve passes the mean of their ends. Exact to rounding.
[[nodiscard]] SplineData joinedSpline(std::span<const SplineSection> sections, bool closed);

/// The sections of a spline, of which joinedSpline() makes it again. An open one without corners is
/// one section, a closed one has none, nor has an open one that is not clamped. A closed one begins
/// at t = 0 where it has a corner there, else at its last corner before, which is below 0.
/// `spline`: ascending knots, as many as control points, plus its degree, plus 1.
[[nodiscard]] std::vector<SplineSection> sectionsOf(const SplineData& spline);

/// The span that holds t: the last knot that is no more, among those that spans begin at.
[[nodiscard]] std::size_t spanHolding(const SplineData& spline, double t);

/// At `degree` arguments, the blossom of the polynomial on [knots[span], knots[span + 1]], which
/// must not be empty: de Boor's algorithm with another argument in each step.
[[nodiscard]] Vec3 blossom(
    const SplineData& spline, std::size_t span, std::span<const double> arguments
);

}  // namespace bspline_curve
