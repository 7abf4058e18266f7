// SPDX-License-Identifier: GPL-3.0-or-later
// Simplified shells: fibres at random, and how often each meets the surface.
#include "shell/check/checked_surface.h"
#include "surface/predicates.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <random>

namespace bspline_curve {
namespace {

// From bottom over the middle to the top: three pieces in each slab.
using Fibre = std::array<Vec3, 7>;

// How often a fibre through an edge or a vertex of the surface is replaced by another one.
constexpr int kMaxTries = 16;

// A uniform number in (0, 1); the distributions of <random> differ between libraries.
double uniform(std::mt19937_64& engine) {
    return (static_cast<double>(engine() >> 12U) + 0.5) * 0x1p-52;
}

Fibre fibreOf(const CheckedShell& shell, int prism, const std::array<double, 3>& beta) {
    const auto pillar = [&](std::size_t slot) {
        return shell.points.pillar(shell.prism(prism).pillars[slot]);
    };
    Fibre fibre;
    fibre[3].setZero();
    for (std::size_t slot = 0; slot < 3; ++slot) {
        fibre[3] += beta[slot] * pillar(slot).middle;
    }
    // In each tetrahedron the fibre runs along the half pillar there, whose slot is unlike in the
    // three of a slab; it passes them in their order.
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t slot = 2 - i;
        const Pillar p = pillar(slot);
        fibre[4 + i] = fibre[3 + i] + beta[slot] * (p.top - p.middle);
        fibre[2 - i] = fibre[3 - i] + beta[slot] * (p.bottom - p.middle);
    }
    return fibre;
}

// Whether a segment passes through a face; nothing where it meets an edge of it. A point in the
// plane of the face counts as above it, so that the next segment agrees.
std::optional<bool> passes(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& face) {
    const bool startsAbove = orientationSign(face[0], face[1], face[2], p) >= 0;
    const bool endsAbove = orientationSign(face[0], face[1], face[2], q) >= 0;
    if (startsAbove == endsAbove) {
        return false;
    }
    const int side0 = orientationSign(p, q, face[0], face[1]);
    const int side1 = orientationSign(p, q, face[1], face[2]);
    const int side2 = orientationSign(p, q, face[2], face[0]);
    if (side0 * side1 < 0 || side1 * side2 < 0 || side2 * side0 < 0) {
        return false;
    }
    if (side0 == 0 || side1 == 0 || side2 == 0) {
        return std::nullopt;
    }
    return true;
}

// How often a fibre meets the surface; nothing where it meets an edge.
std::optional<int> countCrossings(
    const CheckedShell& shell, const CheckedSurface& surface, const Fibre& fibre
) {
    int count = 0;
    bool isDegenerate = false;
    for (std::size_t i = 0; i + 1 < fibre.size(); ++i) {
        const auto segment = std::span(fibre).subspan(i, 2);
        surface.forEachNear(boxOf(segment), [&](int face) {
            const std::optional<bool> isCrossed =
                passes(segment[0], segment[1], cornersOf(shell.extended, face));
            isDegenerate = isDegenerate || !isCrossed.has_value();
            count += isCrossed.value_or(false) ? 1 : 0;
        });
    }
    return isDegenerate ? std::nullopt : std::optional(count);
}

// Whether a fibre drawn at random meets the surface as it should.
bool fibreHolds(
    const CheckedShell& shell,
    const CheckedSurface& surface,
    int prism,
    bool mayMiss,
    std::mt19937_64& engine
) {
    for (int i = 0; i < kMaxTries; ++i) {
        const double root = std::sqrt(uniform(engine));
        const double share = uniform(engine);
        const std::array<double, 3> beta = {1.0 - root, root * (1.0 - share), root * share};
        const auto count = countCrossings(shell, surface, fibreOf(shell, prism, beta));
        if (count.has_value()) {
            return *count == 1 || (*count == 0 && mayMiss);
        }
    }
    return false;
}

}  // namespace

void checkFibres(
    const CheckedShell& shell,
    const CheckedSurface& surface,
    const std::vector<char>& hasBorder,
    Violations violations
) {
    std::mt19937_64 engine(shell.options.seed);
    for (int prism = 0; prism < shell.prismCount(); ++prism) {
        bool holds = true;
        for (int i = 0; i < shell.options.fibresPerPrism && holds; ++i) {
            holds = fibreHolds(shell, surface, prism, hasBorder[prism] != 0, engine);
        }
        if (!holds) {
            violations.add({prism});
        }
    }
}

}  // namespace bspline_curve
