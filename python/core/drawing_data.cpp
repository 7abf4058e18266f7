// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/drawing_session.h"
#include "python/core/arrays.h"
#include "python/core/bindings.h"
#include "python/core/option_values.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve::python {

namespace {

/// (2, 3): where a ray begins, and its direction, of unit length.
using Ray = nb::ndarray<const double, nb::shape<2, 3>, nb::c_contig, nb::device::cpu>;

constexpr std::array kKeys{
    std::pair("add", SketchKey::Add),
    std::pair("move", SketchKey::Move),
    std::pair("next", SketchKey::Next),
    std::pair("previous", SketchKey::Previous),
    std::pair("next-curve", SketchKey::NextCurve),
    std::pair("remove", SketchKey::Remove),
    std::pair("close", SketchKey::Close),
    std::pair("new-curve", SketchKey::NewCurve),
    std::pair("kind", SketchKey::Kind),
    std::pair("undo", SketchKey::Undo),
    std::pair("redo", SketchKey::Redo),
    std::pair("cancel", SketchKey::Cancel),
};

SketchKey keyOf(const std::string& name) {
    for (const auto& [known, key] : kKeys) {
        if (name == known) {
            return key;
        }
    }
    throw nb::value_error(("no key is called " + name).c_str());
}

Pointer pointerOf(const Ray& ray, double pixel, bool isOrthographic, bool snaps, bool removes) {
    return {
        .start = Vec3(ray(0, 0), ray(0, 1), ray(0, 2)),
        .direction = Vec3(ray(1, 0), ray(1, 1), ray(1, 2)),
        .pixel = pixel,
        .isOrthographic = isOrthographic,
        .snaps = snaps,
        .removes = removes
    };
}

template <auto event>
bool forward(
    DrawingSession& session,
    const Ray& ray,
    double pixel,
    bool isOrthographic,
    bool snaps,
    bool removes
) {
    return (session.*event)(pointerOf(ray, pixel, isOrthographic, snaps, removes));
}

void makeSession(
    DrawingSession* place,
    const Mesh& mesh,
    const nb::dict& options,
    const ScalarField* field,
    const std::optional<Ids>& avoid
) {
    SessionSettings settings;
    settings.options.solver = curveOptions(options).solver;
    if (field != nullptr || avoid) {
        settings.options.guides = std::make_shared<const SketchGuides>(SketchGuides::Values{
            .field = field != nullptr ? *field : ScalarField(), .avoid = toVector(avoid)
        });
    }
    new (place) DrawingSession(mesh.workpiece, std::move(settings));
}

// (picks, points to be shown, whether it is closed, why it is not what its picks ask for).
nb::list sketchedCurves(const DrawingSession& session) {
    nb::list curves;
    for (const std::shared_ptr<SketchCurve>& curve : session.sketch().curves) {
        curves.append(
            nb::make_tuple(
                arrayOf(curve->positions()),
                arrayOf(curve->shownPoints()),
                curve->options.solver.closed,
                withRemedy(curve->problem.message, curve->problem.remedy, kRemedyWords)
            )
        );
    }
    return curves;
}

std::optional<Array> previewOf(const DrawingSession& session) {
    return session.preview() ? std::optional(arrayOf(session.preview()->polyline.points))
                             : std::nullopt;
}

}  // namespace

void bindDrawing(nb::module_& module) {
    nb::class_<DrawingSession>(module, "DrawingSession")
        .def("__init__", makeSession, nb::arg(), nb::arg(), nb::arg().none(), nb::arg().none())
        .def("press", forward<&DrawingSession::press>)
        .def("move", forward<&DrawingSession::move>)
        .def("release", forward<&DrawingSession::release>)
        .def("leave", &DrawingSession::leave)
        .def(
            "key",
            [](DrawingSession& session,
               const std::string& name,
               const Ray& ray,
               double pixel,
               bool isOrthographic,
               bool snaps) {
                return session.key(
                    keyOf(name), pointerOf(ray, pixel, isOrthographic, snaps, false)
                );
            }
        )
        .def("update", &DrawingSession::update)
        .def("settle", &DrawingSession::settle, nb::call_guard<nb::gil_scoped_release>())
        .def_prop_ro("curves", sketchedCurves)
        .def_prop_ro("preview", previewOf, nb::rv_policy::automatic)
        .def_prop_ro("active", [](const DrawingSession& s) { return s.sketch().active; })
        .def_prop_ro("selected", [](const DrawingSession& s) { return s.sketch().selected; })
        .def_prop_ro(
            "hovered",
            [](const DrawingSession& s) {
                return nb::make_tuple(s.hovered().curve, s.hovered().pick);
            }
        )
        .def_prop_ro("is_dragging", &DrawingSession::isDragging)
        .def_prop_ro("is_settled", &DrawingSession::isSettled);
}

}  // namespace bspline_curve::python
