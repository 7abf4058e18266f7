// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nanobind/nanobind.h>

namespace bspline_curve::python {

/// Makes DrawingSession a class of the module: events in, what is to be seen out, as arrays.
void bindDrawing(nanobind::module_& module);

}  // namespace bspline_curve::python
