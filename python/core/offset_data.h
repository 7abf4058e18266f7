// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nanobind/nanobind.h>

namespace bspline_curve::python {

/// Adds the functions on what lies at a distance from a curve.
void bindOffset(nanobind::module_& module);

}  // namespace bspline_curve::python
