// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

namespace bspline_curve {

/// An affine function of the position.
struct AffineForm {
    Vec3 gradient = Vec3::Zero();
    double offset = 0.0;

    [[nodiscard]] double at(const Vec3& p) const { return gradient.dot(p) + offset; }

    AffineForm& operator+=(const AffineForm& other) {
        gradient += other.gradient;
        offset += other.offset;
        return *this;
    }

    friend AffineForm operator+(AffineForm a, const AffineForm& b) { return a += b; }

    friend AffineForm operator-(const AffineForm& a, const AffineForm& b) {
        return {a.gradient - b.gradient, a.offset - b.offset};
    }

    friend AffineForm operator*(double scale, const AffineForm& form) {
        return {scale * form.gradient, scale * form.offset};
    }
};

}  // namespace bspline_curve
