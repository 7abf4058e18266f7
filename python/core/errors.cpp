// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/core/errors.h"

#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <exception>
#include <stdexcept>

namespace bspline_curve::python {

namespace {

namespace nb = nanobind;

const char* nameOf(InputErrorCode code) {
    switch (code) {
        case InputErrorCode::EmptyMesh:
            return "empty-mesh";
        case InputErrorCode::NonFiniteCoordinate:
            return "non-finite-coordinate";
        case InputErrorCode::IndexOutOfRange:
            return "index-out-of-range";
        case InputErrorCode::DegenerateFace:
            return "degenerate-face";
        case InputErrorCode::NonManifoldEdge:
            return "non-manifold-edge";
        case InputErrorCode::NonManifoldVertex:
            return "non-manifold-vertex";
        case InputErrorCode::InconsistentOrientation:
            return "inconsistent-orientation";
        case InputErrorCode::SelfIntersection:
            return "self-intersection";
        case InputErrorCode::TooFewPicks:
            return "too-few-picks";
        case InputErrorCode::PickTooFar:
            return "pick-too-far";
        case InputErrorCode::CoincidentPicks:
            return "coincident-picks";
        case InputErrorCode::PicksOnDifferentComponents:
            return "picks-on-different-components";
        case InputErrorCode::PickAvoided:
            return "pick-avoided";
        case InputErrorCode::NoPath:
            return "no-path";
        case InputErrorCode::BadField:
            return "bad-field";
        case InputErrorCode::BadOption:
            return "bad-option";
        case InputErrorCode::UnreadableFile:
            return "unreadable-file";
        case InputErrorCode::UnwritableFile:
            return "unwritable-file";
        case InputErrorCode::NoShell:
            return "no-shell";
    }
    throw std::logic_error("an error code without a name");
}

nb::object packageErrors() {
    return nb::module_::import_("bspline_curve._errors");
}

void translate(const std::exception_ptr& thrown, void* /*unused*/) {
    try {
        std::rethrow_exception(thrown);
    } catch (const InputError& error) {
        const nb::object made = packageErrors().attr("input_error")(
            nameOf(error.code()), error.what(), error.elements()
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
