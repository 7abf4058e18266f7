// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/core/imprint_data.h"

#include "design/designer_surface.h"
#include "fill/part_filling.h"
#include "fill/raised_parts.h"
#include "imprint/imprint.h"
#include "imprint/mesh_parts.h"
#include "imprint/part_choice.h"
#include "imprint/slits.h"
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

/// An imprint, and where it comes from in the mesh as the caller gave it.
struct Imprint {
    ImprintedMesh made;
    ImprintOrigins origins;
};

/// Without the GIL: curves do not change.
Imprint imprinted(
    const MeshDesigner& designer, const std::vector<const Curve*>& curves, double snap
) {
    const nb::gil_scoped_release unlocked;
    const Surface& surface = surfaceOf(designer.designer());
    Imprint result{
        .made = imprint(surface, designer.carried(curves), {.snap = snap}), .origins = {}
    };
    result.origins = originsOf(result.made, surface, designer.repair());
    return result;
}

nb::list curvesOf(const Imprint& imprint) {
    nb::list result;
    for (const ImprintedCurve& curve : imprint.made.curves) {
        result.append(arrayOf(std::vector<std::int32_t>(curve.vertices)));
    }
    return result;
}

nb::tuple originsTuple(const Imprint& imprint) {
    std::vector<std::int32_t> faces;
    std::vector<double> weights;
    for (const auto& [face, barycentric] : imprint.origins.newVertices) {
        faces.push_back(face);
        weights.insert(weights.end(), barycentric.begin(), barycentric.end());
    }
    return nb::make_tuple(arrayOf(std::move(faces)), arrayOf(std::move(weights), 3));
}

// (label of each face, [(faces, area, perimeter, centroid, euler) of each part]).
nb::tuple partsTuple(const Imprint& imprint) {
    MeshParts parts = [&] {
        const nb::gil_scoped_release unlocked;
        return partsOf(imprint.made);
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

// What to say of curves that part nothing; empty where there are none.
std::string slitNote(const Imprint& imprint, bool isCut) {
    const nb::gil_scoped_release unlocked;
    return describeSlits(slitsOf(imprint.made, partsOf(imprint.made)), isCut);
}

// (vertices, faces, imprinted vertex of each vertex) of the mesh opened along the curves.
nb::tuple cutTuple(const Imprint& imprint) {
    CutMesh cut = [&] {
        const nb::gil_scoped_release unlocked;
        return cutAlongCurves(imprint.made);
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
    const Imprint& imprint,
    const std::string& which,
    const std::vector<double>& seed,
    const std::string& fill,
    nb::object progress
) {
    FilledParts taken = PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        return partsMeant(imprint.made, choiceOf(which, seed), fill, goesOn);
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
    const Imprint& imprint, const std::string& which, const std::vector<double>& seed, double height
) {
    RaisedParts raised = [&] {
        const nb::gil_scoped_release unlocked;
        const MeshParts parts = partsOf(imprint.made);
        return raisedParts(
            imprint.made, parts, chosenParts(imprint.made, parts, choiceOf(which, seed)), height
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
        return
            [part](nb::handle self) { return viewOf(part(nb::cast<const Imprint&>(self)), self); };
    };
    nb::class_<Imprint>(module, "Imprint")
        .def_prop_ro("vertices", view([](const Imprint& i) -> auto& {
                         return i.made.mesh.vertices;
                     }))
        .def_prop_ro("faces", view([](const Imprint& i) -> auto& { return i.made.mesh.faces; }))
        .def_prop_ro("parents", view([](const Imprint& i) -> auto& { return i.origins.parents; }))
        .def_prop_ro("crossings", view([](const Imprint& i) -> auto& { return i.made.crossings; }))
        .def_prop_ro("curves", curvesOf)
        .def_prop_ro("origins", originsTuple)
        .def_prop_ro("largest_move", [](const Imprint& i) { return i.made.largestMove; })
        .def("parts", partsTuple)
        .def("slit_note", slitNote)
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
