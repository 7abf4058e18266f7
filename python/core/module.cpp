// SPDX-License-Identifier: GPL-3.0-or-later
// The module bspline_curve._core: what the Python files of the package are made on.
#include "bspline_curve/curve_options.h"
#include "bspline_curve/mesh.h"
#include "bspline_curve/progress.h"
#include "bspline_curve/version.h"
#include "python/core/arrays.h"
#include "python/core/bindings.h"
#include "python/core/option_values.h"
#include "python/core/python_progress.h"

#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve::python {

namespace {

template <class Id>
void makeMesh(
    Mesh* place,
    const Points& vertices,
    const Rows<Id, 3>& faces,
    const nb::dict& options,
    nb::object progress
) {
    constexpr double kSurfaceShare = 0.2;  // for progress only
    const PreparingOptions preparing = preparingOptions(options);
    PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        auto workpiece = std::make_shared<const Workpiece>(
            TriangleMesh{toVectors(vertices), toTriangles(faces)},
            preparing,
            partOf(goesOn, 0.0, kSurfaceShare)
        );
        workpiece->prepare(partOf(goesOn, kSurfaceShare, 1.0));
        new (place) Mesh{std::move(workpiece)};
    });
}

DesignedCurve draw(
    const Mesh& mesh,
    const Points& picks,
    const nb::dict& options,
    const ScalarField* field,
    const std::optional<Ids>& avoid,
    const DesignedCurve* start,
    nb::object progress
) {
    const CurveOptions chosen = curveOptions(options);
    const std::vector<Vec3> through = toVectors(picks);
    const std::vector<int> avoided = toVector(avoid);
    const std::vector<int> corners = chosen.corners.of(through.size());
    const std::vector<PickTangent> tangents = chosen.tangents.of(through.size());
    const std::vector<MeshLength> tolerances = chosen.pickTolerances.within(through.size());
    const std::vector<double> weights = chosen.pickTolerances.weights(through.size());
    const CurveInputs inputs{
        .field = field != nullptr ? *field : ScalarField(),
        .avoid = avoided,
        .pickTolerances = tolerances,
        .pickWeights = weights,
        .corners = corners,
        .tangents = tangents,
        .start = start != nullptr ? &start->curve : nullptr
    };
    return PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        return mesh->draw(through, chosen.solver, chosen.sampling, inputs, goesOn);
    });
}

ScalarField madeField(
    const Mesh& mesh,
    const nb::dict& options,
    const std::optional<Values>& quality,
    const std::optional<Ids>& region,
    nb::object progress
) {
    FieldRequest request;
    request.options = fieldOptions(options);
    request.region.by = FaceChoice::By::Ids;
    request.region.ids = toVector(region);
    request.values = toVector(quality);
    return PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        return mesh->field({}, request, goesOn);
    });
}

// ((faces, barycentrics), positions, distances) of the closest points.
nb::tuple project(const Mesh& mesh, const Points& queries) {
    std::vector<SurfacePoint> places;
    std::vector<Vec3> positions;
    std::vector<double> distances;
    {
        const nb::gil_scoped_release unlocked;
        for (const Vec3& query : toVectors(queries)) {
            const ClosestPoint closest = mesh->closestPoint(query);
            places.push_back(closest.place);
            positions.push_back(closest.position);
            distances.push_back(closest.distance);
        }
    }
    return nb::make_tuple(
        placesOf(places), arrayOf(std::move(positions)), arrayOf(std::move(distances))
    );
}

// ((vertices, faces) of the top, those of the bottom).
nb::tuple shellLayers(const Mesh& mesh) {
    const ShellLayers layers = [&] {
        const nb::gil_scoped_release unlocked;
        return mesh->shellLayers();
    }();
    return nb::make_tuple(arraysOf(layers.top), arraysOf(layers.bottom));
}

// (vertices, faces, what was changed by kinds, the same in words).
template <class Id>
nb::tuple repaired(const Points& vertices, const Rows<Id, 3>& faces, const nb::dict& options) {
    const PreparingOptions preparing = preparingOptions(options);
    const Workpiece workpiece = [&] {
        const nb::gil_scoped_release unlocked;
        return Workpiece({toVectors(vertices), toTriangles(faces)}, preparing);
    }();
    const RepairReport report =
        workpiece.repair() != nullptr ? *workpiece.repair() : RepairReport();
    std::map<int, std::vector<int>> copies;
    for (const RepairReport::DuplicatedVertex& duplicated : report.duplicatedVertices) {
        copies[duplicated.vertex] = duplicated.copies;
    }
    std::vector<std::pair<int, int>> cuts;
    for (const auto& [a, b] : report.cutEdges) {
        cuts.emplace_back(a, b);
    }
    nb::dict changes;
    changes["joined_vertices"] =
        std::map<int, int>(report.joinedVertices.begin(), report.joinedVertices.end());
    changes["left_out_faces"] = report.leftOutFaces;
    changes["merged_vertices"] =
        std::map<int, int>(report.mergedVertices.begin(), report.mergedVertices.end());
    changes["removed_degenerate_faces"] = report.removedDegenerateFaces;
    changes["split_faces"] = report.splitFaces;
    changes["removed_duplicate_faces"] = report.removedDuplicateFaces;
    changes["reversed_faces"] = report.reversedFaces;
    changes["cut_edges"] = cuts;
    changes["duplicated_vertices"] = copies;
    const TriangleMesh& mesh = workpiece.mendedMesh();
    return nb::make_tuple(arrayOf(mesh.vertices), arrayOf(mesh.faces), changes, report.summary());
}

// Faces over which the mean of some values of vertices is under or over a threshold.
template <Region (*find)(const TriangleMesh&, std::span<const double>, double)>
Array facesBeside(const Mesh& mesh, const Values& values, double threshold) {
    return arrayOf(find(mesh->mesh(), {values.data(), values.shape(0)}, threshold));
}

// Of preparing it.
double preparingSeconds(const Mesh& mesh) {
    const StageSeconds seconds = mesh->seconds();
    return seconds.validate + seconds.tree + seconds.shell;
}

void bindMesh(nb::module_& module) {
    const auto view = [](auto part) {
        return viewOf<Mesh>([part](const Mesh& m) -> auto& { return m->mesh().*part; });
    };
    nb::class_<Mesh>(module, "Mesh")
        .def("__init__", makeMesh<std::int32_t>, nb::arg(), nb::arg(), nb::arg(), nb::arg().none())
        .def("__init__", makeMesh<std::int64_t>, nb::arg(), nb::arg(), nb::arg(), nb::arg().none())
        .def_prop_ro("vertices", view(&TriangleMesh::vertices))
        .def_prop_ro("faces", view(&TriangleMesh::faces))
        .def_prop_ro("mending", [](const Mesh& m) { return m->mending(); })
        .def_prop_ro("notes", [](const Mesh& m) { return m->notes(); })
        .def_prop_ro("seconds", preparingSeconds)
        .def_prop_ro("diagonal", [](const Mesh& m) { return m->diagonal(); })
        .def_prop_ro("checksum", [](const Mesh& m) { return m->checksum().crc32; })
        .def_prop_ro("components", [](const Mesh& m) { return m->componentCount(); })
        .def(
            "draw",
            draw,
            nb::arg(),
            nb::arg(),
            nb::arg().none(),
            nb::arg().none(),
            nb::arg().none(),
            nb::arg().none()
        )
        .def("field", madeField, nb::arg(), nb::arg().none(), nb::arg().none(), nb::arg().none())
        .def("project", project)
        .def("shell_layers", shellLayers);
    nb::class_<ScalarField>(module, "Field")
        .def(
            "__init__",
            [](ScalarField* place, const Values& values) {
                new (place) ScalarField(toVector(std::optional(values)));
            }
        )
        .def(
            "__reduce__",
            [](nb::handle self) {
                return nb::make_tuple(self.type(), nb::make_tuple(self.attr("values")));
            }
        )
        .def_prop_ro("values", viewOf<ScalarField>([](const ScalarField& f) -> auto& {
                         return f.values();
                     }));
    module.def("repaired", repaired<std::int32_t>);
    module.def("repaired", repaired<std::int64_t>);
    module.def("can_be_followed", [](const Values& quality) {
        return canBeFollowed({quality.data(), quality.shape(0)});
    });
    module.def("faces_under", facesBeside<facesUnder>);
    module.def("faces_over", facesBeside<facesOver>);
}

}  // namespace

NB_MODULE(_core, module) {
    registerErrors();
    bindCurve(module);
    bindMesh(module);
    bindDrawing(module);
    bindFits(module);
    bindUses(module);
    bindPieces(module);
    bindWays(module);
    bindFiles(module);
    bindPattern(module);
    module.attr("__version__") = BSPLINE_CURVE_VERSION;
}

}  // namespace bspline_curve::python
