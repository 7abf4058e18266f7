// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/pieces.h"
#include "filters/imprint_requests.h"
#include "filters/option_bindings.h"

#include <string>
#include <vector>

namespace bspline_curve {

enum class CurveEdit { Join, Split, Trim, Extend, Reverse };
enum class CurveEnds { End, Start, Both };

/// What a user of editFilter() asked for.
struct EditRequest {
    CurveUse use;
    CurveEdit edit = CurveEdit::Join;
    std::string at = "0.25, 0.75";   ///< parameters, of Split and Trim
    std::vector<double> parameters;  ///< the same
    double extension = 0.0;          ///< 0: kExtensionRelative
    CurveEnds ends = CurveEnds::End;
    JoinOptions join;
};

/// The length of an extension if none is given, relative to the diagonal.
inline constexpr double kExtensionRelative = 0.02;

[[nodiscard]] Bindings<EditRequest> editBindings();
[[nodiscard]] Bindings<JoinOptions> joinBindings();

/// Throws InputError (BadOption) naming the value and its range where a number is outside, or where
/// `at` is no list of parameters, or not of two for Trim.
[[nodiscard]] EditRequest editRequest(const ParameterValues& values);

}  // namespace bspline_curve
