// SPDX-License-Identifier: GPL-3.0-or-later
// The module bspline_curve._core: what the Python files of the package are made on.
#include "bspline_curve/designer.h"
#include "bspline_curve/field.h"
#include "bspline_curve/version.h"
#include "design/designer_surface.h"
#include "design/mended_designer.h"
#include "python/core/arrays.h"
#include "python/core/curve_data.h"
#include "python/core/drawing_data.h"
#include "python/core/errors.h"
#include "python/core/imprint_data.h"
#include "python/core/mesh_designer.h"
#include "python/core/offset_data.h"
#include "python/core/option_values.h"
#include "python/core/pattern_data.h"
#include "python/core/python_progress.h"
#include "surface/repair.h"

#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace bspline_curve::python {

namespace {

template <class Array>
auto spanOf(const std::optional<Array>& given) {
    return given ? std::span(given->data(), given->shape(0)) : std::span<typename Array::Scalar>();
}

template <class Faces>
void makeDesigner(
    MeshDesigner* place,
    const Points& vertices,
    const Faces& faces,
    const nb::dict& options,
    nb::object progress
) {
    const ShellOptions shell = shellOptions(options);
    const MendingOptions mending{
        .strict = options.contains("strict") && nb::cast<bool>(options["strict"]),
        .weld = options.contains("weld") ? nb::cast<double>(options["weld"]) : 0.0
    };
    PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        const auto given = [&] { return TriangleMesh{toVectors(vertices), toTriangles(faces)}; };
        Mended<CurveDesigner> made = makeMendedDesigner(given(), mending, shell, goesOn);
        const bool isMended = made.mending.has_value();
        new (place) MeshDesigner(std::move(made), isMended ? given() : TriangleMesh());
    });
}

Curve design(
    const MeshDesigner& designer,
    const Points& picks,
    const nb::dict& options,
    const std::optional<Values>& field,
    const std::optional<Ids>& avoid,
    const Curve* start,
    nb::object progress
) {
    const CurveOptions chosen = curveOptions(options);
    const std::vector<Vec3> through = toVectors(picks);
    const CurveInputs inputs{.field = spanOf(field), .avoid = spanOf(avoid), .start = start};
    return PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        return designer.design(through, chosen.solver, chosen.sampling, inputs, goesOn);
    });
}

Array fieldOf(
    const MeshDesigner& designer,
    const nb::dict& options,
    const std::optional<Values>& quality,
    const std::optional<Ids>& region,
    nb::object progress
) {
    const FieldOptions chosen = fieldOptions(options);
    const FieldInputs inputs{.quality = spanOf(quality), .region = spanOf(region)};
    return arrayOf(PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        return designer.field(chosen, inputs, goesOn);
    }));
}

// (faces, barycentrics, positions, distances) of the closest points.
nb::tuple project(const MeshDesigner& designer, const Points& queries) {
    const std::vector<Vec3> points = toVectors(queries);
    std::vector<std::int32_t> faces;
    std::vector<double> weights;
    std::vector<double> positions;
    std::vector<double> distances;
    {
        const nb::gil_scoped_release unlocked;
        for (const Vec3& query : points) {
            const TriangleTree::Closest closest = designer.closestPoint(query);
            const Vec3& barycentric = closest.point.barycentric;
            faces.push_back(closest.point.face);
            weights.insert(weights.end(), barycentric.begin(), barycentric.end());
            positions.insert(positions.end(), closest.position.begin(), closest.position.end());
            distances.push_back(std::sqrt(closest.squaredDistance));
        }
    }
    return nb::make_tuple(
        arrayOf(std::move(faces)),
        arrayOf(std::move(weights), 3),
        arrayOf(std::move(positions), 3),
        arrayOf(std::move(distances))
    );
}

// ((vertices, faces) of the top, those of the bottom).
nb::tuple shellLayers(const MeshDesigner& designer) {
    const ShellLayers layers = [&] {
        const nb::gil_scoped_release unlocked;
        return designer.designer().shellLayers();
    }();
    return nb::make_tuple(arraysOf(layers.top), arraysOf(layers.bottom));
}

template <class Faces>
nb::tuple repaired(const Points& vertices, const Faces& faces, double weld) {
    const MeshRepair repair = [&] {
        const nb::gil_scoped_release unlocked;
        return repairMesh({toVectors(vertices), toTriangles(faces)}, weld);
    }();
    const RepairReport& report = repair.report;
    nb::dict changes;
    nb::dict merged;
    for (const auto& [from, to] : report.mergedVertices) {
        merged[nb::int_(from)] = to;
    }
    nb::dict copies;
    for (const RepairReport::DuplicatedVertex& duplicated : report.duplicatedVertices) {
        copies[nb::int_(duplicated.vertex)] = duplicated.copies;
    }
    nb::list cuts;
    for (const auto& [a, b] : report.cutEdges) {
        cuts.append(nb::make_tuple(a, b));
    }
    changes["merged_vertices"] = merged;
    changes["removed_degenerate_faces"] = report.removedDegenerateFaces;
    changes["split_faces"] = report.splitFaces;
    changes["removed_duplicate_faces"] = report.removedDuplicateFaces;
    changes["reversed_faces"] = report.reversedFaces;
    changes["cut_edges"] = cuts;
    changes["duplicated_vertices"] = copies;
    const nb::tuple mesh = arraysOf(repair.mesh);
    return nb::make_tuple(mesh[0], mesh[1], changes, report.summary());
}

std::string naturalCostOf(const std::string& kind) {
    for (const FieldKind each : kFieldKinds) {
        if (kind == name(each)) {
            return name(naturalCost(each));
        }
    }
    throw nb::value_error(("no kind of field is called " + kind).c_str());
}

nb::dict secondsOf(const MeshDesigner& designer) {
    const StageSeconds seconds = designer.designer().seconds();
    nb::dict result;
    result["validate"] = seconds.validate;
    result["tree"] = seconds.tree;
    result["shell"] = seconds.shell;
    return result;
}

void bindDesigner(nb::module_& module) {
    nb::class_<MeshDesigner>(module, "Designer")
        .def("__init__", makeDesigner<Faces32>, nb::arg(), nb::arg(), nb::arg(), nb::arg().none())
        .def("__init__", makeDesigner<Faces64>, nb::arg(), nb::arg(), nb::arg(), nb::arg().none())
        .def_prop_ro(
            "vertices",
            [](nb::handle self) {
                return viewOf(nb::cast<const MeshDesigner&>(self).mesh().vertices, self);
            }
        )
        .def_prop_ro(
            "faces",
            [](nb::handle self) {
                return viewOf(nb::cast<const MeshDesigner&>(self).mesh().faces, self);
            }
        )
        .def_prop_ro("seconds", secondsOf)
        .def_prop_ro("mending", &MeshDesigner::mendingNote)
        .def_prop_ro(
            "diagonal", [](const MeshDesigner& d) { return surfaceOf(d.designer()).diagonal(); }
        )
        .def_prop_ro(
            "components",
            [](const MeshDesigner& d) { return surfaceOf(d.designer()).componentCount(); }
        )
        .def(
            "design",
            design,
            nb::arg(),
            nb::arg(),
            nb::arg().none(),
            nb::arg().none(),
            nb::arg().none(),
            nb::arg().none()
        )
        .def("field", fieldOf, nb::arg(), nb::arg().none(), nb::arg().none(), nb::arg().none())
        .def("project", project)
        .def("shell_layers", shellLayers);
}

}  // namespace

NB_MODULE(_core, module) {
    registerErrors();
    bindCurve(module);
    bindDesigner(module);
    bindDrawing(module);
    bindImprint(module);
    bindOffset(module);
    bindPattern(module);
    module.attr("__version__") = BSPLINE_CURVE_VERSION;
    module.def("repaired", repaired<Faces32>);
    module.def("repaired", repaired<Faces64>);
    module.def("natural_cost", naturalCostOf);
}

}  // namespace bspline_curve::python
