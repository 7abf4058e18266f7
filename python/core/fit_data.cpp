// SPDX-License-Identifier: GPL-3.0-or-later
// Curves along lines that exist, and boundaries of labels.
#include "bspline_curve/lines.h"
#include "python/core/arrays.h"
#include "python/core/bindings.h"
#include "python/core/option_values.h"
#include "python/core/python_progress.h"

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <string>
#include <utility>
#include <vector>

namespace bspline_curve::python {

namespace {

// `deviation`: "0": by the line's own noise.
DesignedCurve fit(
    const Mesh& mesh,
    const Points& line,
    const nb::dict& options,
    const std::string& deviation,
    double cornerAngle,
    nb::object progress
) {
    const CurveOptions chosen = curveOptions(options);
    const FitOptions wanted{parseLength(deviation, "deviation"), cornerAngle};
    const std::vector<Vec3> points = toVectors(line);
    return PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        return mesh->fit(points, wanted, chosen, goesOn);
    });
}

// Of each line (vertices, whether it is closed, the labels on its left and right).
std::vector<nb::tuple> boundaries(const Mesh& mesh, const Ids& labels) {
    const std::vector<int> values = toVector(std::optional(labels));
    const std::vector<BoundaryLine> lines = [&] {
        const nb::gil_scoped_release unlocked;
        return boundaryLines(mesh->mesh(), values);
    }();
    std::vector<nb::tuple> found;
    for (const BoundaryLine& line : lines) {
        found.push_back(nb::make_tuple(arrayOf(line.vertices), line.closed, line.left, line.right));
    }
    return found;
}

}  // namespace

void bindFits(nb::module_& module) {
    module.def("fit", fit, nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg().none());
    module.def("boundaries", boundaries);
}

}  // namespace bspline_curve::python
