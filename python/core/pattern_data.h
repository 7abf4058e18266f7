// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nanobind/nanobind.h>

namespace bspline_curve::python {

namespace nb = nanobind;

/// Drawings, and the function that carries them to a surface.
void bindPattern(nb::module_& module);

}  // namespace bspline_curve::python
