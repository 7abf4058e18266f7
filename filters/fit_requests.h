// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/options.h"
#include "filters/option_bindings.h"
#include "filters/requests.h"

namespace bspline_curve {

/// What the faces on both sides of a boundary differ in.
enum class FaceLabels {
    Selection,      ///< selected or not
    FaceQuality,    ///< rounded
    FaceColour,     ///< any difference
    VertexQuality,  ///< rounded, of most of a face's vertices
};

/// What a user of fitFilter() asked for.
struct FitRequest {
    LayerId surface;
    FaceLabels labels = FaceLabels::Selection;
    FitOptions fit;
    CurveRequest curve;  ///< of each curve: without field or faces to avoid
};

[[nodiscard]] Bindings<FitRequest> fitBindings();
[[nodiscard]] Bindings<FitOptions> fitOptionBindings();

/// The parameters that fitFilter() has from curveFilter().
[[nodiscard]] const std::vector<std::string>& fittedParameters();

/// Throws InputError (BadOption) naming the value and its range where a number is outside.
[[nodiscard]] FitRequest fitRequest(const ParameterValues& values);

}  // namespace bspline_curve
