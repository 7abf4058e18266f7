// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/core/offset_data.h"

#include "bspline_curve/curve.h"
#include "design/designer_surface.h"
#include "offset/offset_curves.h"
#include "python/core/arrays.h"
#include "python/core/mesh_designer.h"

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

// Lines at a distance, each with itself as its spline.
std::vector<Curve> offsetCurves(
    const MeshDesigner& designer, const Curve& curve, double distance, const std::string& side
) {
    const nb::gil_scoped_release unlocked;
    std::vector<Curve> result;
    for (SurfacePolyline& piece : offsetPolylines(
             surfaceOf(designer.designer()), curve.polyline, optionsOf(distance, side)
         )) {
        Curve made;
        made.spline = polygonSpline(piece);
        made.polyline = std::move(piece);
        made.report.usable = true;
        result.push_back(std::move(made));
    }
    return result;
}

Array facesNear(
    const MeshDesigner& designer, const Curve& curve, double distance, const std::string& side
) {
    std::vector<std::uint8_t> within;
    {
        const nb::gil_scoped_release unlocked;
        for (const char isWithin : facesWithin(
                 surfaceOf(designer.designer()), curve.polyline, optionsOf(distance, side)
             )) {
            within.push_back(isWithin != 0 ? 1 : 0);
        }
    }
    return arrayOf(std::move(within));
}

}  // namespace

void bindOffset(nb::module_& module) {
    module.def("offset", offsetCurves);
    module.def("faces_within", facesNear);
}

}  // namespace bspline_curve::python
