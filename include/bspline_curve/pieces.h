// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/options.h"
#include "bspline_curve/progress.h"
#include "bspline_curve/workpiece.h"

#include <span>
#include <vector>

// Curves turned round, cut, joined and made longer. Each result is a curve like others: a polyline
// strictly on the mesh, and its spline at the same parameters. It is no longer one that is drawn
// through its picks: to draw it again, change the curves that it is made of. `picks`, where it is
// not null, is told which picks of the whole those of the result are, in their order.
namespace bspline_curve {

/// The same curve from its end to its start; a closed one keeps its first point. Picks change their
/// order. Exact to rounding. O(n).
[[nodiscard]] Curve reversedCurve(const Curve& curve, std::vector<int>* picks = nullptr);

/// The part between two parameters, as an open curve over [0, 1] with the picks that lie in it; of
/// a closed curve `to` may be less than `from`: the part leads over its first point then. The
/// spline is the same one, by knots inserted. O(n). Throws InputError (BadOption) where a parameter
/// is not in [0, 1] or the part has no length, (NoPath) where the curve is not on the mesh.
[[nodiscard]] Curve partOfCurve(
    const Workpiece& workpiece,
    const Curve& curve,
    double from,
    double to,
    std::vector<int>* picks = nullptr
);

/// The parts between parameters in any order, which together are the whole: of an open curve from
/// its start on, of a closed one from the first parameter on. Throws likewise, and InputError
/// (BadOption) where there is no parameter.
[[nodiscard]] std::vector<Curve> partsOfCurve(
    const Workpiece& workpiece,
    const Curve& curve,
    std::span<const double> at,
    std::vector<std::vector<int>>* picks = nullptr
);

/// How two curves become one.
struct JoinOptions {
    /// They meet with one direction (G1); else at a corner where their directions differ.
    bool isSmooth = false;
    /// How far apart, in a straight line, the ends that are joined may be. A curve through both
    /// bridges the gap.
    MeshLength gap{.value = 1.0, .isInEdges = true};
    /// How much of either curve, but at most a third of it, a smooth bridge takes the place of. Not
    /// used where the curves meet with one direction already.
    MeshLength blend{.value = 3.0, .isInEdges = true};

    /// Throws InputError (BadOption).
    void validate() const;
};

/// Two open curves as one, by those of their ends that are nearest to each other; the result goes
/// the way of the first. Splines must have one degree. Outside of the bridge both stay what they
/// are. At a bridge's ends and where the curves meet the spline has knots whose multiplicity is the
/// degree. Where it is smooth, tangents are the same to rounding. A bridge takes as long as a curve
/// through two picks. Throws InputError (BadOption: a closed curve, other degrees, a gap that is
/// too wide; NoPath where no way leads over the gap), Cancelled.
[[nodiscard]] Curve joinedCurves(
    const Workpiece& workpiece,
    const Curve& first,
    const Curve& second,
    const JoinOptions& options = {},
    const Progress& progress = {}
);

/// A curve that goes on from its start and from its end by lengths (user's unit, >= 0; 0: it
/// stays), along the straightest geodesic with its tangent there, through points of which the rest
/// is drawn as the fairest curve. A boundary of the mesh ends it before. Tangents are the same to
/// rounding. Throws InputError (BadOption: a closed curve, a length that is none; NoPath where the
/// curve ends at a boundary that it would cross), Cancelled.
[[nodiscard]] Curve extendedCurve(
    const Workpiece& workpiece,
    const Curve& curve,
    double atStart,
    double atEnd,
    const Progress& progress = {}
);

}  // namespace bspline_curve
