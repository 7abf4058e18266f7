// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "python/core/bindings.h"

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <exception>

namespace bspline_curve::python {

namespace {

namespace nb = nanobind;

nb::object packageErrors() {
    return nb::module_::import_("bspline_curve._errors");
}

void translate(const std::exception_ptr& thrown, void* /*unused*/) {
    try {
        std::rethrow_exception(thrown);
    } catch (const InputError& error) {
        const nb::object made = packageErrors().attr("input_error")(
            name(error.code()),
            withRemedy(error.what(), error.remedy(), kRemedyWords),
            error.elements()
        );
        PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(made.ptr())), made.ptr());
    } catch (const Cancelled& cancelled) {
        PyErr_SetString(packageErrors().attr("Cancelled").ptr(), cancelled.what());
    }
}

}  // namespace

void registerErrors() {
    nb::register_exception_translator(translate);
}

}  // namespace bspline_curve::python
