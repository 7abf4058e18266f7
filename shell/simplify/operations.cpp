// SPDX-License-Identifier: GPL-3.0-or-later
// Operations that keep the number of prisms: longer pillars, flipped edges, pillars that move.
#include "shell/simplify/operations.h"

#include "surface/surface_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <optional>

namespace bspline_curve {
namespace {

// Flips the edge from corner k of a prism to the next.
bool flipEdge(ShellEditor& editor, const Creases& creases, int prism, std::size_t k) {
    const PrismComplex& complex = editor.complex();
    const Triangle pillars = complex.pillarsOf(prism);
    const int a = pillars[k];
    const int b = pillars[(k + 1) % 3];
    const int c = pillars[(k + 2) % 3];
    const int across = complex.prismAlong(b, a);
    if (across < 0 || creases.holdEdge(a, b)) {
        return false;
    }
    const Triangle& other = complex.pillarsOf(across);
    const int d = other[(cornerOf(other, b) + 2) % 3];
    const double now = std::min(editor.quality(pillars), editor.quality(other));
    editor.old = {prism, across};
    editor.fresh = {{c, a, d}, {d, b, c}};
    return editor.leastQuality() > kSimplifier.flipGain * now && !complex.hasEdge(c, d) &&
           editor.replace();
}

}  // namespace

// ---- Thickener ----

void Thickener::run(double length) {
    for (int pillar = 0; pillar < editor_.pillarCount(); ++pillar) {
        if (!editor_.isFrozen(pillar) && editor_.complex().hasPrisms(pillar) &&
            failed_[pillar] < editor_.changed(pillar)) {
            thicken(pillar, length);
        }
    }
}

void Thickener::thicken(int pillar, double length) {
    const Pillar before = editor_.pillarAt(pillar);
    const double top = (before.top - before.middle).norm();
    const double bottom = (before.bottom - before.middle).norm();
    if (kSimplifier.lengthGain * std::min(top, bottom) >= length) {
        return;
    }
    const auto along = [&](const Vec3& up, const Vec3& down, double atLeast) -> Pillar {
        return {
            before.middle - std::max(bottom, atLeast) * down,
            before.middle,
            before.middle + std::max(top, atLeast) * up
        };
    };
    editor_.proposeStar(pillar);
    const Vec3 up = (before.top - before.middle) / top;
    const Vec3 down = (before.middle - before.bottom) / bottom;
    if (editor_.replaceWith(pillar, along(up, down, length))) {
        return;
    }
    const Vec3 normal = editor_.meanNormal();
    const Vec3 around = directionAround(pillar);
    if (editor_.replaceWith(pillar, along(normal, normal, length)) ||
        editor_.replaceWith(pillar, along(around, around, length))) {
        return;
    }
    // Turned first, then the halves one by one as far as they go.
    if (editor_.replaceWith(pillar, along(normal, normal, 0.0))) {
        editor_.proposeStar(pillar);
    }
    lengthen(pillar, &Pillar::top, length);
    lengthen(pillar, &Pillar::bottom, length);
    failed_[pillar] = editor_.time();
}

void Thickener::lengthen(int pillar, Vec3 Pillar::* tip, double length) {
    const Pillar before = editor_.pillarAt(pillar);
    const Vec3 half = before.*tip - before.middle;
    const double now = half.norm();
    for (double wanted = length; wanted > kSimplifier.lengthGain * now;
         wanted = now + kSimplifier.shorterStep * (wanted - now)) {
        Pillar after = before;
        after.*tip = before.middle + wanted / now * half;
        if (editor_.replaceWith(pillar, after)) {
            editor_.proposeStar(pillar);
            return;
        }
    }
}

// Mean direction of the neighbouring pillars.
Vec3 Thickener::directionAround(int pillar) const {
    Vec3 sum = Vec3::Zero();
    for (const Triangle& pillars : editor_.fresh) {
        for (const int other : pillars) {
            if (other != pillar) {
                const Pillar p = editor_.pillarAt(other);
                sum += (p.top - p.bottom).normalized();
            }
        }
    }
    return sum.normalized();
}

// ---- Flips ----

void flipEdges(ShellEditor& editor, const Creases& creases) {
    for (int prism = 0; prism < editor.complex().prismIdCount(); ++prism) {
        for (std::size_t k = 0; k < 3 && editor.complex().isAlive(prism); ++k) {
            const Triangle& pillars = editor.complex().pillarsOf(prism);
            if (pillars[k] < pillars[(k + 1) % 3] && flipEdge(editor, creases, prism, k)) {
                break;
            }
        }
    }
}

// ---- Smoother ----

void PillarSmoother::run() {
    for (int pillar = 0; pillar < editor_.pillarCount(); ++pillar) {
        if (!editor_.isFrozen(pillar) && creases_.degree(pillar) == 0 &&
            editor_.complex().hasPrisms(pillar) && failed_[pillar] < editor_.changed(pillar)) {
            failed_[pillar] = editor_.time();
            move(pillar);
        }
    }
}

void PillarSmoother::move(int pillar) {
    editor_.proposeStar(pillar);
    const double now = editor_.leastQuality();
    if (now > kSimplifier.goodQuality) {
        return;
    }
    const Pillar before = editor_.pillarAt(pillar);
    Vec3 centre = Vec3::Zero();
    for (const Triangle& pillars : editor_.fresh) {
        centre += editor_.pillarAt(pillars[(cornerOf(pillars, pillar) + 1) % 3]).middle;
    }
    centre /= static_cast<double>(editor_.fresh.size());
    const Vec3 normal = editor_.meanNormal();
    const double top = (before.top - before.middle).norm();
    const double bottom = (before.bottom - before.middle).norm();
    for (const double share : {1.0, 0.5}) {
        const std::optional<Vec3> middle =
            editor_.onSurface(before.middle + share * (centre - before.middle), normal);
        if (!middle) {
            continue;
        }
        editor_.setPillar(pillar, {*middle - bottom * normal, *middle, *middle + top * normal});
        if (editor_.leastQuality() > kSimplifier.moveGain * now && editor_.replace()) {
            return;
        }
        editor_.setPillar(pillar, before);
    }
}

}  // namespace bspline_curve
