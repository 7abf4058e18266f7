// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/simplify/operations.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace bspline_curve {
namespace {

// Pillars grow by at least this factor.
constexpr double kWorthwhile = 1.1;
// Where a step fails, this share of it is tried.
constexpr double kShorterStep = 0.4;

}  // namespace

void Thickener::run(double reach) {
    for (int pillar = 0; pillar < editor_.pillarCount(); ++pillar) {
        if (!editor_.isFrozen(pillar) && editor_.complex().hasPrisms(pillar) &&
            failed_[pillar] < editor_.changed(pillar)) {
            thicken(pillar, reach);
        }
    }
}

void Thickener::thicken(int pillar, double reach) {
    const Pillar before = editor_.pillarAt(pillar);
    const double top = (before.top - before.middle).norm();
    const double bottom = (before.bottom - before.middle).norm();
    if (kWorthwhile * std::min(top, bottom) >= reach) {
        return;
    }
    const auto along = [&](const Vec3& up, const Vec3& down, double length) -> Pillar {
        return {
            before.middle - std::max(bottom, length) * down,
            before.middle,
            before.middle + std::max(top, length) * up
        };
    };
    editor_.proposeStar(pillar);
    const Vec3 up = (before.top - before.middle) / top;
    const Vec3 down = (before.middle - before.bottom) / bottom;
    if (editor_.replaceWith(pillar, along(up, down, reach))) {
        return;
    }
    const Vec3 normal = editor_.meanNormal();
    const Vec3 around = directionAround(pillar);
    if (editor_.replaceWith(pillar, along(normal, normal, reach)) ||
        editor_.replaceWith(pillar, along(around, around, reach))) {
        return;
    }
    // Turned first, then the halves one by one as far as they go.
    if (editor_.replaceWith(pillar, along(normal, normal, 0.0))) {
        editor_.proposeStar(pillar);
    }
    lengthen(pillar, Level::Top, reach);
    lengthen(pillar, Level::Bottom, reach);
    failed_[pillar] = editor_.time();
}

void Thickener::lengthen(int pillar, Level level, double reach) {
    const Pillar before = editor_.pillarAt(pillar);
    const Vec3 half = (level == Level::Top ? before.top : before.bottom) - before.middle;
    const double now = half.norm();
    for (double wanted = reach; wanted > kWorthwhile * now;
         wanted = now + kShorterStep * (wanted - now)) {
        Pillar after = before;
        (level == Level::Top ? after.top : after.bottom) = before.middle + wanted / now * half;
        if (editor_.replaceWith(pillar, after)) {
            editor_.proposeStar(pillar);
            return;
        }
    }
}

// Mean direction of the neighbouring pillars.
Vec3 Thickener::directionAround(int pillar) const {
    const PrismComplex& complex = editor_.complex();
    Vec3 sum = Vec3::Zero();
    for (const Triangle& pillars : editor_.fresh) {
        for (const int other : pillars) {
            if (other != pillar) {
                sum += (complex.point(other, Level::Top) - complex.point(other, Level::Bottom))
                           .normalized();
            }
        }
    }
    return sum.normalized();
}

}  // namespace bspline_curve
