// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/imprint.h"
#include "bspline_curve/lines.h"
#include "bspline_curve/offset.h"
#include "bspline_curve/parts.h"
#include "python/core/arrays.h"
#include "python/core/bindings.h"
#include "python/core/python_progress.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace bspline_curve::python {

namespace {

/// `stroke`: a width; 0: the curves themselves.
Imprint imprinted(
    const Mesh& mesh,
    const std::vector<const DesignedCurve*>& curves,
    double snap,
    double stroke,
    nb::object progress
) {
    std::vector<SurfacePolyline> lines;
    for (const DesignedCurve* drawn : curves) {
        lines.push_back(drawn->curve.polyline);
    }
    return PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        const ImprintOptions options{.snap = snap};
        return stroke > 0.0 ? strokesOn(*mesh.workpiece, lines, stroke, options, goesOn)
                            : imprintOn(*mesh.workpiece, lines, options, goesOn);
    });
}

nb::list curvesOf(const Imprint& imprint) {
    nb::list result;
    for (const ImprintedCurve& curve : imprint.mesh->curves) {
        result.append(arrayOf(curve.vertices));
    }
    return result;
}

// [(area, perimeter, centroid, euler) of each part].
nb::list figuresOf(const Imprint& imprint) {
    nb::list figures;
    for (const MeshPart& part : imprint.parts.parts) {
        const Vec3& centre = part.centroid;
        figures.append(
            nb::make_tuple(
                part.area,
                part.perimeter,
                nb::make_tuple(centre.x(), centre.y(), centre.z()),
                part.euler
            )
        );
    }
    return figures;
}

/// `seeds`: three coordinates of each.
std::optional<PartChoice> choiceOf(
    const std::optional<std::string>& which, const std::vector<double>& seeds, bool dropUntouched
) {
    using Which = PartChoice::Which;
    if (!which) {
        return std::nullopt;
    }
    PartChoice choice{
        .which = *which == "largest"    ? Which::Largest
                 : *which == "smallest" ? Which::Smallest
                 : *which == "inside"   ? Which::Inside
                 : *which == "outside"  ? Which::Outside
                                        : Which::Seeds,
        .seeds = {},
        .dropUntouched = dropUntouched
    };
    for (std::size_t i = 0; i + 2 < seeds.size(); i += 3) {
        choice.seeds.emplace_back(seeds[i], seeds[i + 1], seeds[i + 2]);
    }
    return choice;
}

/// For each vertex of a mesh that of the imprint; -1: it is new, also where a relief has a profile.
std::vector<int> sourcesIn(const Imprint& imprint, const MadeMesh& made) {
    std::vector<int> sources = made.parts().source;
    if (&made.imprinted() == imprint.mesh.get()) {
        return sources;
    }
    const std::vector<Vec3>& before = imprint.mesh->mesh.vertices;
    const auto inputCount = static_cast<int>(before.size() - imprint.mesh->newVertices.size());
    std::map<std::array<double, 3>, int> onCurves;
    for (auto v = static_cast<std::size_t>(inputCount); v < before.size(); ++v) {
        onCurves.try_emplace({before[v].x(), before[v].y(), before[v].z()}, static_cast<int>(v));
    }
    for (int& source : sources) {
        if (source >= inputCount) {
            const Vec3& place = made.imprinted().mesh.vertices[source];
            const auto found = onCurves.find({place.x(), place.y(), place.z()});
            source = found == onCurves.end() ? -1 : found->second;
        }
    }
    return sources;
}

/// Vertices, faces, sources and labels.
nb::tuple arraysOf(const Imprint& imprint, const MadeMesh& mesh) {
    const FilledParts& made = mesh.parts();
    return nb::make_tuple(
        arrayOf(made.mesh.vertices),
        arrayOf(made.mesh.faces),
        arrayOf(sourcesIn(imprint, mesh)),
        arrayOf(made.labels)
    );
}

/// Of a mesh that is in one piece; and notes.
nb::tuple arraysAndNotes(const Imprint& imprint, const CutMeshes& cut) {
    return nb::make_tuple(arraysOf(imprint, cut.pieces.front().mesh), cut.notes);
}

/// "flat" or "smooth"; else none.
std::optional<FillShape> fillOf(const std::string& word) {
    if (word == "none") {
        return std::nullopt;
    }
    return word == "flat" ? FillShape::Flat : FillShape::Smooth;
}

/// A word; coordinates of seeds; whether parts that no curve touches are dropped.
using PartsTuple = std::tuple<std::optional<std::string>, std::vector<double>, bool>;
/// Height; profile; its width.
using ReliefTuple = std::tuple<double, std::string, double>;
/// Length; direction, empty: none; height.
using BaseTuple = std::tuple<double, std::vector<double>, std::optional<double>>;

// ((vertices, faces, imprinted vertex of each vertex, part of each face), notes); -1: new.
nb::tuple cutTuple(
    const Imprint& imprint,
    const PartsTuple& parts,
    const std::string& fill,
    const ReliefTuple& relief,
    double thickness,
    const std::optional<BaseTuple>& base,
    nb::object progress
) {
    CutChoice choice;
    choice.keep = std::apply(choiceOf, parts);
    const auto& [raised, profile, profileWidth] = relief;
    choice.relief = raised;
    choice.profile = profile == "ramp"    ? ReliefProfile::Ramp
                     : profile == "round" ? ReliefProfile::Round
                                          : ReliefProfile::Step;
    choice.profileWidth = profileWidth;
    choice.thickness = thickness;
    if (base) {
        const auto& [length, direction, height] = *base;
        choice.base = PartBase{.length = length, .direction = std::nullopt, .height = height};
        if (!direction.empty()) {
            choice.base->direction = Vec3(direction.at(0), direction.at(1), direction.at(2));
        }
    }
    choice.fill = fillOf(fill);
    const CutMeshes cut = PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        return cutOn(imprint, choice, goesOn);
    });
    return arraysAndNotes(imprint, cut);
}

/// Each part at curves as arrays; and notes.
nb::tuple splitTuple(const Imprint& imprint, const std::string& fill, nb::object progress) {
    const CutMeshes cut = PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        return cutOn(imprint, {.split = true, .fill = fillOf(fill)}, goesOn);
    });
    nb::list pieces;
    for (const CutMeshes::Piece& piece : cut.pieces) {
        pieces.append(arraysOf(imprint, piece.mesh));
    }
    return nb::make_tuple(pieces, cut.notes);
}

/// The mesh with holes closed, and notes. `shape`: "flat" or "smooth"; `seed`: none, or a point.
nb::tuple filledTuple(
    const Imprint& imprint,
    const std::string& shape,
    double mostLength,
    int mostEdges,
    const std::vector<double>& seed,
    nb::object progress
) {
    HoleChoice choice{.mostLength = mostLength, .mostEdges = mostEdges};
    if (!seed.empty()) {
        choice.seed = Vec3(seed.at(0), seed.at(1), seed.at(2));
    }
    const CutMeshes filled = PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        const FillShape fill = shape == "flat" ? FillShape::Flat : FillShape::Smooth;
        return holesFilled(imprint, choice, fill, goesOn);
    });
    return arraysAndNotes(imprint, filled);
}

std::vector<std::string> segmentNotes(const Imprint& imprint) {
    const nb::gil_scoped_release unlocked;
    return segmentsOf(imprint, false).notes;
}

OffsetOptions optionsOf(double distance, const std::string& side) {
    return {
        .distance = distance,
        .sides = side == "left"    ? OffsetSides::Left
                 : side == "right" ? OffsetSides::Right
                                   : OffsetSides::Both
    };
}

/// With the largest deviation of each, in distances.
std::vector<std::pair<DesignedCurve, double>> curvesBeside(
    const Mesh& mesh,
    const DesignedCurve& drawn,
    double distance,
    const std::string& side,
    nb::object progress
) {
    OffsetLines lines = PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        return linesBeside(
            *mesh.workpiece, {&drawn.curve.polyline, 1}, optionsOf(distance, side), false, goesOn
        );
    });
    std::vector<std::pair<DesignedCurve, double>> result;
    for (auto& [fitted, of] : lines.pieces) {
        Curve curve;
        curve.polyline = std::move(fitted.line);
        curve.spline = std::move(fitted.spline);
        curve.report.usable = true;
        result.emplace_back(DesignedCurve{.curve = std::move(curve)}, fitted.deviation);
    }
    return result;
}

Array facesNear(
    const Mesh& mesh,
    const DesignedCurve& drawn,
    double distance,
    const std::string& side,
    nb::object progress
) {
    const auto within = PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        return facesWithin(
            *mesh.workpiece, drawn.curve.polyline, optionsOf(distance, side), goesOn
        );
    });
    return arrayOf(std::vector<std::uint8_t>(within.begin(), within.end()));
}

/// Points, places, frames and curvatures at distances along a curve.
nb::dict pointsAlong(
    const Mesh& mesh, const DesignedCurve& drawn, const std::vector<double>& distances
) {
    const std::vector<CurvePoint> points =
        CurvePoints(mesh->mesh()).at(drawn.curve.polyline, &drawn.curve.spline, distances);
    std::vector<SurfacePoint> places;
    for (const CurvePoint& point : points) {
        places.push_back(point.place);
    }
    const auto columnOf = [&](auto part) {
        std::vector<std::decay_t<decltype(points.front().*part)>> column;
        for (const CurvePoint& point : points) {
            column.push_back(point.*part);
        }
        return arrayOf(std::move(column));
    };
    nb::dict columns;
    columns["points"] = columnOf(&CurvePoint::position);
    columns["places"] = placesOf(places);
    columns["distances"] = columnOf(&CurvePoint::distance);
    columns["tangents"] = columnOf(&CurvePoint::tangent);
    columns["normals"] = columnOf(&CurvePoint::normal);
    columns["left"] = columnOf(&CurvePoint::left);
    columns["curvature"] = columnOf(&CurvePoint::curvature);
    columns["normal_curvature"] = columnOf(&CurvePoint::normalCurvature);
    columns["geodesic_curvature"] = columnOf(&CurvePoint::geodesicCurvature);
    return columns;
}

}  // namespace

void bindUses(nb::module_& module) {
    const auto view = [](auto part) {
        return viewOf<Imprint>([part](const Imprint& i) -> auto& { return (*i.mesh).*part; });
    };
    const auto mesh = [](auto part) {
        return viewOf<Imprint>([part](const Imprint& i) -> auto& { return i.mesh->mesh.*part; });
    };
    module.def("points_along", pointsAlong);
    nb::class_<Imprint>(module, "Imprint")
        .def_prop_ro("vertices", mesh(&TriangleMesh::vertices))
        .def_prop_ro("faces", mesh(&TriangleMesh::faces))
        .def_prop_ro("parents", view(&ImprintedMesh::parents))
        .def_prop_ro("crossings", view(&ImprintedMesh::crossings))
        .def_prop_ro("labels", viewOf<Imprint>([](const Imprint& i) -> auto& {
                         return i.parts.labels;
                     }))
        .def_prop_ro("curves", curvesOf)
        .def_prop_ro("places", [](const Imprint& i) { return placesOf(i.mesh->newVertices); })
        .def_prop_ro("largest_move", [](const Imprint& i) { return i.mesh->largestMove; })
        .def_prop_ro("figures", figuresOf)
        .def_prop_ro("segment_notes", segmentNotes)
        .def(
            "cut",
            cutTuple,
            nb::arg("parts"),
            nb::arg("fill") = "none",
            nb::arg("relief") = ReliefTuple(0.0, "step", 0.0),
            nb::arg("thickness") = 0.0,
            nb::arg("base") = nb::none(),
            nb::arg("progress") = nb::none()
        )
        .def("split", splitTuple, nb::arg("fill"), nb::arg("progress").none())
        .def(
            "fill_holes",
            filledTuple,
            nb::arg("shape"),
            nb::arg("max_length"),
            nb::arg("max_edges"),
            nb::arg("seed"),
            nb::arg("progress").none()
        );
    const auto define = [&](const char* name, auto* function) {
        module.def(name, function, nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg().none());
    };
    define("imprint", imprinted);
    define("offset", curvesBeside);
    define("faces_within", facesNear);
}

}  // namespace bspline_curve::python
