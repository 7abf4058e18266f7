// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"

#include <nanobind/nanobind.h>

namespace bspline_curve::python {

/// Makes Curve a class of the module: its parts as read-only arrays that share its memory, its
/// report, and what pickling needs.
void bindCurve(nanobind::module_& module);

}  // namespace bspline_curve::python
