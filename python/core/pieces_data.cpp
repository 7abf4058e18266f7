// SPDX-License-Identifier: GPL-3.0-or-later
// Curves turned round, cut, joined and made longer.
#include "bspline_curve/pieces.h"
#include "python/core/arrays.h"
#include "python/core/bindings.h"
#include "python/core/python_progress.h"

#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve::python {

namespace {

// With which picks of the whole its own are, in their order.
using Piece = std::pair<DesignedCurve, std::vector<int>>;

Piece reversed(const DesignedCurve& whole) {
    std::vector<int> picks;
    Curve curve = reversedCurve(whole.curve, &picks);
    return {DesignedCurve{.curve = std::move(curve)}, std::move(picks)};
}

Piece part(const Mesh& mesh, const DesignedCurve& whole, double from, double to) {
    std::vector<int> picks;
    Curve curve = partOfCurve(*mesh.workpiece, whole.curve, from, to, &picks);
    return {DesignedCurve{.curve = std::move(curve)}, std::move(picks)};
}

std::vector<Piece> parts(
    const Mesh& mesh, const DesignedCurve& whole, const std::vector<double>& at
) {
    std::vector<std::vector<int>> picks;
    std::vector<Curve> curves = partsOfCurve(*mesh.workpiece, whole.curve, at, &picks);
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        pieces.emplace_back(DesignedCurve{.curve = std::move(curves[i])}, std::move(picks[i]));
    }
    return pieces;
}

DesignedCurve joined(
    const Mesh& mesh,
    const DesignedCurve& first,
    const DesignedCurve& second,
    bool isSmooth,
    const std::string& gap,
    const std::string& blend,
    nb::object progress
) {
    const JoinOptions options{
        .isSmooth = isSmooth, .gap = parseLength(gap, "gap"), .blend = parseLength(blend, "blend")
    };
    return PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        return mesh->finished(
            joinedCurves(*mesh.workpiece, first.curve, second.curve, options, goesOn), {}
        );
    });
}

DesignedCurve extended(
    const Mesh& mesh, const DesignedCurve& curve, double atStart, double atEnd, nb::object progress
) {
    return PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        return mesh->finished(
            extendedCurve(*mesh.workpiece, curve.curve, atStart, atEnd, goesOn), {}
        );
    });
}

}  // namespace

void bindPieces(nb::module_& module) {
    module.def("reversed", reversed);
    module.def("part", part);
    module.def("parts", parts);
    module.def(
        "joined",
        joined,
        nb::arg(),
        nb::arg(),
        nb::arg(),
        nb::arg(),
        nb::arg(),
        nb::arg(),
        nb::arg().none()
    );
    module.def("extended", extended, nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg().none());
}

}  // namespace bspline_curve::python
