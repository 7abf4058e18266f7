// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/options.h"
#include "projection/projected_curve.h"
#include "solver/curve_problem.h"
#include "surface/surface.h"

#include <string>

namespace bspline_curve {

/// The polyline strictly on the surface (end of Sect. 4.4): crossings of edges, picks and samples
/// of the shadow. Consecutive vertices always share a face. O(n log n) in the number of vertices.
[[nodiscard]] SurfacePolyline makeStrictPolyline(
    const Surface& surface,
    const CurveProblem& problem,
    const ProjectedCurve& shadow,
    const SamplingOptions& sampling
);

/// Whether every segment of a polyline lies in one face of the surface: by the faces and
/// barycentric coordinates of its ends, not by positions, so that the sides of the thinnest plate
/// are two. O(n).
[[nodiscard]] bool isStrict(const Surface& surface, const SurfacePolyline& line);

/// Throws InputError (NoPath) where a curve on a mended mesh is not strict: if it was drawn there,
/// it passes from sheet to sheet where mending has parted them. `curve` names it.
void checkUnparted(const Surface& mended, const SurfacePolyline& line, const std::string& curve);

/// The length of a polyline, with the segment that closes it.
[[nodiscard]] double lengthOf(const SurfacePolyline& line);

}  // namespace bspline_curve
