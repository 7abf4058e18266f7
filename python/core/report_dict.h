// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"

#include <nanobind/nanobind.h>

namespace bspline_curve::python {

/// All of a report and what else is known of how a curve came about, as dicts, lists, numbers and
/// text.
[[nodiscard]] nanobind::dict reportDict(const Curve& curve);

}  // namespace bspline_curve::python
