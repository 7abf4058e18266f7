// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell_cell.h"
#include "solver/curve_problem.h"

namespace bspline_curve {

/// An affine function of the position in one cell.
struct AffineForm {
    Vec3 gradient = Vec3::Zero();
    double offset = 0.0;

    [[nodiscard]] double at(const Vec3& p) const { return gradient.dot(p) + offset; }
};

/// The field I(M_S(p)) in a cell.
[[nodiscard]] inline AffineForm fieldForm(const CurveProblem& problem, const ShellCell& cell) {
    AffineForm form;
    const Triangle& face = problem.base->faces[static_cast<std::size_t>(cell.prism)];
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const double value = problem.field[static_cast<std::size_t>(face[corner])];
        form.gradient += value * cell.shadowGradients[corner];
        form.offset += value * cell.shadowOffsets[corner];
    }
    return form;
}

/// How far p lies beyond the boundary in a ghost cell: 0 at the surface's boundary, 1 at the outer
/// rim of the ghosts.
[[nodiscard]] inline AffineForm beyondForm(const CurveProblem& problem, const ShellCell& cell) {
    AffineForm form;
    const Triangle& face = problem.base->faces[static_cast<std::size_t>(cell.prism)];
    for (std::size_t corner = 0; corner < 3; ++corner) {
        if (face[corner] >= problem.base->surfaceVertexCount) {
            form.gradient += cell.shadowGradients[corner];
            form.offset += cell.shadowOffsets[corner];
        }
    }
    return form;
}

}  // namespace bspline_curve
