// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/workpiece.h"
#include "text/error_messages.h"

#include <nanobind/nanobind.h>

#include <memory>
#include <optional>
#include <string>

// The parts of the module. Its Curve is a DesignedCurve, its Field a ScalarField. Vertices and
// faces are everywhere those of the mesh as the caller has it.
namespace bspline_curve::python {

/// A mesh that curves are drawn on.
struct Mesh {
    std::shared_ptr<const Workpiece> workpiece;

    const Workpiece* operator->() const { return workpiece.get(); }
};

/// What helps against an error, in words of the package.
inline constexpr RemedyWords kRemedyWords{
    .mend = "without strict=True the mesh is mended",
    .weld = "Mesh(..., weld=%) joins these components"
};

/// Makes errors of the core those of the package: InputError becomes what
/// bspline_curve._errors.input_error(code, message, elements) returns, Cancelled becomes
/// bspline_curve.Cancelled.
void registerErrors();

/// Curve: its parts as read-only arrays that share its memory, its report, and what pickling needs.
void bindCurve(nanobind::module_& module);
/// DrawingSession: events in, what is to be seen out, as arrays.
void bindDrawing(nanobind::module_& module);
/// Curves along lines, and boundaries of labels.
void bindFits(nanobind::module_& module);
/// Drawings, and the function that carries them to a mesh.
void bindPattern(nanobind::module_& module);
/// Curves turned round, cut, joined and made longer.
void bindPieces(nanobind::module_& module);
/// The formats of curves' files, and the reader of meshes' files.
void bindFiles(nanobind::module_& module);
/// Lines from elsewhere on a mesh, shortest ways, distances along it.
void bindWays(nanobind::module_& module);
/// Imprint, with cuts and parts, and the functions on what lies at a distance from a curve.
void bindUses(nanobind::module_& module);

}  // namespace bspline_curve::python
