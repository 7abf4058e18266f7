// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve_options.h"

#include <nanobind/nanobind.h>

// What a user chose: a dict of ids of parameters (filters.json) and values of their types, which
// the package has checked; what is not in it keeps its default. All throw InputError (BadOption) as
// validate() does.
namespace bspline_curve::python {

[[nodiscard]] CurveOptions curveOptions(const nanobind::dict& values);
[[nodiscard]] PreparingOptions preparingOptions(const nanobind::dict& values);
[[nodiscard]] FieldOptions fieldOptions(const nanobind::dict& values);

}  // namespace bspline_curve::python
