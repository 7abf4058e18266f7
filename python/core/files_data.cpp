// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/files.h"
#include "python/core/arrays.h"
#include "python/core/bindings.h"

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace bspline_curve::python {

namespace {

/// The bytes of a file of a curve; `end`: of its name, `field` has a value for each point of the
/// polyline or none.
nb::bytes bytesOfCurve(
    const DesignedCurve& drawn, const std::string& end, const Values& field, const std::string& unit
) {
    const std::optional<LengthUnit> named = lengthUnitOf(unit);
    if (!named) {
        throw nb::value_error("the unit is not known");
    }
    const std::string bytes =
        curveBytes("curve" + end, drawn.curve, {field.data(), field.shape(0)}, {}, *named);
    return nb::bytes(bytes.data(), bytes.size());
}

// (vertices, faces, a value for each vertex or none)
nb::tuple readMesh(const std::filesystem::path& file) {
    MeshFile read = [&] {
        const nb::gil_scoped_release unlocked;
        return readMeshFile(file, RepeatedVertices::Keep);
    }();
    return nb::make_tuple(
        arrayOf(std::move(read.mesh.vertices)),
        arrayOf(std::move(read.mesh.faces)),
        arrayOf(std::move(read.quality))
    );
}

}  // namespace

void bindFiles(nb::module_& module) {
    module.def("curve_extensions", curveExtensions);
    module.def("curve_bytes", bytesOfCurve);
    module.def("read_mesh", readMesh);
}

}  // namespace bspline_curve::python
