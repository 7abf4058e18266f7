// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

// By how much the projection along fibres stretches, from the pillars of a prism alone.
namespace bspline_curve {

/// Norm of the derivative of the projection, at most: a lifted point is rounded by 2^-53 of its
/// coordinates, so it comes back within 1e-12 (see ShellCell::project).
inline constexpr double kMostStretch = 1000.0;

/// Products of the ways along which two coordinates of a prism grow by 1.
struct Gram {
    double first = 0.0, mixed = 0.0, second = 0.0;

    [[nodiscard]] double trace() const { return first + second; }

    [[nodiscard]] double determinant() const { return first * second - mixed * mixed; }
};

/// Of the ways from a corner on the pillar of slot 0 to corners on those of slots 1 and 2, in the
/// plane of these.
[[nodiscard]] inline Gram gramOf(const Vec3& first, const Vec3& second) {
    return {first.squaredNorm(), first.dot(second), second.squaredNorm()};
}

/// The same across a fibre of unit length.
[[nodiscard]] inline Gram gramOf(const Vec3& first, const Vec3& second, const Vec3& fibre) {
    const double along1 = first.dot(fibre);
    const double along2 = second.dot(fibre);
    return {
        first.squaredNorm() - along1 * along1,
        first.dot(second) - along1 * along2,
        second.squaredNorm() - along2 * along2
    };
}

/// By how much, at most, the way along the fibres from tetrahedra of a prism, by their products
/// across these, to a plane with those of `to` stretches.
[[nodiscard]] inline double largestStretch(std::span<const Gram> grams, const Gram& to) {
    double largest = 0.0;
    for (const Gram& from : grams) {
        const double squared =
            (to.first * from.second - 2.0 * to.mixed * from.mixed + to.second * from.first) /
            from.determinant();
        if (!std::isfinite(squared) || squared < 0.0) {
            return std::numeric_limits<double>::infinity();
        }
        largest = std::max(largest, squared);
    }
    return std::sqrt(largest);
}

/// Unit directions of the half pillars of a slab, 0 above the middle and 1 below it, upwards.
[[nodiscard]] inline std::array<Vec3, 3> fibresOf(
    const std::array<Pillar, 3>& pillars, std::size_t slab
) {
    const Vec3 Pillar::* const tip = slab == 0 ? &Pillar::top : &Pillar::bottom;
    const double up = slab == 0 ? 1.0 : -1.0;
    std::array<Vec3, 3> fibres;
    for (std::size_t k = 0; k < 3; ++k) {
        fibres[k] = up * (pillars[k].*tip - pillars[k].middle).normalized();
    }
    return fibres;
}

/// Of the tetrahedra of a slab, each by the half pillar that it holds; it has a corner on each
/// pillar. `pillars`: by slot.
[[nodiscard]] inline std::array<Gram, 3> gramsOf(
    const std::array<Pillar, 3>& pillars, const std::array<Vec3, 3>& fibres, std::size_t slab
) {
    const Vec3 Pillar::* const tip = slab == 0 ? &Pillar::top : &Pillar::bottom;
    const auto& [a, b, c] = pillars;
    const Vec3& shared = a.middle;
    return {
        gramOf(b.*tip - shared, c.*tip - shared, fibres[0]),
        gramOf(b.middle - shared, c.*tip - shared, fibres[1]),
        gramOf(b.middle - shared, c.middle - shared, fibres[2])
    };
}

}  // namespace bspline_curve
