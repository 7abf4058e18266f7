// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/drawing_builder.h"
#include "bspline_curve/files.h"
#include "bspline_curve/pattern.h"
#include "python/core/arrays.h"
#include "python/core/bindings.h"
#include "python/core/python_progress.h"

#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bspline_curve::python {

namespace {

using Vec2 = Eigen::Vector2d;
using Triple = std::array<double, 3>;

/// Of (name, [(key, value), ...], [children], line, [text]).
XmlElement elementOf(const nb::tuple& node) {
    XmlElement element{
        .name = nb::cast<std::string>(node[0]),
        .attributes = {},
        .children = {},
        .text = {},
        .line = nb::cast<std::size_t>(node[3])
    };
    for (const nb::handle part : nb::cast<nb::list>(node[4])) {
        element.text += nb::cast<std::string>(part);
    }
    for (const nb::handle pair : nb::cast<nb::list>(node[1])) {
        const auto words = nb::cast<nb::tuple>(pair);
        element.attributes.emplace_back(
            nb::cast<std::string>(words[0]), nb::cast<std::string>(words[1])
        );
    }
    for (const nb::handle child : nb::cast<nb::list>(node[2])) {
        element.children.push_back(elementOf(nb::cast<nb::tuple>(child)));
    }
    return element;
}

// (drawing, notes)
nb::tuple svgDrawing(const std::string& file, const nb::tuple& root) {
    DrawingFile read = drawingOfSvg(file, elementOf(root));
    return nb::make_tuple(std::move(read.drawing), read.notes);
}

// (drawing, notes)
nb::tuple dxfDrawing(
    const std::string& file, const nb::bytes& bytes, const std::vector<std::string>& layers
) {
    DrawingFile read = drawingOfDxf(file, std::string_view(bytes.c_str(), bytes.size()), layers);
    return nb::make_tuple(std::move(read.drawing), read.notes);
}

/// For each path whether it is closed, and its Bézier arcs: points and weights, none where all
/// are 1.
nb::list pathsOf(const Drawing& drawing) {
    nb::list paths;
    for (const DrawingPath& path : drawing.paths) {
        nb::list arcs;
        for (const DrawingArc& arc : path.arcs) {
            nb::list points;
            for (const Vec2& point : arc.points) {
                points.append(nb::make_tuple(point.x(), point.y()));
            }
            arcs.append(nb::make_tuple(std::move(points), nb::cast(arc.weights)));
        }
        paths.append(nb::make_tuple(path.closed, std::move(arcs)));
    }
    return paths;
}

/// Of a line of text, as path data.
Drawing textDrawing(const std::string& data) {
    Drawing drawing = drawingOfSvgPath(data);
    drawing.baseline = 0.0;
    return drawing;
}

/// Of polylines, y upwards; one whose last point is the first is closed.
Drawing polylineDrawing(const std::vector<Rows<double, 2>>& lines) {
    DrawingBuilder pen;
    for (const Rows<double, 2>& line : lines) {
        for (std::size_t i = 0; i < line.shape(0); ++i) {
            const Vec2 point(line(i, 0), line(i, 1));
            if (i == 0) {
                pen.moveTo(point);
            } else {
                pen.lineTo(point);
            }
        }
    }
    return pen.take();
}

Vec3 vectorOf(const Triple& values) {
    return {values[0], values[1], values[2]};
}

/// Where a drawing goes, and how large it is there.
struct Place {
    Triple centre{};  // where there is no curve to go along
    std::optional<Triple> up;
    const DesignedCurve* along = nullptr;
    RowLayout row;
    PatternOptions pattern;
};

Place placeOf(const nb::dict& options) {
    const auto number = [&](const char* name) { return nb::cast<double>(options[name]); };
    return {
        .centre = nb::cast<std::optional<Triple>>(options["centre"]).value_or(Triple{}),
        .up = nb::cast<std::optional<Triple>>(options["up"]),
        .along =
            options["along"].is_none() ? nullptr : nb::cast<const DesignedCurve*>(options["along"]),
        .row =
            {.scale = {.size = number("size"), .scale = number("scale")},
             .repeat = nb::cast<int>(options["repeat"]),
             .spacing = number("spacing"),
             .start = number("start"),
             .shift = number("shift")},
        .pattern = {
            .cornerAngle = number("corner_angle"),
            .tolerance = number("tolerance"),
            .smoothing = nb::cast<int>(options["smoothing"])
        }
    };
}

Pattern drawn(
    const Mesh& mesh, const Drawing& drawing, const Place& place, const Progress& goesOn
) {
    if (place.along != nullptr) {
        const SurfacePolyline& along = place.along->curve.polyline;
        return patternAlongCurve(*mesh.workpiece, drawing, along, place.row, place.pattern, goesOn);
    }
    return patternRoundPoint(
        *mesh.workpiece,
        drawing,
        vectorOf(place.centre),
        place.up ? std::optional(vectorOf(*place.up)) : std::nullopt,
        place.row.scale,
        place.pattern,
        goesOn
    );
}

// (ratio, path, copy, position)
nb::tuple tupleOf(const Distortion& distortion) {
    const Vec3& at = distortion.position;
    return nb::make_tuple(
        distortion.ratio, distortion.path, distortion.copy, Triple{at.x(), at.y(), at.z()}
    );
}

// (curves, paths, copies, tolerance, largest deviation, shortest, longest)
nb::tuple pattern(
    const Mesh& mesh, const Drawing& drawing, const nb::dict& options, nb::object progress
) {
    const Place place = placeOf(options);
    Pattern made = PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        return drawn(mesh, drawing, place, goesOn);
    });
    std::vector<DesignedCurve> curves;
    std::vector<std::int32_t> paths;
    std::vector<std::int32_t> copies;
    for (PatternCurve& each : made.curves) {
        curves.push_back(mesh->finished(std::move(each.curve), {}));
        paths.push_back(each.path);
        copies.push_back(each.copy);
    }
    return nb::make_tuple(
        std::move(curves),
        arrayOf(std::move(paths)),
        arrayOf(std::move(copies)),
        made.tolerance,
        made.largestDeviation,
        tupleOf(made.shortest),
        tupleOf(made.longest)
    );
}

}  // namespace

void bindPattern(nb::module_& module) {
    nb::class_<Drawing>(module, "Drawing")
        .def_prop_ro("path_count", [](const Drawing& drawing) { return drawing.paths.size(); })
        .def_prop_ro("paths", pathsOf);
    module.def("svg_drawing", svgDrawing);
    module.def("dxf_drawing", dxfDrawing);
    module.def("path_drawing", drawingOfSvgPath);
    module.def("text_drawing", textDrawing);
    module.def("font_or_default", [](const std::string& file) {
        return fontOrDefault(file).string();
    });
    module.def("polyline_drawing", polylineDrawing);
    module.def("pattern", pattern, nb::arg(), nb::arg(), nb::arg(), nb::arg().none());
}

}  // namespace bspline_curve::python
