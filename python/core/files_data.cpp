// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/files.h"
#include "io/curve_formats.h"
#include "python/core/arrays.h"
#include "python/core/bindings.h"

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace bspline_curve::python {

namespace {

/// Ends of the names of files that curveBytes() writes; a name has the first one that it ends with.
std::vector<std::string> curveEnds() {
    std::vector<std::string> ends;
    for (const CurveFormat& format : curveFormatsWithoutJson()) {
        ends.emplace_back(format.end);
    }
    return ends;
}

/// The bytes of a file of a curve; `end` is one of curveEnds(), `field` has a value for each point
/// of the polyline or none.
nb::bytes curveBytes(
    const DesignedCurve& drawn, const std::string& end, const Values& field, const std::string& unit
) {
    const std::span<const CurveFormat> formats = curveFormatsWithoutJson();
    const auto format = std::ranges::find(formats, end, &CurveFormat::end);
    const auto* const named = std::ranges::find(kLengthUnits, unit, &LengthUnitNames::id);
    if (format == formats.end() || named == kLengthUnits.end()) {
        throw nb::value_error("the format or the unit is not known");
    }
    const std::string bytes = format->bytes(
        {.curve = drawn.curve, .field = {field.data(), field.shape(0)}, .unit = named->unit}
    );
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
    module.def("curve_ends", curveEnds);
    module.def("curve_bytes", curveBytes);
    module.def("read_mesh", readMesh);
}

}  // namespace bspline_curve::python
