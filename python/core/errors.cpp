// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "python/core/bindings.h"

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <exception>
#include <stdexcept>
#include <utility>

namespace bspline_curve::python {

namespace {

namespace nb = nanobind;

constexpr std::array kNames{
    std::pair(InputErrorCode::EmptyMesh, "empty-mesh"),
    std::pair(InputErrorCode::NonFiniteCoordinate, "non-finite-coordinate"),
    std::pair(InputErrorCode::IndexOutOfRange, "index-out-of-range"),
    std::pair(InputErrorCode::DegenerateFace, "degenerate-face"),
    std::pair(InputErrorCode::NonManifoldEdge, "non-manifold-edge"),
    std::pair(InputErrorCode::NonManifoldVertex, "non-manifold-vertex"),
    std::pair(InputErrorCode::InconsistentOrientation, "inconsistent-orientation"),
    std::pair(InputErrorCode::SelfIntersection, "self-intersection"),
    std::pair(InputErrorCode::TooFewPicks, "too-few-picks"),
    std::pair(InputErrorCode::PickTooFar, "pick-too-far"),
    std::pair(InputErrorCode::CoincidentPicks, "coincident-picks"),
    std::pair(InputErrorCode::PicksOnDifferentComponents, "picks-on-different-components"),
    std::pair(InputErrorCode::PickAvoided, "pick-avoided"),
    std::pair(InputErrorCode::NoPath, "no-path"),
    std::pair(InputErrorCode::BadField, "bad-field"),
    std::pair(InputErrorCode::BadOption, "bad-option"),
    std::pair(InputErrorCode::UnreadableFile, "unreadable-file"),
    std::pair(InputErrorCode::UnwritableFile, "unwritable-file"),
    std::pair(InputErrorCode::NoShell, "no-shell"),
};

const char* nameOf(InputErrorCode code) {
    for (const auto& [known, name] : kNames) {
        if (code == known) {
            return name;
        }
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
            nameOf(error.code()),
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
