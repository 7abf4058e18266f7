// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/field.h"
#include "bspline_curve/options.h"
#include "bspline_curve/shell.h"

#include <nanobind/nanobind.h>

namespace bspline_curve::python {

/// What a user of mesh.curve() chose: a dict of ids of parameters (filters.json) and values of
/// their types, which the package has checked; what is not in it keeps its default.
struct CurveOptions {
    SolverOptions solver;
    SamplingOptions sampling;
};

/// All throw InputError (BadOption) as validate() does.
[[nodiscard]] CurveOptions curveOptions(const nanobind::dict& values);
[[nodiscard]] ShellOptions shellOptions(const nanobind::dict& values);
[[nodiscard]] FieldOptions fieldOptions(const nanobind::dict& values);

}  // namespace bspline_curve::python
