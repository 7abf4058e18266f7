// SPDX-License-Identifier: GPL-3.0-or-later
// Curves joined and made longer.
#include "bspline_curve/pieces.h"
#include "python/core/arrays.h"
#include "python/core/bindings.h"
#include "python/core/python_progress.h"

#include <nanobind/stl/string.h>

#include <string>
#include <utility>

namespace bspline_curve::python {

namespace {

DesignedCurve joined(
    const Mesh& mesh,
    const DesignedCurve& first,
    const DesignedCurve& second,
    bool isSmooth,
    const std::string& gap,
    const std::string& blend,
    nb::object progress
) {
    const JoinOptions options{
        .isSmooth = isSmooth, .gap = parseLength(gap, "gap"), .blend = parseLength(blend, "blend")
    };
    return PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        return mesh->finished(
            joinedCurves(*mesh.workpiece, first.curve, second.curve, options, goesOn), {}
        );
    });
}

DesignedCurve extended(
    const Mesh& mesh, const DesignedCurve& curve, double atStart, double atEnd, nb::object progress
) {
    return PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        return mesh->finished(
            extendedCurve(*mesh.workpiece, curve.curve, atStart, atEnd, goesOn), {}
        );
    });
}

}  // namespace

void bindPieces(nb::module_& module) {
    module.def(
        "joined",
        joined,
        nb::arg(),
        nb::arg(),
        nb::arg(),
        nb::arg(),
        nb::arg(),
        nb::arg(),
        nb::arg().none()
    );
    module.def("extended", extended, nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg().none());
}

}  // namespace bspline_curve::python
