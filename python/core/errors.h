// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace bspline_curve::python {

/// Makes errors of the core those of the package: InputError becomes what
/// bspline_curve._errors.input_error(code, message, elements) returns, Cancelled becomes
/// bspline_curve.Cancelled.
void registerErrors();

}  // namespace bspline_curve::python
