// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "projection/fibre_projector.h"
#include "shell/shell_cell.h"
#include "solver/curve_problem.h"
#include "solver/energy_weights.h"

#include <array>
#include <cstddef>

namespace bspline_curve {

/// What terms of the energy see beneath the curve, in one cell of the shell. A ground has points,
/// and functions that are linear over its face, which are told by their values at the corners.
struct CellGround {
    using Point = Vec3;
    using Linear = AffineForm;  ///< the shadow is affine in a cell

    const CurveProblem& problem;
    const EnergyWeights& weights;
    const ShellCell& cell;
    double heightScale;  ///< the paper's eta: heights count this much of their value

    [[nodiscard]] int face() const { return cell.face; }

    [[nodiscard]] AffineForm linear(const std::array<double, 3>& corners) const {
        AffineForm form;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            form += corners[corner] * cell.shadowForm(corner);
        }
        return form;
    }
};

[[nodiscard]] inline Vec3 gradientAt(const AffineForm& form, const Vec3& /*p*/) {
    return form.gradient;
}

/// A sample of the curve with its foot.
struct FootSample {
    const FootPoint& foot;
    const FootFrame& frame;
    double turning;  ///< share of what the height's own second derivative adds
};

/// A function that is linear over the face of a foot.
struct CornerValues {
    std::array<double, 3> values;

    [[nodiscard]] double at(const FootSample& sample) const {
        const Vec3 barycentric = sample.foot.barycentric();
        return barycentric[0] * values[0] + barycentric[1] * values[1] + barycentric[2] * values[2];
    }
};

[[nodiscard]] inline Vec3 gradientAt(const CornerValues& form, const FootSample& sample) {
    return (form.values[1] - form.values[0]) * sample.frame.u +
           (form.values[2] - form.values[0]) * sample.frame.v;
}

/// The same of samples whose feet lie in one face. Second derivatives of the foot are left out but
/// for those of the height.
struct FootGround {
    using Point = FootSample;
    using Linear = CornerValues;

    const CurveProblem& problem;
    const EnergyWeights& weights;
    double heightUnit;  ///< in which heights count
    int footFace;

    [[nodiscard]] int face() const { return footFace; }

    [[nodiscard]] CornerValues linear(const std::array<double, 3>& corners) const {
        return {corners};
    }
};

/// Values of a field over the vertices, or what else is known there, at the corners of a face.
template <class Ground, class Value>
[[nodiscard]] std::array<double, 3> atCorners(const Ground& ground, const Value& value) {
    const Triangle& corners = ground.problem.extended->faces[ground.face()];
    return {value(corners[0]), value(corners[1]), value(corners[2])};
}

/// How far a point lies beyond the boundary over a ghost: 0 at the boundary, 1 at the outer rim.
template <class Ground>
[[nodiscard]] Ground::Linear beyondOn(const Ground& ground) {
    return ground.linear(atCorners(ground, [&](int v) {
        return v >= ground.problem.extended->surfaceVertexCount ? 1.0 : 0.0;
    }));
}

template <class Ground>
[[nodiscard]] bool isGhost(const Ground& ground) {
    return ground.face() >= ground.problem.extended->surfaceFaceCount;
}

}  // namespace bspline_curve
