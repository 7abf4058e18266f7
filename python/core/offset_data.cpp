// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/core/offset_data.h"

#include "bspline_curve/curve.h"
#include "bspline_curve/shell.h"
#include "design/curve_on_given_mesh.h"
#include "design/designer_surface.h"
#include "offset/offset_curves.h"
#include "python/core/arrays.h"
#include "python/core/mesh_designer.h"
#include "python/core/python_progress.h"
#include "shell/extended_surface.h"

#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve::python {

namespace {

OffsetOptions optionsOf(double distance, const std::string& side) {
    return {
        .distance = distance,
        .sides = side == "left"    ? OffsetSides::Left
                 : side == "right" ? OffsetSides::Right
                                   : OffsetSides::Both
    };
}

/// With the largest deviation of each, in distances.
std::vector<std::pair<Curve, double>> curvesBeside(
    const MeshDesigner& designer,
    const Curve& curve,
    double distance,
    const std::string& side,
    nb::object progress
) {
    std::vector<FittedLine> pieces =
        PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
            const Surface& surface = surfaceOf(designer.designer());
            const ExtendedSurface extended = extendSurface(surface, ShellOptions().smoothingPasses);
            const SurfacePolyline line = designer.carried({&curve}).front();
            return offsetCurves(surface, extended, line, optionsOf(distance, side), goesOn);
        });
    std::vector<std::pair<Curve, double>> result;
    for (FittedLine& piece : pieces) {
        Curve made;
        made.spline = std::move(piece.spline);
        made.polyline = std::move(piece.line);
        bringBack(made, designer.repair());
        made.report.usable = true;
        result.emplace_back(std::move(made), piece.deviation);
    }
    return result;
}

Array facesNear(
    const MeshDesigner& designer,
    const Curve& curve,
    double distance,
    const std::string& side,
    nb::object progress
) {
    std::vector<char> within = PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        const Surface& surface = surfaceOf(designer.designer());
        const SurfacePolyline line = designer.carried({&curve}).front();
        return facesWithin(surface, line, optionsOf(distance, side), goesOn);
    });
    within = flagsOfGiven(std::move(within), designer.mesh().faces.size(), designer.repair());
    return arrayOf(std::vector<std::uint8_t>(within.begin(), within.end()));
}

}  // namespace

void bindOffset(nb::module_& module) {
    const auto define = [&](const char* name, auto* function) {
        module.def(
            name,
            function,
            nb::arg("designer"),
            nb::arg("curve"),
            nb::arg("distance"),
            nb::arg("side"),
            nb::arg("progress").none()
        );
    };
    define("offset", curvesBeside);
    define("faces_within", facesNear);
}

}  // namespace bspline_curve::python
