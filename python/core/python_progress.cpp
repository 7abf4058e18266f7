// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/core/python_progress.h"

namespace bspline_curve::python {

bool PythonProgress::goesOn(double fraction, const char* stage) {
    const Clock::time_point now = Clock::now();
    if (now < next_) {
        return true;
    }
    next_ = now + kLook;
    const nb::gil_scoped_acquire locked;
    try {
        if (PyErr_CheckSignals() != 0) {
            throw nb::python_error();
        }
        return callable_.is_none() || !callable_(fraction, stage).is(Py_False);
    } catch (const nb::python_error&) {
        raised_ = std::current_exception();
        return false;
    }
}

}  // namespace bspline_curve::python
