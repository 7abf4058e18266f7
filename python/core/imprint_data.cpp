// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/core/imprint_data.h"

#include "design/designer_surface.h"
#include "fill/part_filling.h"
#include "fill/raised_parts.h"
#include "imprint/imprint.h"
#include "imprint/mesh_parts.h"
#include "imprint/part_choice.h"
#include "python/core/arrays.h"
#include "python/core/mesh_designer.h"
#include "python/core/python_progress.h"

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve::python {

namespace {

/// Without the GIL: curves do not change.
ImprintedMesh imprinted(
    const MeshDesigner& designer, const std::vector<const Curve*>& curves, double snap
) {
    const nb::gil_scoped_release unlocked;
    std::vector<SurfacePolyline> lines;
    lines.reserve(curves.size());
    for (const Curve* curve : curves) {
        lines.push_back(curve->polyline);
    }
    return imprint(surfaceOf(designer.designer()), lines, {.snap = snap});
}

nb::list curvesOf(const ImprintedMesh& imprint) {
    nb::list result;
    for (const ImprintedCurve& curve : imprint.curves) {
        result.append(arrayOf(std::vector<std::int32_t>(curve.vertices)));
    }
    return result;
}

nb::tuple originsOf(const ImprintedMesh& imprint) {
    std::vector<std::int32_t> faces;
    std::vector<double> weights;
    for (const auto& [face, barycentric] : imprint.newVertices) {
        faces.push_back(face);
        weights.insert(weights.end(), barycentric.begin(), barycentric.end());
    }
    return nb::make_tuple(arrayOf(std::move(faces)), arrayOf(std::move(weights), 3));
}

// (label of each face, [(faces, area, perimeter, centroid, euler) of each part]).
nb::tuple partsTuple(const ImprintedMesh& imprint) {
    MeshParts parts = [&] {
        const nb::gil_scoped_release unlocked;
        return partsOf(imprint);
    }();
    nb::list list;
    for (const MeshPart& part : parts.parts) {
        list.append(
            nb::make_tuple(
                part.faces,
                part.area,
                part.perimeter,
                nb::make_tuple(part.centroid.x(), part.centroid.y(), part.centroid.z()),
                part.euler
            )
        );
    }
    return nb::make_tuple(arrayOf(std::move(parts.labels)), list);
}

// (vertices, faces, imprinted vertex of each vertex) of the mesh opened along the curves.
nb::tuple cutTuple(const ImprintedMesh& imprint) {
    CutMesh cut = [&] {
        const nb::gil_scoped_release unlocked;
        return cutAlongCurves(imprint);
    }();
    const nb::tuple arrays = arraysOf(cut.mesh);
    return nb::make_tuple(arrays[0], arrays[1], arrayOf(std::move(cut.origin)));
}

PartChoice choiceOf(const std::string& which, const std::vector<double>& seed) {
    using Which = PartChoice::Which;
    if (which == "seed") {
        return {.which = Which::Seed, .seed = Vec3(seed.at(0), seed.at(1), seed.at(2))};
    }
    return {
        .which = which == "largest"    ? Which::Largest
                 : which == "smallest" ? Which::Smallest
                                       : Which::Inside
    };
}

// Chosen parts opened along the curves, or with their holes filled; origins and labels of what is
// new are -1.
FilledParts partsMeant(
    const ImprintedMesh& imprint,
    const PartChoice& choice,
    const std::string& fill,
    const Progress& progress
) {
    const MeshParts parts = partsOf(imprint);
    std::optional<FillShape> shape;
    if (fill != "none") {
        shape = fill == "flat" ? FillShape::Flat : FillShape::Smooth;
    }
    const std::vector<int> chosen = chosenParts(imprint, parts, choice);
    return takenParts(imprint, cutAlongCurves(imprint), parts, chosen, shape, progress);
}

// (vertices, faces, imprinted vertex of each vertex, part of each face, rims left open).
nb::tuple takeTuple(
    const ImprintedMesh& imprint,
    const std::string& which,
    const std::vector<double>& seed,
    const std::string& fill,
    nb::object progress
) {
    FilledParts taken = PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        return partsMeant(imprint, choiceOf(which, seed), fill, goesOn);
    });
    const nb::tuple arrays = arraysOf(taken.mesh);
    return nb::make_tuple(
        arrays[0],
        arrays[1],
        arrayOf(std::move(taken.origin)),
        arrayOf(std::move(taken.labels)),
        taken.openRims
    );
}

// (vertices, faces, imprinted vertex of each vertex, part of each face, faces turned over).
nb::tuple reliefTuple(
    const ImprintedMesh& imprint,
    const std::string& which,
    const std::vector<double>& seed,
    double height
) {
    RaisedParts raised = [&] {
        const nb::gil_scoped_release unlocked;
        const MeshParts parts = partsOf(imprint);
        return raisedParts(
            imprint, parts, chosenParts(imprint, parts, choiceOf(which, seed)), height
        );
    }();
    const nb::tuple arrays = arraysOf(raised.whole.mesh);
    return nb::make_tuple(
        arrays[0],
        arrays[1],
        arrayOf(std::move(raised.whole.origin)),
        arrayOf(std::move(raised.whole.labels)),
        raised.turnedFaces
    );
}

}  // namespace

void bindImprint(nb::module_& module) {
    const auto view = [](auto part) {
        return [part](nb::handle self) {
            return viewOf(part(nb::cast<const ImprintedMesh&>(self)), self);
        };
    };
    nb::class_<ImprintedMesh>(module, "Imprint")
        .def_prop_ro("vertices", view([](const ImprintedMesh& m) -> auto& {
                         return m.mesh.vertices;
                     }))
        .def_prop_ro("faces", view([](const ImprintedMesh& m) -> auto& { return m.mesh.faces; }))
        .def_prop_ro("parents", view([](const ImprintedMesh& m) -> auto& { return m.parents; }))
        .def_prop_ro("crossings", view([](const ImprintedMesh& m) -> auto& { return m.crossings; }))
        .def_prop_ro("curves", curvesOf)
        .def_prop_ro("origins", originsOf)
        .def_ro("largest_move", &ImprintedMesh::largestMove)
        .def("parts", partsTuple)
        .def("cut", cutTuple)
        .def(
            "take",
            takeTuple,
            nb::arg("which"),
            nb::arg("seed"),
            nb::arg("fill"),
            nb::arg("progress").none()
        )
        .def("relief", reliefTuple);
    module.def("imprint", imprinted);
}

}  // namespace bspline_curve::python
