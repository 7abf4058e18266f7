// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nanobind/nanobind.h>

namespace bspline_curve::python {

/// Adds the class Imprint: arrays of an imprinted mesh, and its parts.
void bindImprint(nanobind::module_& module);

}  // namespace bspline_curve::python
